#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>

#include "voronaut/planners/ompl/ompl_planners.h"

namespace voronaut {

namespace og = ompl::geometric;

namespace {

// AITstar::clear() of 1.5.2 uses a null pointer before the planner is set up.
class ClearableAitstar : public og::AITstar {
 public:
  using AITstar::AITstar;
  void clear() override {
    if (isSetup()) AITstar::clear();
  }
};

}  // namespace

std::vector<PlannerEntry> batch_planners() {
  return {
      ompl_entry<og::ABITstar>("ABITstar", "advanced batch informed trees, anytime"),
      ompl_entry<ClearableAitstar>(
          "AITstar", "adaptively informed trees, anytime (1.5.2 aborts on some problems)"),
      ompl_entry<og::BFMT>("BFMT", "bidirectional fast marching tree"),
      ompl_entry<og::BITstar>("BITstar", "batch informed trees, anytime"),
      ompl_entry<og::FMT>("FMT", "fast marching tree"),
  };
}

}  // namespace voronaut
