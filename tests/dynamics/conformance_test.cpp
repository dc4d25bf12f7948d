#include <string>

#include "voronaut/tests/conformance/model_conformance.h"
#include "voronaut/tests/conformance/regulator_conformance.h"
#include "voronaut/tests/conformance/stable_regulator_conformance.h"

namespace voronaut::testing {
namespace {

const RegulatorPair kStable[] = {
    {"quadrotor", "pd_rate"}, {"quadrotor_props", "pd_rate"}, {"ideal", "ideal"}};
const RegulatorPair kUnstable[] = {{"quadrotor", "paper_literal"}};

std::string pair_name(const ::testing::TestParamInfo<RegulatorPair>& info) {
  return info.param.vehicle + "_" + info.param.regulator;
}

std::string vehicle_name(const ::testing::TestParamInfo<std::string>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(Catalog, ModelConformance, ::testing::ValuesIn(vehicle_names()),
                         vehicle_name);
INSTANTIATE_TEST_SUITE_P(Catalog, RegulatorConformance, ::testing::ValuesIn(kStable), pair_name);
INSTANTIATE_TEST_SUITE_P(Literal, RegulatorConformance, ::testing::ValuesIn(kUnstable), pair_name);
INSTANTIATE_TEST_SUITE_P(Catalog, StableRegulatorConformance, ::testing::ValuesIn(kStable),
                         pair_name);

}  // namespace
}  // namespace voronaut::testing
