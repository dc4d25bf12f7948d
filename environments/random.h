#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>

// Random numbers that are the same everywhere: the distributions of the standard library differ
// between implementations, so worlds and trials draw from these instead.
namespace voronaut {

// xoshiro256** of Blackman and Vigna, "Scrambled Linear Pseudorandom Number Generators", ACM TOMS
// 47(4), 2021, https://doi.org/10.1145/3460772, its state filled by splitmix64 as they advise.
// Every call is O(1). A Random is passed by reference to whatever draws from it; it is never
// global.
class Random {
 public:
  explicit Random(std::uint64_t seed);

  std::uint64_t next();
  double uniform();                      // in [0, 1), a multiple of 2^-53
  double uniform(double lo, double hi);  // in [lo, hi]; lo <= hi
  // In [0, bound) without bias: values of an incomplete last interval are drawn again. bound >= 1.
  std::uint64_t below(std::uint64_t bound);
  // Mean 0, variance 1: Box and Muller, https://doi.org/10.1214/aoms/1177706645, with SLEEF's log
  // and sincos. Two uniforms for each number; nothing is kept back, so the state is all there is.
  double normal();

 private:
  std::array<std::uint64_t, 4> state_;
};

// A seed for one named thing, derived from the seed of the whole. FNV-1a (64 bit) runs over: `seed`
// as 8 bytes, each name as its length (8 bytes) and its characters, `index` as 8 bytes, all little
// endian; then the splitmix64 finaliser, whose upper 62 bits are the result (0 becomes 1). So it is
// in [1, 2^62): some consumers refuse 0, and signed 64-bit columns hold it.
std::uint64_t derive_seed(std::uint64_t seed, std::initializer_list<std::string_view> names,
                          std::uint64_t index);

}  // namespace voronaut
