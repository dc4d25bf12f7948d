#include "voronaut/environments/random.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include <sleef.h>

namespace voronaut {
namespace {

// The finaliser of splitmix64: Steele, Lea, Flood, https://doi.org/10.1145/2714064.2660195.
std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

// FNV-1a, draft-eastlake-fnv.
class Fnv1a {
 public:
  void add(std::uint8_t byte) { hash_ = (hash_ ^ byte) * 0x100000001b3U; }
  void add(std::uint64_t value) {
    for (int shift = 0; shift < 64; shift += 8) add(static_cast<std::uint8_t>(value >> shift));
  }
  void add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    for (const char c : text) add(static_cast<std::uint8_t>(c));
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

}  // namespace

Random::Random(std::uint64_t seed) {
  for (std::uint64_t& word : state_) word = mix(seed += 0x9e3779b97f4a7c15U);
}

std::uint64_t Random::next() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Random::uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

double Random::uniform(double lo, double hi) {
  return std::clamp(lo + (hi - lo) * uniform(), lo, hi);
}

std::uint64_t Random::below(std::uint64_t bound) {
  const std::uint64_t incomplete = (0 - bound) % bound;  // 2^64 mod bound
  std::uint64_t drawn = next();
  while (drawn < incomplete) drawn = next();
  return drawn % bound;
}

double Random::normal() {
  const double radius = std::sqrt(-2.0 * Sleef_cinz_logd1_u10purec(1.0 - uniform()));
  return radius * Sleef_cinz_sincosd1_u10purec(2.0 * std::numbers::pi * uniform()).y;
}

std::uint64_t derive_seed(std::uint64_t seed, std::initializer_list<std::string_view> names,
                          std::uint64_t index) {
  Fnv1a hash;
  hash.add(seed);
  for (const std::string_view name : names) hash.add(name);
  hash.add(index);
  return std::max<std::uint64_t>(mix(hash.value()) >> 2, 1);
}

}  // namespace voronaut
