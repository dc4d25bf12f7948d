#include <string>

#include "voronaut/tests/conformance/model_conformance.h"
#include "voronaut/tests/conformance/regulator_conformance.h"
#include "voronaut/tests/conformance/stable_regulator_conformance.h"

namespace voronaut::testing {
namespace {

const RegulatorPair kHovering[] = {
    {"quadrotor", "pd_rate"}, {"quadrotor_props", "pd_rate"}, {"ideal", "ideal"}};
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

}  // namespace
}  // namespace voronaut::testing
