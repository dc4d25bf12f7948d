#include "voronaut/reports/export/mcap_writer.h"

#include <utility>

namespace voronaut {
namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);

enum Opcode : std::uint8_t {
  op_header = 0x01,
  op_footer = 0x02,
  op_schema = 0x03,
  op_channel = 0x04,
  op_message = 0x05,
  op_data_end = 0x0f,
};

// Little endian.
template <class Whole>
void put(std::string& bytes, Whole value) {
  for (std::size_t i = 0; i < sizeof value; ++i)
    bytes += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
}

void put_text(std::string& bytes, std::string_view text) {
  put(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}

}  // namespace

McapWriter::McapWriter(std::string_view library) : bytes_(kMagic) {
  std::string content;
  put_text(content, "");  // no profile
  put_text(content, library);
  add_record(op_header, content);
}

std::uint16_t McapWriter::add_schema(std::string_view name, std::string_view json_schema) {
  std::string content;
  put(content, ++schemas_);
  put_text(content, name);
  put_text(content, "jsonschema");
  put_text(content, json_schema);
  add_record(op_schema, content);
  return schemas_;
}

std::uint16_t McapWriter::add_json_channel(std::uint16_t schema, std::string_view topic) {
  std::string content;
  put(content, ++channels_);
  put(content, schema);
  put_text(content, topic);
  put_text(content, "json");
  put(content, std::uint32_t{0});  // no metadata
  add_record(op_channel, content);
  return channels_;
}

void McapWriter::add_message(std::uint16_t channel, std::uint64_t time_ns, std::string_view json) {
  std::string content;
  put(content, channel);
  put(content, messages_++);
  put(content, time_ns);  // logged
  put(content, time_ns);  // published
  content += json;
  add_record(op_message, content);
}

std::string McapWriter::finish() && {
  std::string end;
  put(end, std::uint32_t{0});
  add_record(op_data_end, end);
  std::string footer;
  put(footer, std::uint64_t{0});  // no summary
  put(footer, std::uint64_t{0});
  put(footer, std::uint32_t{0});
  add_record(op_footer, footer);
  bytes_ += kMagic;
  return std::move(bytes_);
}

void McapWriter::add_record(std::uint8_t opcode, std::string_view content) {
  put(bytes_, opcode);
  put(bytes_, static_cast<std::uint64_t>(content.size()));
  bytes_ += content;
}

}  // namespace voronaut
