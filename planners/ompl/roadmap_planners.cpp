#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/prm/SPARS.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>

#include "voronaut/planners/ompl/counted_prm.h"
#include "voronaut/planners/ompl/ompl_planners.h"

namespace voronaut {

namespace og = ompl::geometric;

std::vector<PlannerEntry> roadmap_planners() {
  return {
      ompl_entry<og::LazyPRM>("LazyPRM", "lazy probabilistic roadmap"),
      ompl_entry<og::LazyPRMstar>("LazyPRMstar", "lazy probabilistic roadmap, anytime"),
      ompl_entry<og::PRM>("PRM", "probabilistic roadmap, a thread looks for paths",
                          Reproducible::no),
      ompl_entry<CountedPrm>("PRMcounted",
                             "PRM that takes turns by counted work and has no thread"),
      ompl_entry<og::PRMstar>("PRMstar", "probabilistic roadmap, anytime", Reproducible::no),
      ompl_entry<og::SPARS>("SPARS", "sparse roadmap spanner beside a dense roadmap",
                            Reproducible::no),
      ompl_entry<og::SPARStwo>("SPARStwo", "sparse roadmap spanner alone", Reproducible::no),
  };
}

}  // namespace voronaut
