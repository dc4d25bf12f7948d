#include <set>
#include <string>
#include <vector>

#include "voronaut/tests/conformance/hard_pressed_regulator_conformance.h"
#include "voronaut/tests/conformance/model_conformance.h"
#include "voronaut/tests/conformance/regulator_conformance.h"
#include "voronaut/tests/conformance/stable_regulator_conformance.h"

namespace voronaut::testing {
namespace {

const RegulatorPair kHovering[] = {{"quadrotor", "pd_rate"},       {"quadrotor", "cascade_pid"},
                                   {"quadrotor", "se3"},           {"quadrotor", "lqr"},
                                   {"quadrotor_props", "pd_rate"}, {"ideal", "ideal"}};
// What hovering asks for beyond that, the tests of what drives on wheels ask in its place.
const RegulatorPair kWheeled[] = {{"car", "car_tracker"},
                                  {"cart", "position_trajectory"},
                                  {"jackal", "arc_tracker"},
                                  {"unicycle", "arc_tracker"}};
const RegulatorPair kUnstable[] = {{"quadrotor", "paper_literal"}};

std::string pair_name(const ::testing::TestParamInfo<RegulatorPair>& info) {
  return info.param.vehicle + "_" + info.param.regulator;
}

std::string vehicle_name(const ::testing::TestParamInfo<std::string>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(Catalog, ModelConformance, ::testing::ValuesIn(vehicle_names()),
                         vehicle_name);
INSTANTIATE_TEST_SUITE_P(Hovering, RegulatorConformance, ::testing::ValuesIn(kHovering), pair_name);
INSTANTIATE_TEST_SUITE_P(Wheeled, RegulatorConformance, ::testing::ValuesIn(kWheeled), pair_name);
INSTANTIATE_TEST_SUITE_P(Literal, RegulatorConformance, ::testing::ValuesIn(kUnstable), pair_name);
INSTANTIATE_TEST_SUITE_P(Hovering, HolonomicRegulatorConformance, ::testing::ValuesIn(kHovering),
                         pair_name);
INSTANTIATE_TEST_SUITE_P(Literal, HolonomicRegulatorConformance, ::testing::ValuesIn(kUnstable),
                         pair_name);
INSTANTIATE_TEST_SUITE_P(Hovering, StableRegulatorConformance, ::testing::ValuesIn(kHovering),
                         pair_name);
INSTANTIATE_TEST_SUITE_P(Wheeled, StableRegulatorConformance, ::testing::ValuesIn(kWheeled),
                         pair_name);
INSTANTIATE_TEST_SUITE_P(Hovering, HoveringRegulatorConformance, ::testing::ValuesIn(kHovering),
                         pair_name);
INSTANTIATE_TEST_SUITE_P(Hovering, HeldBackRegulatorConformance, ::testing::ValuesIn(kHovering),
                         pair_name);

// Whoever adds a regulator finds here that it passes nothing yet.
TEST(Conformance, NamesEveryRegulatorOfTheCatalogue) {
  std::set<std::string> named;
  for (const RegulatorPair& pair : kHovering) named.insert(pair.regulator);
  for (const RegulatorPair& pair : kWheeled) named.insert(pair.regulator);
  for (const RegulatorPair& pair : kUnstable) named.insert(pair.regulator);
  const std::vector<std::string> all = regulator_names();
  EXPECT_EQ(named, std::set<std::string>(all.begin(), all.end()));
}

}  // namespace
}  // namespace voronaut::testing
