#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/rrt/pRRT.h>
#include <ompl/geometric/planners/sbl/pSBL.h>

#include "voronaut/planners/ompl/ompl_planners.h"

namespace voronaut {

namespace og = ompl::geometric;

std::vector<PlannerEntry> parallel_planners() {
  return {
      ompl_entry<og::AnytimePathShortening>(
          "AnytimePathShortening", "several planners at once, their paths hybridised, anytime",
          Reproducible::no),
      ompl_entry<og::CForest>("CForest", "RRTstar in every core, sharing paths, anytime",
                              Reproducible::no),
      ompl_entry<og::pRRT>("pRRT", "RRT grown by two threads", Reproducible::no),
      ompl_entry<og::pSBL>("pSBL", "SBL grown by two threads", Reproducible::no),
  };
}

}  // namespace voronaut
