#include "voronaut/benchmarks/episode/ground_truth_collision_checker.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
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

fcl::Transform3d at(const Vec2& p, const Vec2& heading = Vec2::UnitX()) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.linear().topLeftCorner<2, 2>() << heading.x(), -heading.y(), heading.y(), heading.x();
  pose.translation() = fcl::Vector3d(p.x(), p.y(), 0);
  return pose;
}

// The polygon from below to above; FCL's faces are lists of corners after their number, each
// counter-clockwise as seen from outside.
std::shared_ptr<fcl::CollisionGeometryd> prism(const std::vector<Vec2>& corners) {
  const int n = static_cast<int>(corners.size());
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const double z : {-0.5 * kBodyHeight_m, 0.5 * kBodyHeight_m})
    for (const Vec2& corner : corners) vertices->emplace_back(corner.x(), corner.y(), z);
  auto faces = std::make_shared<std::vector<int>>();
  faces->push_back(n);
  for (int i = n - 1; i >= 0; --i) faces->push_back(i);
  faces->push_back(n);
  for (int i = 0; i < n; ++i) faces->push_back(n + i);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    faces->insert(faces->end(), {4, i, next, n + next, n + i});
  }
  return std::make_shared<fcl::Convexd>(vertices, n + 2, faces, true);
}

std::shared_ptr<fcl::CollisionGeometryd> geometry_of(double radius_m, const Footprint& footprint) {
  if (footprint.is_disc()) return std::make_shared<fcl::Cylinderd>(radius_m, kBodyHeight_m);
  return prism(footprint.corners_body);
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
  Body(double radius_m, const Footprint& footprint)
      : object(geometry_of(radius_m, footprint), fcl::Transform3d::Identity()) {}

  bool touches(const FclScene& scene, const fcl::Transform3d& pose) {
    object.setTransform(pose);
    object.computeAABB();
    return scene.touches(object);
  }

  fcl::CollisionObjectd object;
};

// A body around the body: as long as it touches nothing where it stands, what moves within it does
// not either.
struct GroundTruthCollisionChecker::Surroundings {
  explicit Surroundings(double radius_m) : body(radius_m + kRoom_m, {}) {}

  // True: nothing touches a body at p, says the larger one. False: ask the body itself.
  bool are_clear(const FclScene& scene, const Vec2& p_world) {
    const double moved_sq = (p_world - center_world).squaredNorm();
    const double holds_m = clear ? kRoom_m - kTolerance_m : kAgain_m;
    if (moved_sq < holds_m * holds_m) return clear;
    center_world = p_world;
    clear = !body.touches(scene, at(p_world));
    return clear;
  }

  static constexpr double kRoom_m = 0.25;
  static constexpr double kTolerance_m = 1e-3;  // FCL's is 1e-5
  static constexpr double kAgain_m = 0.1;       // moved before it is asked once more
  Body body;
  Vec2 center_world = Vec2::Constant(kInfinity);
  bool clear = false;
};

GroundTruthCollisionChecker::GroundTruthCollisionChecker(const Shapes& shapes, double body_radius_m,
                                                         const Footprint& footprint)
    : GroundTruthCollisionChecker(CollisionScene::of(shapes), body_radius_m, footprint) {}

GroundTruthCollisionChecker::GroundTruthCollisionChecker(
    std::shared_ptr<const CollisionScene> scene, double body_radius_m, const Footprint& footprint)
    : scene_(std::move(scene)),
      body_(std::make_unique<Body>(body_radius_m, footprint)),
      surroundings_(std::make_unique<Surroundings>(body_radius_m)) {}

GroundTruthCollisionChecker::~GroundTruthCollisionChecker() = default;

bool GroundTruthCollisionChecker::touches(const Vec2& p_world, const Vec2& heading_world) const {
  const auto& scene = static_cast<const FclScene&>(*scene_);
  return !surroundings_->are_clear(scene, p_world) &&
         body_->touches(scene, at(p_world, heading_world));
}

}  // namespace voronaut
