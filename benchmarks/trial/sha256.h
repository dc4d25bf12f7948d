#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace voronaut {

// SHA-256 (FIPS 180-4) of the bytes as 64 lower-case hexadecimal digits. O(bytes).
std::string sha256_hex(std::string_view bytes);

// The same of bytes that come piece by piece.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  void add(std::string_view bytes);
  std::string hex();  // of all that was added; once

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace voronaut
