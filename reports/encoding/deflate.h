#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Raw deflate (RFC 1951, no header), which a browser inflates with
// DecompressionStream('deflate-raw').
namespace voronaut {

std::string deflate_raw(std::string_view bytes);

// Throws std::invalid_argument if `bytes` is not a whole raw deflate stream or if it would grow
// past `max_size` bytes.
std::string inflate_raw(std::string_view bytes, std::size_t max_size = std::size_t{1} << 30);

// RFC 4648 section 4, with padding, no line breaks.
std::string base64(std::string_view bytes);

}  // namespace voronaut
