#include "voronaut/planners/problem/belief_validity_checker.h"

#include <algorithm>

#include <ompl/base/SpaceInformation.h>

#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;

BeliefValidityChecker::BeliefValidityChecker(const ob::SpaceInformationPtr& si,
                                             double planning_clearance_m)
    : StateValidityChecker(si),
      planning_clearance_m_(planning_clearance_m),
      horizon_m_(si->getMaximumExtent()),
      relaxation_(planning_clearance_m) {
  specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
}

void BeliefValidityChecker::look_at(const Belief& belief, const Vec2& start_world) {
  look_at(belief.obstacles, start_world);
  belief_ = &belief;
}

void BeliefValidityChecker::look_at(const ObstacleSnapshot& obstacles, const Vec2& start_world) {
  belief_ = nullptr;
  obstacles_ = obstacles;
  obstacles_.expect_checks(planning_clearance_m_);
  relaxation_ = StartRelaxation(planning_clearance_m_);
  if (const auto closest = obstacles_.nearest(start_world, planning_clearance_m_)) {
    const double start_clearance_m = (obstacles_.points()[*closest] - start_world).norm();
    relaxation_ = StartRelaxation(planning_clearance_m_, start_world, start_clearance_m);
  }
}

bool BeliefValidityChecker::isValid(const ob::State* state) const {
  count();
  if (!si_->satisfiesBounds(state)) return false;
  const Vec2 p = position_of(*si_->getStateSpace(), state);
  return p.allFinite() && obstacles_.disc_is_clear(p, relaxation_.clearance_at_m(p));
}

double BeliefValidityChecker::clearance(const ob::State* state) const {
  return clearance_m(position_of(*si_->getStateSpace(), state));
}

bool BeliefValidityChecker::motion_is_clear(const Vec2& a, const Vec2& b) const {
  count();
  if (!relaxation_.active()) return obstacles_.swept_disc_is_clear(a, b, planning_clearance_m_);
  const ClearancePieces pieces = relaxation_.split(a, b);
  return std::all_of(pieces.piece.begin(), pieces.piece.begin() + pieces.count,
                     [&](const ClearancePiece& piece) {
                       return obstacles_.swept_disc_is_clear(piece.a, piece.b, piece.clearance_m);
                     });
}

double BeliefValidityChecker::clearance_m(const Vec2& p) const {
  // Growing rings: a query costs the cells in reach, and most states have a point nearby.
  for (double reach_m = 2 * planning_clearance_m_; reach_m < horizon_m_; reach_m *= 2) {
    if (const auto closest = obstacles_.nearest(p, reach_m))
      return (obstacles_.points()[*closest] - p).norm();
  }
  const auto closest = obstacles_.nearest(p, horizon_m_);
  return closest ? (obstacles_.points()[*closest] - p).norm() : horizon_m_;
}

}  // namespace voronaut
