#pragma once

#include <string>
#include <vector>

#include "voronaut/environments/scenario.h"

// Worlds that others published, read from the data folder.
namespace voronaut {

struct DataSetWorld {
  std::string name;  // "barn_001"
  Bounds bounds;
  Shapes shapes;
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
};

// Which worlds of a data set: those of `pick` in its order, or the first `limit`, or all.
struct DataSetSelection {
  std::vector<std::string> pick;
  int limit = 0;  // 0: all
};

// The data sets there are: barn, dodgedrone.
//
// barn: 300 cluttered courses of cylinders of 0.075 m for a Jackal (https://doi.org/10.1109/
// SSRR50563.2020.9292572), start (-2.25, 3), goal (-2.25, 13); its walls end at y = 9.6, so the
// bounds are the walls' outer sides and 14 m: nobody flies around them.
//
// dodgedrone: spheres of the ICRA 2022 DodgeDrone challenge, cut at z = 1 m; start (0, 0), goal
// (18, 0), field x 0..15, y -10..10 and 2 m around it, start and goal included.
std::vector<std::string> data_set_names();

// Throws ConfigError at `place` (the key that names the data set) if its folder is not there, and
// for a name in `pick` that it has not; and at the files themselves if they are damaged.
std::vector<DataSetWorld> read_data_set(const std::string& name, const DataSetSelection& selection,
                                        const DataLocation& data, const ConfigNode& place);

}  // namespace voronaut
