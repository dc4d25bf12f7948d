#pragma once

#include <exception>
#include <string>

namespace voronaut {

// What an action throws as an Error, as text; "no error" if nothing. Other exceptions pass.
template <class Error = std::exception, class Action>
std::string error_of(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace voronaut
