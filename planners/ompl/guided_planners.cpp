#include <limits>

#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/planners/quotientspace/QRRT.h>
#include <ompl/geometric/planners/rrt/TSRRT.h>
#include <ompl/geometric/planners/rrt/VFRRT.h>
#include <ompl/geometric/planners/xxl/XXL.h>
#include <ompl/geometric/planners/xxl/XXLPositionDecomposition.h>
#include <ompl/util/RandomNumbers.h>

#include "voronaut/planners/ompl/ompl_planners.h"
#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

// A field of unit vectors towards the goal that ends one range before it. Where the field and the
// way to a sample are parallel, VFRRT 1.5.2 divides by zero and drops the motion: with a field that
// went on, no sample of the goal would ever be reached. Its range is the resolution of state checks
// unless it is set: here RRT's choice. Its gain adapts from solve to solve, and clear() does not
// set it back: held at OMPL's first value.
class GoalFieldRrt : public og::VFRRT {
 public:
  explicit GoalFieldRrt(const ob::SpaceInformationPtr& si)
      : VFRRT(
            si, [this](const ob::State* state) { return towards_goal(state); }, kExploration, kGain,
            std::numeric_limits<unsigned>::max()) {
    setRange(0);
  }

 private:
  static constexpr double kExploration = 0.7;
  static constexpr double kGain = 1;

  Eigen::VectorXd towards_goal(const ob::State* state) const {
    const ob::StateSpace& space = *si_->getStateSpace();
    const auto* goal = dynamic_cast<const ob::GoalState*>(pdef_->getGoal().get());
    Eigen::VectorXd field = Eigen::VectorXd::Zero(space.getDimension());
    if (goal == nullptr) return field;
    const Vec2 way = position_of(space, goal->getState()) - position_of(space, state);
    if (way.norm() > getRange()) field.head<2>() = way.normalized();
    return field;
  }
};

// The plane is its own task space.
class PlaneAsTask : public og::TaskSpaceConfig {
 public:
  explicit PlaneAsTask(const ob::SpaceInformationPtr& si) : space_(si->getStateSpace()) {}

  int getDimension() const override { return 2; }
  void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> task) const override {
    task = position_of(*space_, state);
  }
  void sample(Eigen::Ref<Eigen::VectorXd> task) const override {
    const Bounds bounds = position_bounds(*space_);
    for (int axis = 0; axis < 2; ++axis)
      task[axis] = rng_.uniformReal(bounds.min[axis], bounds.max[axis]);
  }
  bool lift(const Eigen::Ref<Eigen::VectorXd>& task, const ob::State* seed,
            ob::State* state) const override {
    space_->copyState(state, seed);
    set_position(*space_, state, Vec2(task[0], task[1]));
    return true;
  }

 private:
  ob::StateSpacePtr space_;
  mutable ompl::RNG rng_;
};

class PlaneRrt : public og::TSRRT {
 public:
  explicit PlaneRrt(const ob::SpaceInformationPtr& si)
      : TSRRT(si, std::make_shared<PlaneAsTask>(si)) {}
};

ob::RealVectorBounds as_ompl(const Bounds& area) {
  ob::RealVectorBounds bounds(2);
  for (unsigned axis = 0; axis < 2; ++axis) {
    bounds.setLow(axis, area.min[axis]);
    bounds.setHigh(axis, area.max[axis]);
  }
  return bounds;
}

// The plane in 16 x 16 equal cells, one layer.
class PlaneCells : public og::XXLPositionDecomposition {
 public:
  explicit PlaneCells(const ob::SpaceInformationPtr& si)
      : XXLPositionDecomposition(as_ompl(position_bounds(*si->getStateSpace())), {16, 16}, true),
        space_(si->getStateSpace()) {}

  int numLayers() const override { return 1; }
  bool sampleFromRegion(int region, ob::State* state, const ob::State* = nullptr) const override {
    return sampleFromRegion(region, state, nullptr, 0);
  }
  bool sampleFromRegion(int region, ob::State* state, const ob::State*, int) const override {
    std::vector<int> cell;
    ridToGridCell(region, cell);
    Vec2 p;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double low = bounds_.low[axis] + cell[axis] * cellSizes_[axis];
      p[static_cast<int>(axis)] = rng_.uniformReal(low, low + cellSizes_[axis]);
    }
    set_position(*space_, state, p);
    return true;
  }
  void project(const ob::State* state, std::vector<double>& coordinates, int) const override {
    const Vec2 p = position_of(*space_, state);
    coordinates = {p.x(), p.y()};
  }
  void project(const ob::State* state, std::vector<int>& layers) const override {
    layers = {locateRegion(state)};
  }

 private:
  ob::StateSpacePtr space_;
  mutable ompl::RNG rng_;
};

class PlaneXxl : public og::XXL {
 public:
  explicit PlaneXxl(const ob::SpaceInformationPtr& si)
      : XXL(si, std::make_shared<PlaneCells>(si)) {}
};

// OMPL's constructor takes a list of spaces from coarse to fine: here the space itself, alone.
class OneLevelQrrt : public og::QRRT {
 public:
  explicit OneLevelQrrt(const ob::SpaceInformationPtr& si) : OneLevelQrrt(List{si}) {}

 private:
  using List = std::vector<ob::SpaceInformationPtr>;
  explicit OneLevelQrrt(List levels) : MultiQuotient(levels, "QRRT") {}
};

}  // namespace

std::vector<PlannerEntry> guided_planners() {
  return {
      ompl_entry<OneLevelQrrt>("QRRT", "quotient space RRT, on one level"),
      ompl_entry<PlaneRrt>("TSRRT", "task space RRT, the plane as its task space"),
      ompl_entry<GoalFieldRrt>("VFRRT", "RRT along a vector field: the pull of the goal"),
      ompl_entry<PlaneXxl>("XXL", "search over cells, 16 x 16 of the plane"),
  };
}

}  // namespace voronaut
