#include "voronaut/environments/formats/pathbench.h"

#include "voronaut/environments/formats/blocked_cells.h"

namespace voronaut {

namespace {

bool is_wall(const ConfigNode& cell) {
  if (cell.is_list()) throw cell.error("a map of three dimensions; only those of two are read");
  const double value = cell.number(0, 3);
  if (value != 0 && value != 1 && value != 2 && value != 3)
    throw cell.error("expected 0 (free), 1 (wall), 2 (agent) or 3 (goal)");
  return value == 1;
}

CellFrame frame_of(const ConfigNode& grid, double cell_size_m) {
  const std::vector<ConfigNode> rows = grid.items();
  if (rows.empty()) throw grid.error("expected at least one row");
  const std::size_t columns = rows.front().items().size();
  constexpr std::size_t kLongest = BlockedCells::kLongestSide;
  if (columns == 0 || columns > kLongest || rows.size() > kLongest)
    throw grid.error("expected 1 to " + std::to_string(kLongest) + " rows and columns");
  const CellFrame frame{static_cast<int>(columns), static_cast<int>(rows.size()), cell_size_m};
  if (!BlockedCells::may_have(frame.columns, frame.rows))
    throw grid.error("more than " + std::to_string(BlockedCells::kMostCells) + " cells");
  return frame;
}

BlockedCells cells_of(const ConfigNode& grid, const CellFrame& frame) {
  const std::vector<ConfigNode> rows = grid.items();
  BlockedCells cells(frame.columns, frame.rows);
  const auto columns = static_cast<std::size_t>(frame.columns);
  const std::string form = "a row of " + std::to_string(columns) + " cells";
  for (int row = 0; row < frame.rows; ++row) {
    const auto values = rows[static_cast<std::size_t>(row)].items(columns, form);
    for (int column = 0; column < frame.columns; ++column)
      if (is_wall(values[static_cast<std::size_t>(column)]))
        cells.block(column, frame.rows - 1 - row);
  }
  return cells;
}

}  // namespace

ForeignWorld read_pathbench(const ConfigNode& root, double cell_size_m) {
  if (const auto type = root.find("type")) type->choice({"DenseMap"});
  root.allow_only({"type", "version", "grid", "agent", "goal"});
  root.child("type");
  const ConfigNode grid = root.child("grid");
  const CellFrame frame = frame_of(grid, cell_size_m);
  const BlockedCells cells = cells_of(grid, frame);
  const auto place = [&](const char* key) {
    const auto index = root.child(key).items(2, "[row, column]");
    const auto row = static_cast<int>(index[0].whole_number(0, frame.rows - 1));
    const auto column = static_cast<int>(index[1].whole_number(0, frame.columns - 1));
    return frame.center(column, frame.rows - 1 - row);
  };
  ForeignWorld world = world_of(cells, frame);
  world.start = place("agent");
  world.goal = place("goal");
  return world;
}

}  // namespace voronaut
