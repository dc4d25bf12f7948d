#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include "voronaut/environments/shapes/geometry.h"

// A planning problem as any OMPL user would pose it: a plane, a validity checker, nothing else.
namespace voronaut::test {

// Counts states, so that a test can ask whether all were freed.
template <class Space>
class Counting : public Space {
 public:
  template <class... Arguments>
  explicit Counting(std::shared_ptr<long> alive, Arguments... arguments)
      : Space(arguments...), alive_(std::move(alive)) {}

  ompl::base::State* allocState() const override {
    ++*alive_;
    return Space::allocState();
  }
  void freeState(ompl::base::State* state) const override {
    --*alive_;
    Space::freeState(state);
  }

 private:
  std::shared_ptr<long> alive_;
};

enum class Space { plane, se2 };

struct PlanarProblem {
  using IsFree = std::function<bool(const Vec2&)>;

  // The square from (0, 0) to (10, 10); headings, where the space has them, are all free.
  explicit PlanarProblem(const IsFree& is_free, Space kind = Space::plane);

  // A new definition with these starts and goals; every definition made lives as long as this.
  ompl::base::ProblemDefinitionPtr define(const std::vector<Vec2>& starts,
                                          const std::vector<Vec2>& goals) const;

  std::shared_ptr<long> states_alive = std::make_shared<long>(0);
  ompl::base::SpaceInformationPtr si;
};

// Free space of the conformance suite: two discs beside and on the way from (1, 1) to (9, 9).
bool free_of_two_discs(const Vec2& p);

// The same, with `center` enclosed by a ring it cannot leave.
PlanarProblem::IsFree with_ring_around(const Vec2& center);

Vec2 planar(const ompl::base::SpaceInformation& si, const ompl::base::State* state);

}  // namespace voronaut::test
