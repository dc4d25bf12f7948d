#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace voronaut {

// What is finished and not in the database yet: a file beside it with one frame for each trial or
// world, written by one call and never synchronised. It outlives the process, however that ends,
// though not a loss of power. Frames: kind (1 byte), length of the payload (8 bytes), CRC-32 of the
// payload (4 bytes), both little endian, payload.
class PendingFile {
 public:
  enum class Kind : char { trial = 'T', world = 'W' };
  struct Frame {
    Kind kind;
    std::string payload;
  };

  explicit PendingFile(std::filesystem::path file) : file_(std::move(file)) {}
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile();  // leaves the file as it is

  // Makes the file with the first frame, in place of what is there. Throws StoreError that names
  // it.
  void append(Kind kind, std::string_view payload);
  // Deletes the file.
  void clear();

  // The whole frames of a file, up to one that was cut short or is damaged; none if it is not
  // there.
  static std::vector<Frame> read(const std::filesystem::path& file);

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path file_;
  int fd_ = -1;
  std::int64_t size_ = 0;
};

}  // namespace voronaut
