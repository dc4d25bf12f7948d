#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace voronaut {

// What a user wrote is wrong. what() is one line, "file:line: key 'name': the problem, what is
// allowed", made to be printed as it is; control characters of the input are escaped in it.
class ConfigError : public std::runtime_error {
 public:
  // For a problem of the whole file: line 0 leaves the line out, an empty key leaves the key out.
  ConfigError(std::string_view file, int line, std::string_view key, std::string_view problem)
      : std::runtime_error(compose(file, line, key, problem)) {}

 private:
  static std::string compose(std::string_view file, int line, std::string_view key,
                             std::string_view problem) {
    std::string text(file);
    if (line > 0) text.append(":").append(std::to_string(line));
    text += ": ";
    if (!key.empty()) text.append("key '").append(key).append("': ");
    return text.append(problem);
  }
};

}  // namespace voronaut
