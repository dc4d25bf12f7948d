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

}  // namespace

struct GroundTruthCollisionChecker::Scene {
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> obstacles;
  fcl::DynamicAABBTreeCollisionManagerd tree;
  std::unique_ptr<fcl::CollisionObjectd> body;

  void add(const std::shared_ptr<fcl::CollisionGeometryd>& geometry, const fcl::Transform3d& pose) {
    obstacles.push_back(std::make_unique<fcl::CollisionObjectd>(geometry, pose));
    tree.registerObject(obstacles.back().get());
  }
};

GroundTruthCollisionChecker::GroundTruthCollisionChecker(const Shapes& shapes, double body_radius_m)
    : scene_(std::make_unique<Scene>()) {
  for (const Circle& circle : shapes.circles) {
    scene_->add(std::make_shared<fcl::Cylinderd>(circle.radius_m, kObstacleHeight_m),
                at(circle.center));
  }
  if (!shapes.segments.empty() || !shapes.polygons.empty()) {
    scene_->add(wall_mesh(shapes), fcl::Transform3d::Identity());
  }
  scene_->tree.setup();
  scene_->body = std::make_unique<fcl::CollisionObjectd>(
      std::make_shared<fcl::Cylinderd>(body_radius_m, kBodyHeight_m), fcl::Transform3d::Identity());
}

GroundTruthCollisionChecker::~GroundTruthCollisionChecker() = default;

bool GroundTruthCollisionChecker::touches(const Vec2& p_world) const {
  scene_->body->setTransform(at(p_world));
  scene_->body->computeAABB();
  fcl::DefaultCollisionData<double> contact;
  scene_->tree.collide(scene_->body.get(), &contact, fcl::DefaultCollisionFunction);
  return contact.result.isCollision();
}

}  // namespace voronaut
