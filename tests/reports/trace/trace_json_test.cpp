#include "voronaut/reports/trace/trace_json.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/tests/reports/synthetic_run.h"

namespace voronaut {
namespace {

constexpr double kHalfMm = 0.0005 + 1e-9;

void expect_points_near(const std::vector<TracePoint>& a, const std::vector<TracePoint>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i].x_m, b[i].x_m, kHalfMm);
    EXPECT_NEAR(a[i].y_m, b[i].y_m, kHalfMm);
  }
}

void expect_frames_near(const TraceFrame& a, const TraceFrame& b) {
  EXPECT_NEAR(a.t_s, b.t_s, kHalfMm);
  EXPECT_NEAR(a.x_m, b.x_m, kHalfMm);
  EXPECT_NEAR(a.y_m, b.y_m, kHalfMm);
  EXPECT_NEAR(a.z_m, b.z_m, kHalfMm);
  EXPECT_NEAR(a.vx_m_s, b.vx_m_s, kHalfMm);
  EXPECT_NEAR(a.vy_m_s, b.vy_m_s, kHalfMm);
  EXPECT_NEAR(a.heading_x, b.heading_x, 0.5e-4 + 1e-9);
  EXPECT_NEAR(a.heading_y, b.heading_y, 0.5e-4 + 1e-9);
  EXPECT_NEAR(a.tilt_rad, b.tilt_rad, 0.5e-4 + 1e-9);
  EXPECT_NEAR(a.clearance_m, b.clearance_m, kHalfMm);
  EXPECT_NEAR(a.planning_time_us, b.planning_time_us, 0.05 + 1e-9);
  EXPECT_NEAR(a.target_x_m, b.target_x_m, kHalfMm);
  EXPECT_NEAR(a.target_y_m, b.target_y_m, kHalfMm);
  for (std::size_t k = 0; k < a.actuators.size(); ++k) {
    EXPECT_NEAR(a.actuators[k], b.actuators[k], 0.005 + 1e-9);
  }
  EXPECT_EQ(a.mode, b.mode);
  EXPECT_EQ(a.plan, b.plan);
  EXPECT_EQ(a.known_points, b.known_points);
  EXPECT_EQ(a.search, b.search);
  EXPECT_EQ(a.replan, b.replan);
  EXPECT_EQ(a.solve_end, b.solve_end);
  EXPECT_NEAR(a.speed_scale, b.speed_scale, 0.5e-3 + 1e-9);
  expect_points_near(a.tube, b.tube);
  ASSERT_EQ(a.range_m.size(), b.range_m.size());
  for (std::size_t k = 0; k < a.range_m.size(); ++k) {
    ASSERT_NEAR(a.range_m[k], b.range_m[k], 0.005 + 1e-6);
  }
}

void expect_lists_equal(const Trace& a, const Trace& b) {
  ASSERT_EQ(a.merges.size(), b.merges.size());
  for (std::size_t i = 0; i < a.merges.size(); ++i) {
    EXPECT_EQ(a.merges[i].frame, b.merges[i].frame);
    EXPECT_EQ(a.merges[i].from, b.merges[i].from);
    EXPECT_EQ(a.merges[i].into, b.merges[i].into);
  }
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    EXPECT_EQ(a.edges[i].first_search, b.edges[i].first_search);
    EXPECT_EQ(a.edges[i].last_search, b.edges[i].last_search);
    expect_points_near({a.edges[i].a, a.edges[i].b}, {b.edges[i].a, b.edges[i].b});
  }
}

