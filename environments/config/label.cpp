#include "voronaut/environments/config/label.h"

#include <algorithm>

#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {

std::string read_label(const ConfigNode& node) {
  std::string label = node.text();
  const auto is_control = [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f;
  };
  const bool controls = std::any_of(label.begin(), label.end(), is_control);
  if (!label.empty() && label.size() <= kLabelBytesMax && !controls) return label;
  std::string shown = label.substr(0, 40);
  std::replace_if(shown.begin(), shown.end(), is_control, '?');
  throw node.error("expected a label of 1 to " + std::to_string(kLabelBytesMax) +
                   " bytes without line breaks or control characters, got " +
                   std::to_string(label.size()) + " bytes, " + in_quotes(shown) +
                   (label.size() > shown.size() ? "..." : ""));
}

}  // namespace voronaut
