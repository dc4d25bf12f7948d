#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "voronaut/environments/formats/blocked_cells.h"

// MovingAI's benchmarks for grid path finding (N. Sturtevant, "Benchmarks for Grid-Based
// Pathfinding", 2012, https://doi.org/10.1109/TCIAIG.2012.2197681; format at
// https://movingai.com/benchmarks/formats.html). `file` is what errors call the text; all throw
// ConfigError with the line.
namespace voronaut {

// A .map of type octile: passable are '.', 'G' and 'S' (swamp); blocked '@', 'O', 'T' and 'W'
// (water, which may be entered only from water). The file's first row is the upper one.
BlockedCells parse_movingai_map(std::string_view text, const std::string& file);

// A .scen of version 1 for a map that lies there. Cells become their centres; the reference
// length is that of 8-connected cells without cut corners. Each query must be of `map_file`: names
// are compared without folders and ".map".
std::vector<ForeignQuery> parse_movingai_scen(std::string_view text, const std::string& file,
                                              const CellFrame& frame, const std::string& map_file);

}  // namespace voronaut