TEST(TraceJson, KeepsEverythingAtTheStatedResolution) {
  for (const Trace& trace : synthetic::make_run().traces) {
    const Trace back = decompress_trace(compress_trace(trace));
    EXPECT_EQ(back.trial_id, trace.trial_id);
    EXPECT_EQ(back.body_radius_m, trace.body_radius_m);
    EXPECT_EQ(back.clearance_min_m, trace.clearance_min_m);
    EXPECT_EQ(back.field_of_view_rad, trace.field_of_view_rad);
    EXPECT_EQ(back.max_range_m, trace.max_range_m);
    EXPECT_EQ(back.modes, trace.modes);
    EXPECT_EQ(back.replan_reasons, trace.replan_reasons);
    EXPECT_EQ(back.solve_ends, trace.solve_ends);
    EXPECT_EQ(back.searches, trace.searches);
    EXPECT_EQ(back.kept_searches, trace.kept_searches);
    EXPECT_EQ(back.cluster_of, trace.cluster_of);
    expect_lists_equal(back, trace);
    expect_points_near(back.known_points, trace.known_points);
    ASSERT_EQ(back.plans.size(), trace.plans.size());
    for (std::size_t i = 0; i < back.plans.size(); ++i) {
      expect_points_near(back.plans[i], trace.plans[i]);
    }
    ASSERT_EQ(back.hulls.size(), trace.hulls.size());
    for (std::size_t i = 0; i < back.hulls.size(); ++i) {
      expect_points_near(back.hulls[i], trace.hulls[i]);
    }
    ASSERT_EQ(back.frames.size(), trace.frames.size());
    for (std::size_t i = 0; i < back.frames.size(); ++i) {
      expect_frames_near(back.frames[i], trace.frames[i]);
    }
  }
}

TEST(TraceJson, KeepsAPolygonAndSaysNothingOfADisc) {
  Trace trace;
  EXPECT_EQ(trace_to_json(trace).find("footprint"), std::string::npos);
  trace.footprint = {{0.229, 0.208}, {-0.229, 0.208}, {-0.229, -0.208}};
  expect_points_near(decompress_trace(compress_trace(trace)).footprint, trace.footprint);
}

TEST(TraceJson, KeepsWhatAStaticPlanCost) {
  Trace trace;
  trace.static_planning = true;
  trace.improvements = {{100, 0.0012, 15.25}, {250, 0.004001, 14.5}};
  const Trace back = decompress_trace(compress_trace(trace));
  EXPECT_TRUE(back.static_planning);
  ASSERT_EQ(back.improvements.size(), 2U);
  EXPECT_EQ(back.improvements[1].state_checks, 250);
  EXPECT_NEAR(back.improvements[1].time_s, 0.004001, 1e-9);
  EXPECT_NEAR(back.improvements[1].cost_m, 14.5, 1e-9);
}

TEST(TraceJson, RoundingDoesNotAddUpAlongATrajectory) {
  Trace trace;
  for (int i = 0; i < 10'000; ++i) {
    TraceFrame frame;
    frame.x_m = 0.0004 * i;
    trace.frames.push_back(frame);
  }
  EXPECT_NEAR(decompress_trace(compress_trace(trace)).frames.back().x_m, 0.0004 * 9999, kHalfMm);
}

TEST(TraceJson, WritesWhatItsHeaderSays) {
  Trace trace;
  trace.trial_id = "t";
  trace.max_range_m = 2.5;
  trace.known_points = {{1.0, 2.0}, {1.5, 1.0}};
  trace.frames.resize(2);
  trace.frames[0].x_m = 1.0;
  trace.frames[1].x_m = 1.25;
  trace.frames[0].range_m = {1.0F, 2.5F, 0.5F};
  const std::string json = trace_to_json(trace);
  EXPECT_THAT(json, ::testing::HasSubstr(R"("x_mm":[1000,250])"));
  EXPECT_THAT(json, ::testing::HasSubstr(R"("known_points":[1000,2000,500,-1000])"));
  EXPECT_THAT(json, ::testing::HasSubstr(R"("range_cm":[[100,-101,51],[]])"));
}

