#pragma once

#include <cstdio>
#include <cstdlib>

namespace voronaut {

// A programmer's error ends the program, in every build.
inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "voronaut: requirement violated: %s\n", what);
  std::abort();
}

}  // namespace voronaut
