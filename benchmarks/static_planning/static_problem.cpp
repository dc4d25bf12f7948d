#include "voronaut/benchmarks/static_planning/static_problem.h"

#include <atomic>

#include <ompl/base/StateValidityChecker.h>

#include "voronaut/environments/world.h"
#include "voronaut/planners/problem/planar_state.h"
#include "voronaut/planners/problem/swept_disc_motion_validator.h"

namespace voronaut {

namespace ob = ompl::base;

// The truth, as the swept disc asks for it. No planner sees this: the checker does not offer it.
class StaticProblem::Truth : public KnownGeometry {
 public:
  Truth(const World& world, double clearance_m) : world_(world), clearance_m_(clearance_m) {}

  const ObstacleSnapshot& known_obstacles() const override { return nothing_; }
  double planning_clearance_m() const override { return clearance_m_; }
  bool motion_is_clear(const Vec2& a, const Vec2& b) const override {
    ++checks;
    return world_.segment_is_clear(a, b, clearance_m_);
  }
  const Belief* belief() const override { return nullptr; }
  bool place_is_clear(const Vec2& p) const {
    ++checks;
    return clearance_m(p) >= clearance_m_;
  }
  double clearance_m(const Vec2& p) const { return world_.clearance_m(p); }

  mutable std::atomic<std::uint64_t> checks = 0;

 private:
  const World& world_;
  double clearance_m_;
  ObstacleSnapshot nothing_;
};

namespace {

template <class Truth>
class TrueChecker : public ob::StateValidityChecker {
 public:
  TrueChecker(const ob::SpaceInformationPtr& si, const Truth& truth)
      : StateValidityChecker(si), truth_(truth) {
    specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
  }
  bool isValid(const ob::State* state) const override {
    const Vec2 p = position_of(*si_->getStateSpace(), state);
    return si_->satisfiesBounds(state) && p.allFinite() && truth_.place_is_clear(p);
  }
  double clearance(const ob::State* state) const override {
    return truth_.clearance_m(position_of(*si_->getStateSpace(), state));
  }

 private:
  const Truth& truth_;
};

}  // namespace

StaticProblem::StaticProblem(const Scenario& scenario, double planning_clearance_m)
    : truth_(std::make_shared<Truth>(*scenario.world, planning_clearance_m)),
      problem_({scenario.world->bounds(), scenario.goal_world, scenario.goal_tolerance_m,
                planning_clearance_m}) {
  const ob::SpaceInformationPtr& si = space_information();
  si->setStateValidityChecker(std::make_shared<TrueChecker<Truth>>(si, *truth_));
  si->setMotionValidator(std::make_shared<SweptDiscMotionValidator>(si, *truth_));
  si->setup();
  problem_.update(ObstacleSnapshot{}, scenario.start_world);
}

StaticProblem::~StaticProblem() = default;

const KnownGeometry& StaticProblem::truth() const { return *truth_; }

std::uint64_t StaticProblem::state_checks() const { return truth_->checks; }

}  // namespace voronaut
