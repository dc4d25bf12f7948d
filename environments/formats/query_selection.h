#pragma once

#include <string>
#include <vector>

#include "voronaut/environments/formats/foreign_world.h"
#include "voronaut/environments/world.h"

namespace voronaut {

// Which of a world's queries are flown.
struct QuerySelection {
  int sample = 0;
  int seed = 1;
  int bucket = -1;
  double clearance_m = 0;
  double shortest_m = 0;
  double longest_m = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v.count("sample", sample, 0, 1'000'000, "So many, drawn without replacement; 0: all");
    v.count("seed", seed, 0, 1'000'000'000, "Of the draw");
    v.count("bucket", bucket, -1, 1'000'000, "MovingAI's class of length; -1: any");
    v.number("clearance_m", clearance_m, 0, 100,
             "Only what a disc of this radius can fly on the true world; 0: any");
    v.number("shortest_m", shortest_m, 0, 1e6,
             "Only from this length on: the file's reference, else the straight line");
    v.number("longest_m", longest_m, 0, 1e6, "Only up to this length; 0: any");
  }
};

// Those that the selection takes, in the order of the file. The draw goes through the queries in an
// order that `seed` and `map_name` decide and stops when `sample` of them are admitted, or when it
// has sought three times as many paths: a map whose passages are too narrow gives fewer or none.
// One shortest path per query tried if clearance_m is given, else O(queries).
std::vector<ForeignQuery> select_queries(const std::vector<ForeignQuery>& queries,
                                         const QuerySelection& selection, const World& world,
                                         const std::string& map_name);

}  // namespace voronaut
