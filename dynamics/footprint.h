#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace voronaut {

// A body seen from above, in its own frame (x forward, y left, origin where VehicleState::p_world
// is): a convex polygon, or without corners the disc that its vehicle tells the radius of.
struct Footprint {
  std::vector<Eigen::Vector2d> corners_body;  // [m], strictly convex, counter-clockwise
  // The vehicle is planned as a disc of this radius, which need not hold all of the polygon; 0: as
  // one that does.
  double planned_radius_m = 0;

  bool is_disc() const { return corners_body.empty(); }
};

// Of the smallest disc about the origin that holds the corners, and of the largest within them
// (negative or zero if the origin does not lie inside).
double circumscribed_radius_m(std::span<const Eigen::Vector2d> corners_body);
double inscribed_radius_m(std::span<const Eigen::Vector2d> corners_body);

// Where the corners are [m, world] with the origin at p and the body's x axis along `heading_world`
// (unit vector), into `corners_world`.
void place_corners(std::span<const Eigen::Vector2d> corners_body, const Eigen::Vector2d& p_world,
                   const Eigen::Vector2d& heading_world,
                   std::vector<Eigen::Vector2d>& corners_world);

}  // namespace voronaut
