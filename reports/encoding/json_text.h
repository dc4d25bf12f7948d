#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

// For sources only: nlohmann's header is heavy.
namespace voronaut {

// nlohmann's exceptions derive from std::exception only; callers know std::invalid_argument.
template <class Read>
auto parse_as(std::string_view what, Read&& read) {
  try {
    return read();
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(std::string(what) + ": " + error.what());
  }
}

// Compact; bytes that are not UTF-8 become U+FFFD.
inline std::string json_text(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace voronaut
