#include "voronaut/benchmarks/suite/footprint_entry.h"

#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/benchmarks/trial/trial_id.h"
#include "voronaut/tests/support/error_of.h"
#include "voronaut/tests/support/temporary_folder.h"

namespace voronaut {
namespace {

const std::string kOpen =
    "[{name: open, world: {}, bounds: [[-1, -1], [6, 6]], start: [0, 0], goal: [5, 5]}]";

std::string suite_text(const std::string& vehicle, const std::string& scenarios = kOpen) {
  return "suite: s\nscenarios: " + scenarios + "\nvehicles: [" + vehicle +
         "]\nplanners: [RRTConnect]\nnavigation: {yaw_policy: path}\n";
}

SuiteConfig read(const std::string& text, const std::string& file = "s.yaml") {
  return read_suite(ConfigNode::parse(text, file), "", PlannerCatalog::built_in());
}

std::string jackal(const std::string& rest) { return "{name: jackal, " + rest + "}"; }

const std::string kSquare = "polygon: [[0.2, 0.2], [-0.2, 0.2], [-0.2, -0.2], [0.2, -0.2]]";

VehicleSpec vehicle(const std::string& entry) {
  return read(suite_text(entry)).vehicles.front().vehicle;
}

std::string trial_id_of(const std::string& entry) {
  const SuiteConfig suite = read(suite_text(entry));
  SuiteTrials trials(suite);
  return trials.next()->spec.trial_id;
}

TEST(Footprint, IsADiscOrAPolygon) {
  const VehicleSpec disc = vehicle(jackal("footprint: {disc: 0.2}"));
  EXPECT_EQ(disc.body_radius_m, 0.2);
  EXPECT_TRUE(disc.footprint.is_disc());
  const VehicleSpec polygon = vehicle(jackal("footprint: {" + kSquare + "}"));
  EXPECT_EQ(polygon.footprint.corners_body.size(), 4U);
  EXPECT_NEAR(polygon.body_radius_m, 0.2 * std::sqrt(2), 1e-12);
  EXPECT_NEAR(polygon.inscribed_radius_m(), 0.2, 1e-12);
  EXPECT_EQ(polygon.planned_radius_m(), polygon.body_radius_m);
}

TEST(Footprint, TheDiscOfADiscIsTheBodysRadiusByAnotherName) {
  EXPECT_EQ(trial_id_of(jackal("footprint: {disc: 0.2}")),
            trial_id_of(jackal("params: {body_radius_m: 0.2}")));
}

TEST(Footprint, IsPartOfWhatDefinesATrial) {
  const std::set<std::string> ids = {
      trial_id_of(jackal("footprint: {disc: 0.28}")), trial_id_of(jackal("label: jackal")),
      trial_id_of(jackal("footprint: {" + kSquare + "}")),
      trial_id_of(jackal("footprint: {" + kSquare + ", planned_radius_m: 0.25}")),
      trial_id_of(jackal("footprint: {polygon: [[0.2, 0.2], [-0.2, 0.2], [0, -0.2]]}"))};
  EXPECT_EQ(ids.size(), 5U);
}

TEST(Footprint, MayBePlannedAsASmallerDiscIfTheVehicleSaysSo) {
  const std::string clearance = "params: {planning_clearance_m: 0.25}, ";
  const VehicleSpec smaller =
      vehicle(jackal(clearance + "footprint: {" + kSquare + ", planned_radius_m: 0.21}"));
  EXPECT_EQ(smaller.planned_radius_m(), 0.21);
  EXPECT_EQ(
      error_of<ConfigError>([&] { vehicle(jackal(clearance + "footprint: {" + kSquare + "}")); }),
      "s.yaml:3: key 'vehicles[0]': planning_clearance_m 0.25 is less than "
      "0.28284271247461906, the radius of the disc that holds its polygon (allowed: at least "
      "that, or a planned_radius_m that says that it is planned smaller)");
}

TEST(Footprint, SaysWhereAndWhatIsWrong) {
  const auto error = [](const std::string& entry) {
    return error_of<ConfigError>([&] { vehicle(entry); });
  };
  EXPECT_EQ(error(jackal("footprint: {polygon: [[1, 0], [0, 1]]}")),
            "s.yaml:3: key 'vehicles[0].footprint.polygon': the polygon has fewer than 3 vertices "
            "(allowed: the corners of a strictly convex polygon around [0, 0])");
  EXPECT_EQ(error(jackal("footprint: {polygon: [[1, 0], [0, 1], [1]]}")),
            "s.yaml:3: key 'vehicles[0].footprint.polygon[2]': expected [x, y], got a list of 1");
  EXPECT_EQ(error(jackal("footprint: {disc: 0.2, " + kSquare + "}")),
            "s.yaml:3: key 'vehicles[0].footprint.polygon': cannot stand beside disc (allowed: "
            "disc, or polygon, or of_scenario)");
  EXPECT_EQ(error(jackal("footprint: {}")),
            "s.yaml:3: key 'vehicles[0].footprint': says no body (allowed: disc, or polygon, or "
            "of_scenario)");
  EXPECT_EQ(error(jackal("footprint: {disk: 0.2}")),
            "s.yaml:3: key 'vehicles[0].footprint.disk': unknown key (allowed: disc, polygon, "
            "of_scenario, planned_radius_m; did you mean 'disc'?)");
  EXPECT_EQ(error(jackal("footprint: {disc: -1}")),
            "s.yaml:3: key 'vehicles[0].footprint.disc': expected a number from 0.001 to 10, got "
            "'-1'");
  EXPECT_EQ(error(jackal("params: {body_radius_m: 0.2}, footprint: {disc: 0.2}")),
            "s.yaml:3: key 'vehicles[0].params.body_radius_m': cannot stand beside footprint "
            "(allowed: one of them)");
  EXPECT_EQ(error(jackal("footprint: {" + kSquare + ", planned_radius_m: 0.1}")),
            "s.yaml:3: key 'vehicles[0].footprint.planned_radius_m': expected at least the radius "
            "of the largest disc about the origin within the polygon, 0.2, got 0.1");
  EXPECT_EQ(error("{name: ideal, footprint: {" + kSquare + ", planned_radius_m: 0.22}}"),
            "s.yaml:3: key 'vehicles[0].footprint.planned_radius_m': is for what drives along its "
            "heading: vehicle 'ideal' may go sideways as well");
}

class FootprintOfScenario : public ::testing::Test {
 protected:
  SuiteConfig read_with_robot(const std::string& shape, const std::string& rest = "") {
    std::ofstream(folder_.path() / "w.yaml")
        << "robot: {state: [2, 2, 0], goal: [8, 8, 0], shape: " << shape << "}\n";
    return read(suite_text(jackal(rest + "footprint: {of_scenario: true}"),
                           "[{world_file: w.yaml, format: ir_sim}]"),
                (folder_.path() / "s.yaml").string());
  }

