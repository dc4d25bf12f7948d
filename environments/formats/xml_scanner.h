#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/environments/config/config_error.h"

namespace voronaut {

// Goes through the elements of an XML text: as much of XML as SDF files use (elements, attributes,
// comments, CDATA, declarations; entities stay as they are written). The text must outlive it.
class XmlScanner {
 public:
  XmlScanner(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  // To the next start or end of an element; false at the end of the text. Throws ConfigError where
  // the text is not of that form.
  bool next();
  bool starts() const { return starts_; }
  // Names from the root to the element that starts or ends here: "sdf/world/model".
  const std::string& path() const { return path_; }
  // At an end: the text since the last tag, without comments.
  std::string_view text() const { return inner_; }
  // Of the element that started last: the value of an attribute, if it has it.
  std::optional<std::string_view> attribute(std::string_view name) const;

  ConfigError error(std::string_view problem) const { return {file_, line_, "", problem}; }

 private:
  bool skip_to_tag();
  void skip_past(std::size_t begin_of_end, std::size_t length);
  void open(std::string_view tag);
  void close(std::string_view name);
  void advance(std::size_t count);

  static constexpr std::size_t kDeepest = 100;

  std::string_view text_;
  std::string file_;
  std::string inner_;
  std::string_view attributes_;
  std::vector<std::string> open_;
  std::string path_;
  int line_ = 1;
  bool starts_ = false;
  bool ends_at_once_ = false;  // <name/>: its end comes next
  bool leaves_ = false;        // the last one ended: it leaves the path with the next step
};

}  // namespace voronaut
