#include "voronaut/planners/problem/swept_disc_motion_validator.h"

#include <ompl/base/SpaceInformation.h>

#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;

namespace {

constexpr double kContactResolution_m = 1e-3;

}  // namespace

SweptDiscMotionValidator::SweptDiscMotionValidator(const ob::SpaceInformationPtr& si,
                                                   const KnownGeometry& geometry)
    : MotionValidator(si), geometry_(geometry) {}

bool SweptDiscMotionValidator::is_clear(const ob::State* s1, const ob::State* s2) const {
  const ob::StateSpace& space = *si_->getStateSpace();
  const Vec2 a = position_of(space, s1);
  const Vec2 b = position_of(space, s2);
  // What is no number passes OMPL's comparison with the bounds.
  return si_->satisfiesBounds(s2) && (b - a).allFinite() && geometry_.motion_is_clear(a, b);
}

bool SweptDiscMotionValidator::checkMotion(const ob::State* s1, const ob::State* s2) const {
  const bool clear = is_clear(s1, s2);
  ++(clear ? valid_ : invalid_);
  return clear;
}

bool SweptDiscMotionValidator::checkMotion(const ob::State* s1, const ob::State* s2,
                                           std::pair<ob::State*, double>& last_valid) const {
  if (checkMotion(s1, s2)) return true;
  // A part of a valid motion is valid, so the first contact is where bisection ends.
  const double length_m = si_->distance(s1, s2);
  const ob::StateSpacePtr& space = si_->getStateSpace();
  ob::State* probe = si_->allocState();
  double valid = 0;
  double invalid = 1;
  while ((invalid - valid) * length_m > kContactResolution_m) {
    const double middle = 0.5 * (valid + invalid);
    space->interpolate(s1, s2, middle, probe);
    (is_clear(s1, probe) ? valid : invalid) = middle;
  }
  if (last_valid.first) space->interpolate(s1, s2, valid, last_valid.first);
  last_valid.second = valid;
  si_->freeState(probe);
  return false;
}

}  // namespace voronaut
