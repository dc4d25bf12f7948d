#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>

#include "voronaut/planners/ompl/ompl_planners.h"

namespace voronaut {

namespace og = ompl::geometric;

std::vector<PlannerEntry> batch_planners() {
  return {
      ompl_entry<og::ABITstar>("ABITstar", "advanced batch informed trees, anytime"),
      ompl_entry<og::AITstar>("AITstar",
                              "adaptively informed trees, anytime (1.5.2 aborts on some problems)"),
      ompl_entry<og::BFMT>("BFMT", "bidirectional fast marching tree"),
      ompl_entry<og::BITstar>("BITstar", "batch informed trees, anytime"),
      ompl_entry<og::FMT>("FMT", "fast marching tree"),
  };
}

}  // namespace voronaut
