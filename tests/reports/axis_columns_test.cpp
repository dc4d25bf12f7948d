#include "voronaut/reports/axis_columns.h"

#include <gtest/gtest.h>

namespace voronaut {
namespace {

const std::vector<AxisColumn> kAxes = {{"vehicle.max_speed_m_s",
                                        "vehicle",
                                        true,
                                        {{"q a=0.1", "0.1"}, {"q a=fast", "fast"}},
                                        {},
                                        {{"q a=0.1", "q"}, {"q a=fast", "q"}}},
                                       {"scenario.side_m",
                                        "scenario",
                                        false,
                                        {{"wood-6", "6"}},
                                        {{"trees-6", "6"}},
                                        {{"trees-6", "trees"}}}};

TEST(AxisColumns, TellTheValueByTheNameInTheirColumn) {
  RunRecord record;
  record.scenario = "wood-6";
  record.scenario_group = "trees-6";
  record.vehicle = "q a=fast";
  EXPECT_EQ(kAxes[0].value_of(record), "fast");
  EXPECT_EQ(kAxes[1].value_of(record), "6");
  record.vehicle = record.scenario = "another";
  EXPECT_EQ(kAxes[0].value_of(record), "");
  EXPECT_EQ(kAxes[1].value_of(record), "");
  EXPECT_EQ(kAxes[1].value_of("trees-6", "q", "p"), "6");
  EXPECT_EQ(kAxes[0].value_of("trees-6", "q a=0.1", "p"), "0.1");
}

TEST(AxisColumns, AreTheSameAfterTheirJson) {
  const auto back = axis_columns(axis_columns_json(kAxes));
  ASSERT_EQ(back.size(), kAxes.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_EQ(back[i].path, kAxes[i].path);
    EXPECT_EQ(back[i].column, kAxes[i].column);
    EXPECT_EQ(back[i].zipped, kAxes[i].zipped);
    EXPECT_EQ(back[i].values, kAxes[i].values);
    EXPECT_EQ(back[i].groups, kAxes[i].groups);
    EXPECT_EQ(back[i].bases, kAxes[i].bases);
  }
  EXPECT_TRUE(axis_columns("").empty());
}

}  // namespace
}  // namespace voronaut
