#include "voronaut/planners/catalog/ompl_planners.h"

#include <memory>

#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/rlrt/BiRLRT.h>
#include <ompl/geometric/planners/rlrt/RLRT.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyLBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/sst/SST.h>
#include <ompl/geometric/planners/stride/STRIDE.h>

namespace voronaut {

namespace og = ompl::geometric;

namespace {

template <class Planner>
PlannerEntry entry(const char* name, const char* summary) {
  return {name, summary, PlannerTraits{},
          [](const ompl::base::SpaceInformationPtr& si) -> ompl::base::PlannerPtr {
            return std::make_shared<Planner>(si);
          }};
}

}  // namespace

std::vector<PlannerEntry> ompl_planners() {
  return {
      entry<og::ABITstar>("ABITstar", "OMPL: advanced batch informed trees, anytime"),
      entry<og::AITstar>(
          "AITstar", "OMPL: adaptively informed trees, anytime (1.5.2 aborts on some problems)"),
      entry<og::BFMT>("BFMT", "OMPL: bidirectional fast marching tree"),
      entry<og::BITstar>("BITstar", "OMPL: batch informed trees, anytime"),
      entry<og::BKPIECE1>("BKPIECE1", "OMPL: bidirectional KPIECE on one grid level"),
      entry<og::BiEST>("BiEST", "OMPL: bidirectional expansive space trees"),
      entry<og::BiRLRT>("BiRLRT", "OMPL: bidirectional range-limited random tree"),
      entry<og::BiTRRT>("BiTRRT", "OMPL: bidirectional transition-based RRT"),
      entry<og::EST>("EST", "OMPL: expansive space trees"),
      entry<og::FMT>("FMT", "OMPL: fast marching tree"),
      entry<og::InformedRRTstar>("InformedRRTstar", "OMPL: RRTstar on an informed subset, anytime"),
      entry<og::KPIECE1>("KPIECE1", "OMPL: KPIECE on one grid level"),
      entry<og::LBKPIECE1>("LBKPIECE1", "OMPL: lazy bidirectional KPIECE on one grid level"),
      entry<og::LBTRRT>("LBTRRT", "OMPL: lower bound tree RRT, anytime"),
      entry<og::LazyLBTRRT>("LazyLBTRRT", "OMPL: lazy lower bound tree RRT, anytime"),
      entry<og::LazyPRM>("LazyPRM", "OMPL: lazy probabilistic roadmap"),
      entry<og::LazyPRMstar>("LazyPRMstar", "OMPL: lazy probabilistic roadmap, anytime"),
      entry<og::LazyRRT>("LazyRRT", "OMPL: RRT that checks motions late"),
      entry<og::PDST>("PDST", "OMPL: path-directed subdivision tree"),
      entry<og::ProjEST>("ProjEST", "OMPL: expansive space trees on a projection"),
      entry<og::RLRT>("RLRT", "OMPL: range-limited random tree"),
      entry<og::RRT>("RRT", "OMPL: rapidly-exploring random tree"),
      entry<og::RRTConnect>("RRTConnect", "OMPL: two trees that grow towards each other"),
      entry<og::RRTXstatic>("RRTXstatic", "OMPL: RRTX without moving obstacles, anytime"),
      entry<og::RRTsharp>("RRTsharp", "OMPL: RRT#, anytime"),
      entry<og::RRTstar>("RRTstar", "OMPL: asymptotically optimal RRT, anytime"),
      entry<og::SBL>("SBL", "OMPL: single-query bidirectional lazy tree"),
      entry<og::SORRTstar>("SORRTstar", "OMPL: sorted informed RRTstar, anytime"),
      entry<og::SST>("SST", "OMPL: stable sparse RRT, anytime"),
      entry<og::STRIDE>("STRIDE", "OMPL: search tree with resolution independent density"),
      entry<og::TRRT>("TRRT", "OMPL: transition-based RRT"),
  };
}

}  // namespace voronaut
