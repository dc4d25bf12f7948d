#include "voronaut/dynamics/regulator.h"

#include <stdexcept>

namespace voronaut {

VelocityResponse Regulator::velocity_response() const {
  throw std::invalid_argument("what drives along its heading answers no velocity in any direction");
}

}  // namespace voronaut
