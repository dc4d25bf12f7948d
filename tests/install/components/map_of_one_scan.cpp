#include <iostream>

#include "voronaut/dynamics/stopping.h"
#include "voronaut/planners/mapping/obstacle_base.h"

// A post 2 m ahead, seen once, and how far a vehicle at 1 m/s runs on before it stands.
int main() {
  voronaut::Scan scan;
  auto beams = std::make_shared<voronaut::BeamFan>(voronaut::BeamFan::spread(0.2, 3));
  scan.sensor_world.heading = {1, 0};
  scan.beams = beams;
  scan.max_range_m = 5;
  scan.range_m = {2, 2, 5};
  voronaut::ObstacleBase base({});
  const auto& report = base.update(scan);
  const double run_m = voronaut::stopping_distance_m(1, 2, 5);
  std::cout << report.points_added << " points, stops within " << run_m << " m\n";
  return report.points_added == 2 && run_m > 0 && run_m < 2 ? 0 : 1;
}
