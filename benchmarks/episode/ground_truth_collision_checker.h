#pragma once

#include <memory>

#include "voronaut/environments/shapes/shapes.h"

namespace voronaut {

// The obstacles of a world as FCL holds them: any number of checkers may share them.
class CollisionScene {
 public:
  // O(n log n) for n shapes.
  static std::shared_ptr<const CollisionScene> of(const Shapes& shapes);
  virtual ~CollisionScene() = default;
};

// Contacts of an upright cylinder with the true world, answered by FCL: an opinion that shares no
// code with our planners, sensors and clearances. Circles are cylinders, walls and the outlines of
// polygons are upright rectangles; a body that starts inside a polygon is the scenario's error.
// Within 1e-5 m of a surface FCL's iterative answer may fall either way.
class GroundTruthCollisionChecker {
 public:
  GroundTruthCollisionChecker(const Shapes& shapes, double body_radius_m);
  GroundTruthCollisionChecker(std::shared_ptr<const CollisionScene> scene, double body_radius_m);
  ~GroundTruthCollisionChecker();

  // True if the body centred at p touches anything. O(log n) broad phase plus the overlapping
  // pairs; O(1) for most of the places along a way that keeps some decimetres from everything.
  bool touches(const Vec2& p_world) const;

 private:
  struct Body;
  struct Surroundings;
  std::shared_ptr<const CollisionScene> scene_;
  std::unique_ptr<Body> body_;
  std::unique_ptr<Surroundings> surroundings_;
};

}  // namespace voronaut
