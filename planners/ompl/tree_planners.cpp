#include <iostream>  // NearestNeighborsGNATNoThreadSafety.h of 1.5.2 wants it
#include <memory>
#include <vector>

#include <ompl/datastructures/NearestNeighborsGNATNoThreadSafety.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
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

#include "voronaut/planners/ompl/ompl_planners.h"

namespace voronaut {

namespace og = ompl::geometric;

namespace {

// LazyLBTRRT of 1.5.2 takes an edge that turns out to be blocked from its graph in both directions,
// and LPAstarOnGraph asserts that none ends at the start: a blocked motion from the start aborts.
// Here the graph gets no such edge, for neighbours of the start are checked when they are asked
// for.
class EagerAtStart : public og::LazyLBTRRT {
 public:
  using LazyLBTRRT::LazyLBTRRT;

  void setup() override {
    if (!nn_) nn_ = std::make_shared<Neighbours>(*this);
    LazyLBTRRT::setup();
  }
  // Frees two searches and leaves their addresses to be freed again.
  void clear() override {
    LazyLBTRRT::clear();
    LPAstarApx_ = nullptr;
    LPAstarLb_ = nullptr;
  }

 private:
  class Neighbours : public ompl::NearestNeighborsGNATNoThreadSafety<Motion*> {
   public:
    explicit Neighbours(const EagerAtStart& planner) : planner_(planner) {}

    void nearestK(Motion* const& from, std::size_t k, std::vector<Motion*>& to) const override {
      NearestNeighborsGNATNoThreadSafety::nearestK(from, k, to);
      std::erase_if(to, [this, from](const Motion* motion) {
        return (from == planner_.startMotion_) != (motion == planner_.startMotion_) &&
               !planner_.checkMotion(from, motion);
      });
    }

   private:
    const EagerAtStart& planner_;
  };
};

}  // namespace

std::vector<PlannerEntry> tree_planners() {
  return {
      ompl_entry<og::BKPIECE1>("BKPIECE1", "bidirectional KPIECE on one grid level"),
      ompl_entry<og::BiEST>("BiEST", "bidirectional expansive space trees"),
      ompl_entry<og::BiRLRT>("BiRLRT", "bidirectional range-limited random tree"),
      ompl_entry<og::BiTRRT>("BiTRRT", "bidirectional transition-based RRT"),
      ompl_entry<og::EST>("EST", "expansive space trees"),
      ompl_entry<og::InformedRRTstar>("InformedRRTstar", "RRTstar on an informed subset, anytime"),
      ompl_entry<og::KPIECE1>("KPIECE1", "KPIECE on one grid level"),
      ompl_entry<og::LBKPIECE1>("LBKPIECE1", "lazy bidirectional KPIECE on one grid level"),
      ompl_entry<Anytime<og::LBTRRT>>("LBTRRT", "lower bound tree RRT, anytime", Reproducible::no),
      ompl_entry<Anytime<EagerAtStart>>("LazyLBTRRT", "lazy lower bound tree RRT, anytime",
                                        Reproducible::no),
      ompl_entry<og::LazyRRT>("LazyRRT", "RRT that checks motions late"),
      ompl_entry<og::PDST>("PDST", "path-directed subdivision tree"),
      ompl_entry<og::ProjEST>("ProjEST", "expansive space trees on a projection"),
      ompl_entry<og::RLRT>("RLRT", "range-limited random tree"),
      ompl_entry<og::RRT>("RRT", "rapidly-exploring random tree"),
      ompl_entry<og::RRTConnect>("RRTConnect", "two trees that grow towards each other"),
      ompl_entry<og::RRTXstatic>("RRTXstatic", "RRTX without moving obstacles, anytime"),
      ompl_entry<og::RRTsharp>("RRTsharp", "RRT#, anytime"),
      ompl_entry<og::RRTstar>("RRTstar", "asymptotically optimal RRT, anytime"),
      ompl_entry<og::SBL>("SBL", "single-query bidirectional lazy tree"),
      ompl_entry<og::SORRTstar>("SORRTstar", "sorted informed RRTstar, anytime"),
      ompl_entry<Anytime<og::SST>>("SST", "stable sparse RRT, anytime"),
      ompl_entry<og::STRIDE>("STRIDE", "search tree with resolution independent density"),
      ompl_entry<og::TRRT>("TRRT", "transition-based RRT"),
  };
}

}  // namespace voronaut
