#include "voronaut/environments/shortest_path/tangent_graph.h"

#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/environments/shortest_path/shortest_path.h"

namespace voronaut {
namespace {

// One circle far to the side of the straight way.
TEST(TangentGraph, AdmitsEveryDiscThatAPathWithinItsLimitCanTouchAndNoneFarBeyond) {
  const double radius_m = 0.5;
  for (const double aside_m : {4.0, 9.0, 20.0}) {
    Shapes shapes;
    shapes.circles = {{Vec2(0, aside_m), 0.5}};
    const World world({Vec2(-50, -50), Vec2(50, 50)}, shapes);
    TangentGraph graph(world, Vec2(-5, 0), Vec2(5, 0), radius_m, kShortestPathTolerance);
    const double touching_m = 2 * std::hypot(5, aside_m - 1);
    EXPECT_TRUE(graph.restrict_to(touching_m)) << aside_m;
    EXPECT_FALSE(graph.restrict_to(0.9 * touching_m)) << aside_m;
  }
}

}  // namespace
}  // namespace voronaut
