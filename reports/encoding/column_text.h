#pragma once

#include <string>

namespace voronaut {

// The shortest decimal text that reads back as the same double; empty for NaN, "inf" and "-inf".
std::string column_text(double value);

}  // namespace voronaut
