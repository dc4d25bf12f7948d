#pragma once

#include <string>
#include <vector>

#include "voronaut/environments/formats/foreign_world.h"
#include "voronaut/environments/world.h"

namespace voronaut {

// Which of a world's queries are flown.
struct QuerySelection {
  int sample = 0;          // so many, drawn without replacement; 0: all
  int seed = 1;            // of the draw
  int bucket = -1;         // MovingAI's class of length; -1: any
  double clearance_m = 0;  // only what a disc of this radius can fly on the true world; 0: any
  double shortest_m = 0;   // only from this length on: the file's reference, else the straight line
  double longest_m = 0;    // and up to this one; 0: any

  template <class Visitor>
  void visit(Visitor& v) {
    v.count("sample", sample, 0, 1'000'000);
    v.count("seed", seed, 0, 1'000'000'000);
    v.count("bucket", bucket, -1, 1'000'000);
    v.number("clearance_m", clearance_m, 0, 100);
    v.number("shortest_m", shortest_m, 0, 1e6);
    v.number("longest_m", longest_m, 0, 1e6);
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
