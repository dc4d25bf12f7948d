#include <cstdlib>

#include "voronaut/planners/catalog/plugin.h"

// A library that ends the program as soon as it is asked for its planners.
VORONAUT_PLUGIN(planners) {
  static_cast<void>(planners);
  std::abort();
}
