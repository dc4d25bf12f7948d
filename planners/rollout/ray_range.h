#pragma once

#include <functional>

#include <ompl/base/SpaceInformation.h>

#include "voronaut/environments/sensing/scan.h"
#include "voronaut/environments/shapes/geometry.h"

// How planners sense a static problem: as a range finder would, through what OMPL offers.
namespace voronaut {

// Distance from a point along a unit direction to the first thing a range finder would see, at most
// max_range_m. Nothing is seen beyond the bounds of the space.
using RayRange = std::function<double(const Vec2& from, const Vec2& direction, double max_range_m)>;

// Exact to a centimetre where the validity checker is a KnownGeometry (known points are seen as
// discs of 5 cm, so that a thinned surface has no holes); else marched through isValid() in steps
// of resolution_m, with the state's other components as in `reference`.
RayRange ray_range(const ompl::base::SpaceInformationPtr& si, const ompl::base::State* reference,
                   double resolution_m);

// Fills the ranges of a scan whose pose, beams and maximal range are set.
void sense(const RayRange& range, Scan& scan);

}  // namespace voronaut
