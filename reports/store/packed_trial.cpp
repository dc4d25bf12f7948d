#include "voronaut/reports/store/packed_trial.h"

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <type_traits>

#include "voronaut/reports/record_columns.h"

namespace voronaut {

namespace {

class Packer {
 public:
  std::string bytes;

  void operator()(const RecordColumn&, const std::string& value) { text(value); }
  void operator()(const RecordColumn&, const std::int64_t& value) {
    word(static_cast<std::uint64_t>(value));
  }
  void operator()(const RecordColumn&, const double& value) {
    word(std::bit_cast<std::uint64_t>(value));
  }
  void operator()(const RecordColumn&, const Outcome& value) { text(to_string(value)); }

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

  void operator()(const RecordColumn&, std::string& value) { value = text(); }
  void operator()(const RecordColumn&, std::int64_t& value) {
    value = static_cast<std::int64_t>(word());
  }
  void operator()(const RecordColumn&, double& value) { value = std::bit_cast<double>(word()); }
  void operator()(const RecordColumn&, Outcome& value) { value = outcome_from_string(text()); }

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
  visit_columns(trial.record, packer);
  packer.text(trial.trace_blob);
  return std::move(packer.bytes);
}

PackedTrial unpack(std::string_view bytes) {
  PackedTrial trial;
  Unpacker unpacker(bytes);
  visit_columns(trial.record, unpacker);
  trial.trace_blob = unpacker.text();
  if (!unpacker.at_end()) throw std::invalid_argument("a packed trial has bytes left over");
  return trial;
}

}  // namespace voronaut