TEST(TraceJson, ANumberThatIsNotFiniteReadsBackAsNan) {
  Trace trace;
  trace.frames.resize(3);
  trace.frames[1].clearance_m = std::numeric_limits<double>::infinity();
  trace.frames[1].planning_time_us = std::numeric_limits<double>::quiet_NaN();
  trace.frames[2].clearance_m = 0.5;
  const Trace back = decompress_trace(compress_trace(trace));
  EXPECT_TRUE(std::isnan(back.frames[1].clearance_m));
  EXPECT_TRUE(std::isnan(back.frames[1].planning_time_us));
  EXPECT_NEAR(back.frames[2].clearance_m, 0.5, kHalfMm);
}

TEST(TraceJson, ARangeWithoutAReturnReadsBackAsTheMaximum) {
  Trace trace;
  trace.max_range_m = 2.5;
  trace.frames.resize(1);
  trace.frames[0].range_m = {2.5F, 99.0F, 1.23F, std::numeric_limits<float>::infinity()};
  const auto back = decompress_trace(compress_trace(trace)).frames[0].range_m;
  EXPECT_THAT(back, ::testing::ElementsAre(2.5F, 2.5F, ::testing::FloatNear(1.23F, 1e-5F), 2.5F));
}

TEST(TraceJson, TakesLittleRoom) {
  // 15 MB of HTML hold 200 replays if one stays below 55 kB.
  for (const Trace& trace : synthetic::make_run().traces) {
    EXPECT_LT(compress_trace(trace).size(), 55'000U);
  }
}

TEST(TraceJson, RefusesWhatItDoesNotWrite) {
  Trace trace;
  trace.frames.resize(2);
  const std::string good = trace_to_json(trace);
  EXPECT_NO_THROW(trace_from_json(good));
  const auto broken = [&good](const std::string& from, const std::string& to) {
    std::string text = good;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  EXPECT_THROW(trace_from_json(""), std::invalid_argument);
  EXPECT_THROW(trace_from_json("[]"), std::invalid_argument);
  EXPECT_THROW(trace_from_json(broken(R"("version":4)", R"("version":3)")), std::invalid_argument);
  EXPECT_THROW(trace_from_json(broken(R"("x_mm":[0,0])", R"("x_mm":[0])")), std::invalid_argument);
  EXPECT_THROW(trace_from_json(broken(R"("mode":[-1)", R"("mode":[null)")), std::invalid_argument);
  EXPECT_THROW(trace_from_json(broken(R"("known":[0)", R"("known":[-5)")), std::invalid_argument);
  EXPECT_THROW(trace_from_json(broken(R"("merges":[])", R"("merges":[1])")), std::invalid_argument);
  EXPECT_THROW(trace_from_json(broken(R"("ends_cm":[])", R"("ends_cm":[1,2])")),
               std::invalid_argument);
  EXPECT_THROW(trace_from_json(broken(R"("tube_mm":[[],[]])", R"("tube_mm":[[],[1]])")),
               std::invalid_argument);
  EXPECT_THROW(trace_from_json(broken(R"("tube_mm":[[],[]])", R"("tube_mm":[[]])")),
               std::invalid_argument);
  EXPECT_THROW(decompress_trace("not deflate"), std::invalid_argument);
}

TEST(WorldJson, KeepsTheWorldAtATenthOfAMillimetre) {
  TraceWorld world = synthetic::make_world("w\"</script>", 5, 6);
  const TraceWorld back = world_from_json(world_to_json(world));
  EXPECT_EQ(back.world_id, world.world_id);
  ASSERT_EQ(back.circles.size(), world.circles.size());
  for (std::size_t i = 0; i < world.circles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(back.circles[i][k], world.circles[i][k], 0.5e-4 + 1e-9);
    }
  }
  ASSERT_EQ(back.polygons.size(), 1U);
  EXPECT_EQ(back.polygons[0][2].y_m, 10.5);
  ASSERT_EQ(back.segments.size(), 1U);
  EXPECT_EQ(back.segments[0][1].x_m, 11.5);
  EXPECT_EQ(back.bounds_max.x_m, 12.0);
  EXPECT_EQ(back.goal.y_m, 10.0);
  EXPECT_THROW(world_from_json("{}"), std::invalid_argument);
}

}  // namespace
}  // namespace voronaut
