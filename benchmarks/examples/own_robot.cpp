#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>
#include <sstream>

#include "voronaut/planners/navigation/navigator.h"

// A robot of one's own: scans go into the navigator, setpoints come out. Here the scans come from a
// log (`own_robot own_robot.log`), so what comes out moves nobody; on a robot they come from its
// driver and the setpoints go to its wheels (docs/embedding.md).
using namespace voronaut;

constexpr double kMaxRange_m = 8;

// A cart of 0.2 m radius that looks half around, on its way along a corridor.
NavigatorConfig corridor_robot() {
  NavigatorConfig config;
  config.mission = {.start_world = Vec2(0, 0),
                    .goal_world = Vec2(8, 0),
                    .cruise_height_m = 0,
                    .bounds_world = {Vec2(-1, -3), Vec2(10, 3)}};
  config.vehicle.body_radius_m = 0.2;
  config.vehicle.planning_clearance_m = 0.3;
  config.vehicle.steering = Steering::along_heading;
  config.vehicle.limits.max_speed_m_s = 1;
  config.range_finder = {.field_of_view_rad = std::numbers::pi, .period_s = 0.5};
  config.planner = "VoronoiRoadmap";
  config.navigation = NavigationConfig::paper();  // no governor: how this cart stops is not known
  config.navigation.yaw_policy = YawReference::path;
  config.navigation.speed_rule = SpeedRule::stopping_distance;
  return config;
}

// A line of CARMEN's log: FLASER n r_1 .. r_n x y theta ..., beams from right to left. False if it
// is another one.
bool read_flaser(const std::string& line, Scan& scan, VehicleState& state) {
  std::istringstream words(line);
  std::string kind;
  std::size_t beams = 0;
  if (!(words >> kind >> beams) || kind != "FLASER") return false;
  scan.range_m.resize(beams);
  for (double& range_m : scan.range_m) words >> range_m;
  double x_m = 0, y_m = 0, theta_rad = 0;
  if (!(words >> x_m >> y_m >> theta_rad)) return false;
  scan.beams = std::make_shared<BeamFan>(BeamFan::spread(std::numbers::pi, beams));
  scan.max_range_m = kMaxRange_m;
  scan.sensor_world = {Vec2(x_m, y_m), Vec2(std::cos(theta_rad), std::sin(theta_rad))};
  state.p_world = Vec3(x_m, y_m, 0);
  state.q_world_body = Eigen::AngleAxisd(theta_rad, Vec3::UnitZ());
  return true;
}

void print(const NavigationReport& report) {
  std::cout << to_string(report.executive) << " ";
  const auto& motion = report.setpoint.motion;
  if (const auto* pass = std::get_if<PassTarget>(&motion))
    std::cout << "pass " << pass->p_world.transpose() << " at " << pass->speed_limit_m_s << " m/s";
  if (const auto* rest = std::get_if<RestAtTarget>(&motion))
    std::cout << "rest at " << rest->p_world.transpose();
  if (const auto* command = std::get_if<VelocityCommand>(&motion))
    std::cout << "velocity " << command->v_world_m_s.transpose() << " m/s";
  if (const auto* arc = std::get_if<ArcCommand>(&motion))
    std::cout << "arc " << arc->v_m_s << " m/s, " << arc->w_rad_s << " rad/s";
  std::cout << "\n";
}

int main(int argc, char** argv) {
  std::ifstream log(argc == 2 ? argv[1] : "");
  if (!log) return std::cerr << "usage: own_robot LOG\n", 2;
  Navigator navigator(corridor_robot(), PlannerCatalog::built_in());
  Scan scan;
  VehicleState state;
  double now_s = 0;
  for (std::string line; std::getline(log, line);) {
    if (!read_flaser(line, scan, state)) continue;
    navigator.update(scan, state, now_s);
    print(navigator.report());
    now_s += 0.5;
  }
  return navigator.path().empty() ? 1 : 0;
}
