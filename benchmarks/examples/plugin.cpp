#include "voronaut/planners/catalog/plugin.h"

#include "straight_line.h"

// The same without a program: `voronaut run straight-line.yaml --plugin libstraight_line.so`.
VORONAUT_PLUGIN(planners) {
  planners.add({"StraightLine", "straight to the goal", {}, [](const auto& si) {
                  return std::make_shared<StraightLine>(si);
                }});
}
