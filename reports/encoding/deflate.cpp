#include "voronaut/reports/encoding/deflate.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include <zlib.h>

namespace voronaut {

namespace {

constexpr int kRawWindowBits = -15;  // negative: neither zlib's nor gzip's header
constexpr int kMemoryLevel = 8;
// zlib's default, 6, takes three times as long for a sixth fewer bytes of a trace: the half of what
// keeping traces costs a flight.
constexpr int kLevel = 3;
constexpr std::size_t kChunk = std::size_t{1} << 16;

// zlib counts input in 32 bits: hand it over in pieces.
void refill(z_stream& stream, std::string_view& rest) {
  if (stream.avail_in == 0 && !rest.empty()) {
    const std::size_t size = std::min<std::size_t>(rest.size(), std::numeric_limits<uInt>::max());
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest.data()));
    stream.avail_in = static_cast<uInt>(size);
    rest.remove_prefix(size);
  }
}

}  // namespace

std::string deflate_raw(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, kRawWindowBits, kMemoryLevel,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::bad_alloc();
  }
  std::string out;
  std::array<char, kChunk> chunk{};
  int code = Z_OK;
  while (code != Z_STREAM_END) {
    refill(stream, bytes);
    stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
    stream.avail_out = static_cast<uInt>(chunk.size());
    code = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
    out.append(chunk.data(), chunk.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  return out;
}

std::string inflate_raw(std::string_view bytes, std::size_t max_size) {
  z_stream stream{};
  if (inflateInit2(&stream, kRawWindowBits) != Z_OK) {
    throw std::bad_alloc();
  }
  std::string out;
  std::array<char, kChunk> chunk{};
  int code = Z_OK;
  while (code == Z_OK && out.size() <= max_size) {
    refill(stream, bytes);
    stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
    stream.avail_out = static_cast<uInt>(chunk.size());
    code = inflate(&stream, Z_NO_FLUSH);
    out.append(chunk.data(), chunk.size() - stream.avail_out);
  }
  const bool whole = code == Z_STREAM_END && stream.avail_in == 0 && bytes.empty();
  inflateEnd(&stream);
  if (!whole || out.size() > max_size) {
    throw std::invalid_argument("not a whole raw deflate stream of at most " +
                                std::to_string(max_size) + " bytes");
  }
  return out;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out += k <= count ? kDigits[group >> (18U - 6U * static_cast<unsigned>(k)) & 63U] : '=';
    }
  }
  return out;
}

}  // namespace voronaut
