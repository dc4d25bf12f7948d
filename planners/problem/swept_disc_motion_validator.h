#pragma once

#include <utility>

#include <ompl/base/MotionValidator.h>

#include "voronaut/planners/problem/known_geometry.h"

namespace voronaut {

// Motions of a disc between two planar states, exact against known points: nothing is stepped over,
// however long the motion. Bounds are convex, so both ends inside means all of it is.
class SweptDiscMotionValidator : public ompl::base::MotionValidator {
 public:
  // `geometry` must outlive the validator: it is the space information's own validity checker.
  SweptDiscMotionValidator(const ompl::base::SpaceInformationPtr& si,
                           const KnownGeometry& geometry);

  bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2) const override;
  // The last valid state lies at most a millimetre before the first contact.
  bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2,
                   std::pair<ompl::base::State*, double>& last_valid) const override;

 private:
  bool is_clear(const ompl::base::State* s1, const ompl::base::State* s2) const;

  const KnownGeometry& geometry_;
};

}  // namespace voronaut
