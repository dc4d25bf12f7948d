#include <chrono>
#include <thread>

#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/rrt/pRRT.h>
#include <ompl/geometric/planners/sbl/pSBL.h>

#include "voronaut/planners/ompl/ompl_planners.h"

namespace voronaut {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

// The thread that solves only waits for the others, and 1.5.2 has it ask for the end in a tight
// loop, which spends a counted budget within a millisecond: here it waits between two questions.
class UnhurriedPathShortening : public og::AnytimePathShortening {
 public:
  using AnytimePathShortening::AnytimePathShortening;

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition& condition) override {
    const std::thread::id waiting = std::this_thread::get_id();
    return AnytimePathShortening::solve(ob::PlannerTerminationCondition([&condition, waiting] {
      if (std::this_thread::get_id() == waiting)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return condition();
    }));
  }
};

}  // namespace

std::vector<PlannerEntry> parallel_planners() {
  return {
      ompl_entry<UnhurriedPathShortening>(
          "AnytimePathShortening", "several planners at once, their paths hybridised, anytime",
          Reproducible::no),
      ompl_entry<og::CForest>("CForest", "RRTstar in every core, sharing paths, anytime",
                              Reproducible::no),
      ompl_entry<og::pRRT>("pRRT", "RRT grown by two threads", Reproducible::no),
      ompl_entry<og::pSBL>("pSBL", "SBL grown by two threads", Reproducible::no),
  };
}

}  // namespace voronaut
