#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace voronaut {

// A file of the MCAP format, version 0 (https://mcap.dev/spec), in memory: header, schemas,
// channels and messages one after another, no chunks, no compression, no summary; checksums are
// left out (0), as the format allows.
class McapWriter {
 public:
  explicit McapWriter(std::string_view library);

  // Both return the id of what they add, from 1.
  std::uint16_t add_schema(std::string_view name, std::string_view json_schema);
  std::uint16_t add_json_channel(std::uint16_t schema, std::string_view topic);
  void add_message(std::uint16_t channel, std::uint64_t time_ns, std::string_view json);

  // Ends the file; nothing may follow.
  std::string finish() &&;

 private:
  void add_record(std::uint8_t opcode, std::string_view content);

  std::string bytes_;
  std::uint16_t schemas_ = 0;
  std::uint16_t channels_ = 0;
  std::uint32_t messages_ = 0;
};

}  // namespace voronaut
