#include "voronaut/benchmarks/runner/packed_trial.h"

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <type_traits>

namespace voronaut {

namespace {

class Packer {
 public:
  std::string bytes;

  void operator()(const char*, const std::string& value, ColumnKind) { text(value); }
  void operator()(const char*, const std::int64_t& value, ColumnKind) {
    word(static_cast<std::uint64_t>(value));
  }
  void operator()(const char*, const double& value, ColumnKind) {
    word(std::bit_cast<std::uint64_t>(value));
  }
  void operator()(const char*, const Outcome& value, ColumnKind) { text(to_string(value)); }

  void text(std::string_view value) {
    word(value.size());
    bytes += value;
  }

 private:
  void word(std::uint64_t value) {
    for (unsigned int shift = 0; shift < 64; shift += 8) {
      bytes += static_cast<char>((value >> shift) & 0xffU);
    }
  }
};

class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  void operator()(const char*, std::string& value, ColumnKind) { value = text(); }
  void operator()(const char*, std::int64_t& value, ColumnKind) {
    value = static_cast<std::int64_t>(word());
  }
  void operator()(const char*, double& value, ColumnKind) { value = std::bit_cast<double>(word()); }
  void operator()(const char*, Outcome& value, ColumnKind) { value = outcome_from_string(text()); }

  std::string text() { return std::string(take(word())); }
  bool at_end() const { return rest_.empty(); }

 private:
  std::uint64_t word() {
    const std::string_view bytes = take(8);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      value |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    }
    return value;
  }

  std::string_view take(std::uint64_t size) {
    if (size > rest_.size()) throw std::invalid_argument("a packed trial is cut short");
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  std::string_view rest_;
};

}  // namespace

std::string pack(const PackedTrial& trial) {
  Packer packer;
  trial.record.visit(packer);
  packer.text(trial.trace_blob);
  return std::move(packer.bytes);
}

PackedTrial unpack(std::string_view bytes) {
  PackedTrial trial;
  Unpacker unpacker(bytes);
  trial.record.visit(unpacker);
  trial.trace_blob = unpacker.text();
  if (!unpacker.at_end()) throw std::invalid_argument("a packed trial has bytes left over");
  return trial;
}

}  // namespace voronaut
