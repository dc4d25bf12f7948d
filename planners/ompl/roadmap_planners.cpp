#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/prm/SPARS.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>

#include "voronaut/planners/ompl/counted_prm.h"
#include "voronaut/planners/ompl/ompl_planners.h"

namespace voronaut {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

// A thread looks for a path once a millisecond, and stops looking where the roadmap gave up adding
// states: what was connected since its last look is found by one more.
template <class Roadmap>
class LooksOnceMore : public Roadmap {
 public:
  using Roadmap::Roadmap;

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition& ptc) override {
    const ob::PlannerStatus status = Roadmap::solve(ptc);
    ob::PathPtr path;
    if (status != ob::PlannerStatus::TIMEOUT ||
        !this->haveSolution(this->startM_, this->goalM_, path))
      return status;
    this->pdef_->addSolutionPath(path, false, -1, this->getName());
    return ob::PlannerStatus::EXACT_SOLUTION;
  }
};

}  // namespace

std::vector<PlannerEntry> roadmap_planners() {
  return {
      ompl_entry<og::LazyPRM>("LazyPRM", "lazy probabilistic roadmap"),
      ompl_entry<og::LazyPRMstar>("LazyPRMstar", "lazy probabilistic roadmap, anytime"),
      ompl_entry<og::PRM>("PRM", "probabilistic roadmap, a thread looks for paths",
                          Reproducible::no),
      ompl_entry<CountedPrm>("PRMcounted",
                             "PRM that takes turns by counted work and has no thread"),
      ompl_entry<og::PRMstar>("PRMstar", "probabilistic roadmap, anytime", Reproducible::no),
      ompl_entry<LooksOnceMore<og::SPARS>>("SPARS", "sparse roadmap spanner beside a dense roadmap",
                                           Reproducible::no),
      ompl_entry<LooksOnceMore<og::SPARStwo>>("SPARStwo", "sparse roadmap spanner alone",
                                              Reproducible::no),
  };
}

}  // namespace voronaut
