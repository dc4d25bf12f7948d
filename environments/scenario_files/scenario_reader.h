#pragma once

#include <vector>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/scenario/scenario_spec.h"

namespace voronaut {

// Reads one entry of a list of scenarios, or the root of a scenario file. It is one of
//   file: other.yaml            a scenario file, beside the file that names it
//   world: {circles: [[x, y, r], ..], boxes: [[xmin, ymin, xmax, ymax], ..],
//           polygons: [[[x, y], ..], ..], segments: [[[x, y], [x, y]], ..],
//           wkt: "POLYGON((..))"}, or a list of such texts (formats/wkt.h)
//   world_file: arena.map       a foreign file (formats/foreign_formats.h), beside the file that
//                               names it; `format` where the file does not tell; `bounds`, `start`
//                               and `goal` where it has none or others are wanted, or
//                               `queries: arena.map.scen`, or
//                               `queries: {file: arena.map.scen, pick: [17]}`, or a selection
//                               (formats/query_selection.h) instead of `pick`
//   generator: {name: forest, density_per_m2: 0.1, ..}
//   dataset: barn               (formats/data_sets.h) one scenario for each world, or those of
//                               `pick`, or of the selection `queries`, up to `limit`
// `world` needs bounds: [[xmin, ymin], [xmax, ymax]], start: [x, y], goal: [x, y]. All but `file`
// take the keys of TaskConfig, all but `dataset` start_heading_rad. Throws ConfigError.
std::vector<ScenarioSpec> read_scenarios(const ConfigNode& entry, const DataLocation& data);

}  // namespace voronaut