  TemporaryFolder folder_;
};

TEST_F(FootprintOfScenario, IsThatOfItsFilesRobot) {
  const SuiteConfig suite =
      read_with_robot("{name: rectangle, length: 0.5, width: 0.3}", "label: a, ");
  SuiteTrials trials(suite);
  const VehicleSpec flown = trials.next()->spec.vehicle;
  ASSERT_EQ(flown.footprint.corners_body.size(), 4U);
  EXPECT_NEAR(flown.body_radius_m, std::hypot(0.25, 0.15), 1e-12);
  const SuiteConfig of_disc = read_with_robot("{name: circle, radius: 0.15}");
  SuiteTrials disc_trials(of_disc);
  EXPECT_EQ(disc_trials.next()->spec.vehicle.body_radius_m, 0.15);
}

TEST_F(FootprintOfScenario, MustBeToldAndWithinTheClearance) {
  const std::string place =
      (folder_.path() / "s.yaml").string() + ":3: key 'vehicles[0].footprint.of_scenario': ";
  EXPECT_EQ(error_of<ConfigError>(
                [&] { read_with_robot("{name: polygon, vertices: [[1, 0], [2, 0], [1, 1]]}"); }),
            place + "scenario 'w' tells of no robot's body");
  EXPECT_EQ(error_of<ConfigError>([&] { read_with_robot("{name: circle, radius: 0.5}"); }),
            place + "in scenario 'w' its planning_clearance_m 0.35 is less than body_radius_m 0.5");
}

}  // namespace
}  // namespace voronaut
