#include <cmath>
#include <memory>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>

#include "voronaut/planners/ompl/ompl_planners.h"

namespace voronaut {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

// Path length in whole steps of 2^-30 m, rounded up: sums are exact in any order, and the triangle
// inequality holds without rounding.
class LengthInSteps : public ob::PathLengthOptimizationObjective {
 public:
  using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override {
    return ob::Cost(std::ldexp(std::ceil(std::ldexp(si_->distance(from, to), kBits)), -kBits));
  }
  ob::Cost motionCostHeuristic(const ob::State* from, const ob::State* to) const override {
    return motionCost(from, to);
  }

 private:
  static constexpr int kBits = 30;
};

// AITstar of 1.5.2 asserts that no state becomes cheaper once it was expanded, which sums of
// rounded lengths break by their last bit: where the straight way was free most solves aborted.
class ExactlySumming : public og::AITstar {
 public:
  using AITstar::AITstar;

  void setup() override {
    if (pdef_) count_length_in_steps();
    AITstar::setup();
  }

 private:
  void count_length_in_steps() const {
    const ob::OptimizationObjectivePtr asked = pdef_->getOptimizationObjective();
    if (asked && !dynamic_cast<const ob::PathLengthOptimizationObjective*>(asked.get())) return;
    const auto steps = std::make_shared<LengthInSteps>(si_);
    if (asked) steps->setCostThreshold(asked->getCostThreshold());
    pdef_->setOptimizationObjective(steps);
  }
};

}  // namespace

std::vector<PlannerEntry> batch_planners() {
  return {
      ompl_entry<og::ABITstar>("ABITstar", "advanced batch informed trees, anytime"),
      ompl_entry<ExactlySumming>("AITstar", "adaptively informed trees, anytime"),
      ompl_entry<og::BFMT>("BFMT", "bidirectional fast marching tree"),
      ompl_entry<og::BITstar>("BITstar", "batch informed trees, anytime"),
      ompl_entry<og::FMT>("FMT", "fast marching tree"),
  };
}

}  // namespace voronaut
