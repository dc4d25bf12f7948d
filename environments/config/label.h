#pragma once

#include <cstddef>
#include <string>

#include "voronaut/environments/config/config_node.h"

namespace voronaut {

inline constexpr std::size_t kLabelBytesMax = 200;

// Text that names something in tables, files and messages: 1 to kLabelBytesMax bytes, no line break
// and no control character but the tab. Throws ConfigError.
std::string read_label(const ConfigNode& node);

}  // namespace voronaut
