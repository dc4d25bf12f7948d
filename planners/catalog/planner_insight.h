#pragma once

#include <string>
#include <string_view>

namespace voronaut {

// What a planner may tell about its last solve beyond OMPL's status. The executive looks for it
// with a dynamic_cast; a planner without it is simply not asked.
class PlannerInsight {
 public:
  virtual ~PlannerInsight() = default;

  // Name of the mode it is in ("between", "left", ...), empty if it has none.
  virtual std::string_view mode() const { return {}; }

  // True if the last solve proved that no path exists on what is known, at the clearance asked for.
  virtual bool proved_no_path() const { return false; }
};

}  // namespace voronaut
