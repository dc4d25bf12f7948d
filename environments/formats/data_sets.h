#pragma once

#include <memory>
#include <string>
#include <vector>

#include "voronaut/environments/formats/query_selection.h"
#include "voronaut/environments/scenario/scenario_spec.h"

// Worlds that others published, read from the data folder.
namespace voronaut {

// One way through one of its worlds; the ways through one world share it.
struct DataSetWorld {
  std::string name;  // "barn_001", "movingai_arena_17"
  std::shared_ptr<const World> world;
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
  double barn_length_m = 0;  // start, the data set's own path, goal, as the challenge adds them up
};

// Which worlds of a data set: those of `pick` in its order, or what `queries` selects of each
// world, up to `limit` in all.
struct DataSetSelection {
  std::vector<std::string> pick;
  int limit = 0;  // 0: all
  QuerySelection queries;
  ForeignOptions options;
};

// The data sets there are: barn, dodgedrone, movingai, mrpb.
//
// barn: 300 cluttered courses of cylinders of 0.075 m for a Jackal (https://doi.org/10.1109/
// SSRR50563.2020.9292572), start (-2.25, 3), goal (-2.25, 13); its walls end at y = 9.6, so the
// bounds are the walls' outer sides and 14 m: nobody flies around them.
//
// dodgedrone: spheres of the ICRA 2022 DodgeDrone challenge, cut at z = 1 m; start (0, 0), goal
// (18, 0), field x 0..15, y -10..10 and 2 m around it, start and goal included.
//
// movingai: maps of games, cities, mazes, rooms and random cells (movingai.h), cells of 0.25 m,
// each with its queries, "movingai_<map>_<line of the .scen, from 0>". Unless told otherwise 2 a
// map are drawn with seed 1 from those of 5 to 60 m that a disc of 0.42 m can fly.
//
// mrpb: indoor maps of MRPB 1.0 (https://doi.org/10.1109/ICRA48506.2021.9561901) with the queries
// and bounds of its queries.csv, "mrpb_<map>_<query>".
std::vector<std::string> data_set_names();

struct DataSetTraits {
  QuerySelection queries;            // where nothing is said
  std::vector<std::string> options;  // keys of ForeignOptions that it uses
};
// Of a name that there is.
DataSetTraits data_set_traits(const std::string& name);

// Throws ConfigError at `place` (the key that names the data set) if its folder is not there, and
// for a name in `pick` that it has not; and at the files themselves if they are damaged.
std::vector<DataSetWorld> read_data_set(const std::string& name, const DataSetSelection& selection,
                                        const DataLocation& data, const ConfigNode& place);

}  // namespace voronaut
