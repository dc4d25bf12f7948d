#include "voronaut/environments/shapes/robot_body.h"

#include <gtest/gtest.h>

namespace voronaut {
namespace {

std::string problem(std::vector<Vec2> corners) { return body_problem(corners); }

TEST(RobotBody, TurnsItsCornersCounterClockwise) {
  std::vector<Vec2> corners = {{1, 1}, {1, -1}, {-1, -1}, {-1, 1}};
  EXPECT_EQ(body_problem(corners), "");
  EXPECT_EQ(corners, (std::vector<Vec2>{{-1, 1}, {-1, -1}, {1, -1}, {1, 1}}));
}

TEST(RobotBody, SaysWhatIsWrongWithAPolygon) {
  EXPECT_EQ(problem({{1, 0}, {-1, 0}}), "has fewer than 3 vertices");
  EXPECT_EQ(problem({{1, 0}, {1, 0}, {-1, 1}}), "repeats vertex 0");
  EXPECT_NE(problem({{1, 1}, {-1, -1}, {1, -1}, {-1, 1}}).find("self-intersections"),
            std::string::npos);
  EXPECT_EQ(problem({{1, -1}, {0.1, 0}, {1, 1}, {-1, 0}}),
            "is not strictly convex at its corner 1");
  EXPECT_EQ(problem({{1, -1}, {1, 0}, {1, 1}, {-1, 0}}), "is not strictly convex at its corner 1");
  EXPECT_EQ(problem({{2, -1}, {2, 1}, {1, 0}}),
            "does not hold the origin, about which the body turns");
}

}  // namespace
}  // namespace voronaut
