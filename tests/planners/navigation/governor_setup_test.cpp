#include "voronaut/planners/navigation/governor_setup.h"

#include <gtest/gtest.h>

#include "voronaut/dynamics/catalog.h"

namespace voronaut {
namespace {

NavigatorConfig governed(const std::string& vehicle, double beside_body_m) {
  const VehicleSpec spec = find_vehicle(vehicle);
  NavigatorConfig config;
  config.navigation.governor = true;
  config.vehicle.body_radius_m = spec.body_radius_m;
  config.vehicle.planning_clearance_m = spec.body_radius_m + beside_body_m;
  if (!mobility_of(spec).moves_sideways) config.vehicle.steering = Steering::along_heading;
  config.vehicle.motion_response = motion_response(find_regulator(spec.regulator), spec, 0.01);
  return config;
}

TEST(GovernorSetup, KnowsAsFinelyAsThePlanningClearanceNeedsIt) {
  for (const char* name : {"ideal", "quadrotor", "unicycle", "jackal", "cart", "car"}) {
    double finer_m = 0;
    for (const double beside_body_m : {0.03, 0.04, 0.06, 0.08, 0.1, 0.12, 0.15, 0.2}) {
      const FreeSpace free = free_space_of(governed(name, beside_body_m));
      EXPECT_GE(free.part_m(), 0.0125) << name << " " << beside_body_m;
      EXPECT_LE(free.part_m(), 0.05) << name << " " << beside_body_m;
      EXPECT_GE(free.part_m(), finer_m) << name << " " << beside_body_m;
      EXPECT_LE(free.cell_m(), 0.1) << name << " " << beside_body_m;
      finer_m = free.part_m();
    }
    EXPECT_EQ(free_space_of(governed(name, 0.2)).part_m(), 0.05) << name;
  }
  EXPECT_EQ(free_space_of(governed("ideal", 0.04)).part_m(), 0.0125);
  EXPECT_EQ(free_space_of(governed("ideal", 0.04)).cell_m(), 0.1);
}

TEST(GovernorSetup, KnowsNothingFinelyWhereNobodyGoverns) {
  NavigatorConfig config = governed("ideal", 0.04);
  config.navigation.governor = false;
  EXPECT_FALSE(governor_of(config));
  EXPECT_EQ(free_space_of(config).part_m(), free_space_of(config).cell_m());
}

}  // namespace
}  // namespace voronaut
