#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "voronaut/environments/formats/foreign_world.h"

// The planar worlds of OMPL's own tests (ompl/ompl: tests/resources). All throw ConfigError with
// the line.
namespace voronaut {

// circle_obstacles.txt: "units: meter", a line of headings, then number, x, y, r. The bounds are
// those of the circles, as in OMPL's test.
ForeignWorld parse_ompl_circles(std::string_view text, const std::string& file);

// circle_queries.txt: pairs of lines "0 start: x y" and "0 goal: x y".
std::vector<ForeignQuery> parse_ompl_circle_queries(std::string_view text, const std::string& file);

// env1.txt, as OMPL's own loader reads it (tests/resources/environment2D.h):
// "discretization(cells): W H", "start(cells): x y" and "end(cells): x y" with x < W and y < H,
// "environment:", then W x H numbers, 0 (free) or 1, whatever the line breaks: for each x from 0
// on, those of y from 0 to H - 1. A line of the square original is a column of the world. Start and
// goal are centres of cells.
ForeignWorld parse_ompl_environment(std::string_view text, const std::string& file,
                                    double cell_size_m);

}  // namespace voronaut
