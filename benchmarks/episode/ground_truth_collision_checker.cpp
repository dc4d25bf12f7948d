#include "voronaut/benchmarks/episode/ground_truth_collision_checker.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

namespace voronaut {

namespace {

// Everything stands upright around z = 0; the body is shorter than what it may meet, so that only
// the plane decides.
constexpr double kObstacleHeight_m = 4;
constexpr double kBodyHeight_m = 1;

using Mesh = fcl::BVHModel<fcl::OBBRSSd>;

void add_wall(Mesh& mesh, const Vec2& a, const Vec2& b) {
  const double h = 0.5 * kObstacleHeight_m;
  const fcl::Vector3d a0(a.x(), a.y(), -h), a1(a.x(), a.y(), h);
  const fcl::Vector3d b0(b.x(), b.y(), -h), b1(b.x(), b.y(), h);
  mesh.addTriangle(a0, b0, b1);
  mesh.addTriangle(a0, b1, a1);
}

std::shared_ptr<Mesh> wall_mesh(const Shapes& shapes) {
  auto mesh = std::make_shared<Mesh>();
  mesh->beginModel();
  for (const Segment& wall : shapes.segments) add_wall(*mesh, wall.a, wall.b);
  for (const Polygon& polygon : shapes.polygons) {
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      add_wall(*mesh, polygon.vertices[i], polygon.vertices[(i + 1) % polygon.vertices.size()]);
    }
  }
  mesh->endModel();
  return mesh;
}

fcl::Transform3d at(const Vec2& p) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.translation() = fcl::Vector3d(p.x(), p.y(), 0);
  return pose;
}

class FclScene : public CollisionScene {
 public:
  explicit FclScene(const Shapes& shapes) {
    for (const Circle& circle : shapes.circles)
      add(std::make_shared<fcl::Cylinderd>(circle.radius_m, kObstacleHeight_m), at(circle.center));
    if (!shapes.segments.empty() || !shapes.polygons.empty())
      add(wall_mesh(shapes), fcl::Transform3d::Identity());
    tree_.setup();
  }

  bool touches(fcl::CollisionObjectd& body) const {
    fcl::DefaultCollisionData<double> contact;
    tree_.collide(&body, &contact, fcl::DefaultCollisionFunction);
    return contact.result.isCollision();
  }

 private:
  void add(const std::shared_ptr<fcl::CollisionGeometryd>& geometry, const fcl::Transform3d& pose) {
    obstacles_.push_back(std::make_unique<fcl::CollisionObjectd>(geometry, pose));
    tree_.registerObject(obstacles_.back().get());
  }

  std::vector<std::unique_ptr<fcl::CollisionObjectd>> obstacles_;
  fcl::DynamicAABBTreeCollisionManagerd tree_;
};

}  // namespace

std::shared_ptr<const CollisionScene> CollisionScene::of(const Shapes& shapes) {
  return std::make_shared<FclScene>(shapes);
}

struct GroundTruthCollisionChecker::Body {
  explicit Body(double radius_m)
      : cylinder(std::make_shared<fcl::Cylinderd>(radius_m, kBodyHeight_m),
                 fcl::Transform3d::Identity()) {}
  fcl::CollisionObjectd cylinder;
};

GroundTruthCollisionChecker::GroundTruthCollisionChecker(const Shapes& shapes, double body_radius_m)
    : GroundTruthCollisionChecker(CollisionScene::of(shapes), body_radius_m) {}

GroundTruthCollisionChecker::GroundTruthCollisionChecker(
    std::shared_ptr<const CollisionScene> scene, double body_radius_m)
    : scene_(std::move(scene)), body_(std::make_unique<Body>(body_radius_m)) {}

GroundTruthCollisionChecker::~GroundTruthCollisionChecker() = default;

bool GroundTruthCollisionChecker::touches(const Vec2& p_world) const {
  body_->cylinder.setTransform(at(p_world));
  body_->cylinder.computeAABB();
  return static_cast<const FclScene&>(*scene_).touches(body_->cylinder);
}

}  // namespace voronaut
