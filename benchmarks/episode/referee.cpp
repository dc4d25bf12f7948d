#include "voronaut/benchmarks/episode/referee.h"

#include <cstdio>
#include <utility>

#include "voronaut/planners/navigation/navigation_report.h"

namespace voronaut {

namespace {

// Below this height the vehicle is taking off or has landed; what stands there is not judged.
constexpr double kGroundHeight_m = 0.5;

std::string at_text(const char* what, double now_s, const Vec2& p) {
  char text[160];
  std::snprintf(text, sizeof text, "%s at t = %.2f s, (%.3f, %.3f)", what, now_s, p.x(), p.y());
  return text;
}

}  // namespace

Referee::Referee(const Scenario& scenario, const VehicleSpec& vehicle, double shortest_length_m,
                 const LoopConfig& config, std::shared_ptr<const CollisionScene> contacts)
    : scenario_(scenario),
      config_(config),
      contacts_(contacts ? std::move(contacts) : CollisionScene::of(scenario.world->shapes()),
                vehicle.body_radius_m, vehicle.footprint),
      turns_(!vehicle.footprint.is_disc()),
      anchor_(scenario.start_world) {
  const double reference_m = std::isfinite(shortest_length_m)
                                 ? shortest_length_m
                                 : (scenario.goal_world - scenario.start_world).norm();
  time_limit_s_ = config.time_limit_base_s + config.time_limit_s_per_m * reference_m;
}

bool Referee::contact_at_start() const {
  return contacts_.touches(scenario_.start_world, scenario_.start_heading);
}

void Referee::judge(double now_s, const VehicleState& state) {
  const Vec2 p = state.p_world.head<2>();
  const bool judged_height =
      state.p_world.z() >= kGroundHeight_m || scenario_.cruise_height_m < kGroundHeight_m;
  if (judged_height && contacts_.touches(p, turns_ ? state.heading_world() : Vec2::UnitX())) {
    finish(now_s, Outcome::collision, at_text("touched an obstacle", now_s, p));
  } else if (!scenario_.world->bounds().contains(p)) {
    finish(now_s, Outcome::out_of_bounds, at_text("left the bounds", now_s, p));
  } else if (arrived_s_) {
    if (now_s - *arrived_s_ >= config_.goal_hold_s) {
      finish(*arrived_s_, Outcome::goal_reached, at_text("reached the goal", *arrived_s_, p));
    }
  } else if ((p - scenario_.goal_world).norm() <= scenario_.goal_tolerance_m) {
    arrived_s_ = now_s;
  } else {
    watch_progress(now_s, p);
  }
}

void Referee::watch_progress(double now_s, const Vec2& p) {
  if ((p - anchor_).norm() > config_.stuck_radius_m) {
    anchor_ = p;
    anchored_s_ = now_s;
  }
  if (now_s - anchored_s_ >= config_.stuck_after_s) {
    finish(now_s, Outcome::stuck, at_text("stood still", now_s, p) + refusal());
  } else if (now_s >= time_limit_s_) {
    finish(now_s, Outcome::timeout, at_text("time ran out", now_s, p) + refusal());
  }
}

std::string Referee::refusal() const {
  return refusal_.empty() ? "" : "; the planner refused: " + refusal_;
}

void Referee::hear(double now_s, const NavigationReport& report) {
  refusal_ = report.refusal;
  if (!report.infeasible.empty() && !verdict_ && !arrived_s_)
    finish(now_s, Outcome::infeasible, report.infeasible);
}

void Referee::finish(double now_s, Outcome outcome, std::string reason) {
  end_s_ = now_s;
  verdict_ = Verdict{outcome, std::move(reason)};
}

}  // namespace voronaut
