#include "voronaut/planners/problem/fcl_validity_checker.h"

#include <algorithm>
#include <vector>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <ompl/base/SpaceInformation.h>

#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;

namespace {

using Object = fcl::CollisionObjectd;

// FCL has no distance to a point; this is as good as one.
constexpr double kProbeRadius_m = 1e-6;

fcl::Transform3d placed_at(const Vec2& p) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.translation() = fcl::Vector3d(p.x(), p.y(), 0);
  return pose;
}

// FCL's capsule lies along its z axis, centred: turn that into the direction from a to b.
fcl::Transform3d laid_along(const Vec2& a, const Vec2& b) {
  fcl::Transform3d pose = placed_at(0.5 * (a + b));
  const Vec2 d = (b - a).normalized();
  fcl::Matrix3d axes;
  axes.col(0) = fcl::Vector3d(0, 0, 1);
  axes.col(1) = fcl::Vector3d(d.y(), -d.x(), 0);
  axes.col(2) = fcl::Vector3d(d.x(), d.y(), 0);
  pose.linear() = axes;
  return pose;
}

}  // namespace

struct FclValidityChecker::Scene {
  std::shared_ptr<fcl::Sphered> point = std::make_shared<fcl::Sphered>(kPointRadius_m);
  std::vector<std::unique_ptr<Object>> objects;
  fcl::DynamicAABBTreeCollisionManagerd tree;

  void add(const Vec2& p) {
    objects.push_back(std::make_unique<Object>(point, placed_at(p)));
    tree.registerObject(objects.back().get());
  }

  void restart() {
    tree.clear();
    objects.clear();
  }

  bool touches(Object& body) {
    if (objects.empty()) return false;
    body.computeAABB();
    fcl::DefaultCollisionData<double> data;
    tree.collide(&body, &data, fcl::DefaultCollisionFunction<double>);
    return data.result.isCollision();
  }
};

FclValidityChecker::FclValidityChecker(const ob::SpaceInformationPtr& si,
                                       double planning_clearance_m)
    : StateValidityChecker(si),
      planning_clearance_m_(planning_clearance_m),
      relaxation_(planning_clearance_m),
      scene_(std::make_unique<Scene>()) {
  specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
}

FclValidityChecker::~FclValidityChecker() = default;

void FclValidityChecker::look_at(const ObstacleSnapshot& obstacles, const Vec2& start_world) {
  scene_->restart();
  for (const Vec2& p : obstacles.points()) scene_->add(p);
  scene_->tree.setup();
  obstacles_ = obstacles;
  relaxation_ = StartRelaxation(planning_clearance_m_, start_world, clearance_m(start_world));
}

bool FclValidityChecker::isValid(const ob::State* state) const {
  if (!si_->satisfiesBounds(state)) return false;
  const Vec2 p = position_of(*si_->getStateSpace(), state);
  return motion_is_clear(p, p);
}

double FclValidityChecker::clearance(const ob::State* state) const {
  return clearance_m(position_of(*si_->getStateSpace(), state));
}

double FclValidityChecker::clearance_m(const Vec2& p) const {
  const double horizon_m = si_->getMaximumExtent();
  if (scene_->objects.empty()) return horizon_m;
  Object centre(std::make_shared<fcl::Sphered>(kProbeRadius_m), placed_at(p));
  centre.computeAABB();
  fcl::DefaultDistanceData<double> data;
  scene_->tree.distance(&centre, &data, fcl::DefaultDistanceFunction<double>);
  if (data.result.min_distance <= 0) return 0;
  return std::min(horizon_m, data.result.min_distance + kPointRadius_m + kProbeRadius_m);
}

bool FclValidityChecker::motion_is_clear(const Vec2& a, const Vec2& b) const {
  const ClearancePieces pieces = relaxation_.split(a, b);
  return std::none_of(pieces.piece.begin(), pieces.piece.begin() + pieces.count,
                      [&](const ClearancePiece& piece) {
                        const double radius_m = piece.clearance_m - kPointRadius_m;
                        if (radius_m <= 0) return false;
                        const double length_m = (piece.b - piece.a).norm();
                        if (length_m == 0) {
                          Object disc(std::make_shared<fcl::Sphered>(radius_m), placed_at(piece.a));
                          return scene_->touches(disc);
                        }
                        Object swept(std::make_shared<fcl::Capsuled>(radius_m, length_m),
                                     laid_along(piece.a, piece.b));
                        return scene_->touches(swept);
                      });
}

}  // namespace voronaut
