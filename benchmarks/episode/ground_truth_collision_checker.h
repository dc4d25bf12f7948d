#pragma once

#include <memory>

#include "voronaut/dynamics/footprint.h"
#include "voronaut/environments/shapes/shapes.h"

namespace voronaut {

// The obstacles of a world as FCL holds them: any number of checkers may share them.
class CollisionScene {
 public:
  // O(n log n) for n shapes.
  static std::shared_ptr<const CollisionScene> of(const Shapes& shapes);
  virtual ~CollisionScene() = default;
};

// Contacts of an upright body, a cylinder or a prism over a convex polygon, with the true world,
// answered by FCL: an opinion that shares no code with our planners, sensors and clearances.
// Circles are cylinders, walls and the outlines of polygons are upright rectangles; a body that
// starts inside a polygon is the scenario's error. Within 1e-5 m of a surface FCL's iterative
// answer may fall either way.
class GroundTruthCollisionChecker {
 public:
  // `body_radius_m` of the cylinder, or of one that holds the polygon.
  GroundTruthCollisionChecker(const Shapes& shapes, double body_radius_m,
                              const Footprint& footprint = {});
  GroundTruthCollisionChecker(std::shared_ptr<const CollisionScene> scene, double body_radius_m,
                              const Footprint& footprint = {});
  ~GroundTruthCollisionChecker();

  // True if the body at p, its x axis along `heading_world` (unit vector), touches anything. O(log
  // n) broad phase plus the overlapping pairs; O(1) for most of the places along a way that keeps
  // some decimetres from everything.
  bool touches(const Vec2& p_world, const Vec2& heading_world = Vec2::UnitX()) const;

 private:
  struct Body;
  struct Surroundings;
  std::shared_ptr<const CollisionScene> scene_;
  std::unique_ptr<Body> body_;
  std::unique_ptr<Surroundings> surroundings_;
};

}  // namespace voronaut
