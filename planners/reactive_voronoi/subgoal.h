#pragma once

#include <span>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/reactive_voronoi/relevant_obstacle.h"

// Where the papers' modes send the vehicle: small functions of points, each with the paper's words.
// Finaev et al., "The planner of movement of a quadrotor based on Voronoi diagram".
namespace voronaut {

enum class Side { left, right };

// "At bypass of i-th obstacle at the left, the coordinates (x, y) of first point from i-th cluster
// are chosen. At bypass of an obstacle at the right, the coordinates of last point are chosen."
// The paper stores points from left to right, the base here from right to left, so left and right
// change places, and nothing else does.
Vec2 extreme_point(const RelevantObstacle& obstacle, Side side, const Vec2& vehicle,
                   ReactiveVoronoiConfig::Extremes extremes);

// "The increment of coordinates is set (x + g, y - g) and (x - g, y + g) (where g - a safety
// indicator). From the two obtained points the most remote point from an obstacle (x', y') is
// chosen". With Offset::line_of_sight the same length, sqrt(2) g, is set across the line from the
// vehicle to the extreme point, at a course of 45 deg the two are one; closer to the point than
// that it is longer, so that the way keeps the margin.
Vec2 bypass_subgoal(const RelevantObstacle& obstacle, Side side, const Vec2& vehicle,
                    const ReactiveVoronoiConfig& config);

// "Search of coordinates of the next points (x1, y1), (x2, y2) of obstacles to movable object.
// Search of coordinates (x0, y0) of the middle of segment, connecting the next points." It lies on
// the Voronoi edge between the two.
Vec2 between_subgoal(const RelevantObstacle& first, const RelevantObstacle& second);

// Distance from p to the closest of the points. At least one point.
double distance_to_points_m(const Vec2& p, std::span<const Vec2> points);

}  // namespace voronaut
