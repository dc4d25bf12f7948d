#include "voronaut/planners/navigation/navigation_report.h"

namespace voronaut {

std::string_view to_string(ExecutiveState state) {
  switch (state) {
    case ExecutiveState::takeoff:
      return "takeoff";
    case ExecutiveState::looking_around:
      return "looking_around";
    case ExecutiveState::tracking:
      return "tracking";
    case ExecutiveState::backing_off:
      return "backing_off";
    case ExecutiveState::retracing:
      return "retracing";
    case ExecutiveState::without_path:
      return "without_path";
  }
  return "tracking";
}

}  // namespace voronaut
