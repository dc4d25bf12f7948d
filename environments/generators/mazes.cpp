#include "voronaut/environments/generators/mazes.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "voronaut/environments/generators/placement.h"

namespace voronaut {
namespace {

// The walls between the cells of an n by n square. Cell (column, row), row 0 at the bottom.
class CellWalls {
 public:
  explicit CellWalls(int n)
      : n_(n), right_(static_cast<std::size_t>(n) * n, true), above_(right_) {}

  int size() const { return n_; }
  // Whether a wall stands between a cell and its right or upper neighbour.
  bool right(int column, int row) const { return right_[index(column, row)]; }
  bool above(int column, int row) const { return above_[index(column, row)]; }
  void open_right(int column, int row) { right_[index(column, row)] = false; }
  void open_above(int column, int row) { above_[index(column, row)] = false; }

  // Opens walls until one path joins any two cells.
  void carve(Random& random);
  // Opens each inner wall that still stands with this probability.
  void open_more(double probability, Random& random);

 private:
  struct Step {
    int column;
    int row;
  };

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * n_ + column;
  }

  int n_;
  std::vector<bool> right_;
  std::vector<bool> above_;
};

void CellWalls::carve(Random& random) {
  std::vector<bool> visited(right_.size(), false);
  std::vector<Step> trail = {{0, 0}};
  visited[0] = true;
  while (!trail.empty()) {
    const auto [column, row] = trail.back();
    std::vector<Step> fresh;
    for (const auto& [dx, dy] : {Step{1, 0}, Step{0, 1}, Step{-1, 0}, Step{0, -1}}) {
      const Step next{column + dx, row + dy};
      if (next.column >= 0 && next.column < n_ && next.row >= 0 && next.row < n_ &&
          !visited[index(next.column, next.row)])
        fresh.push_back(next);
    }
    if (fresh.empty()) {
      trail.pop_back();
      continue;
    }
    const Step next = fresh[random.below(fresh.size())];
    visited[index(next.column, next.row)] = true;
    if (next.row == row) open_right(std::min(column, next.column), row);
    if (next.column == column) open_above(column, std::min(row, next.row));
    trail.push_back(next);
  }
}

void CellWalls::open_more(double probability, Random& random) {
  for (int row = 0; row < n_; ++row)
    for (int column = 0; column < n_; ++column) {
      if (column + 1 < n_ && right(column, row) && random.uniform() < probability)
        open_right(column, row);
      if (row + 1 < n_ && above(column, row) && random.uniform() < probability)
        open_above(column, row);
    }
}

// add(first, last) for each run of cells in [0, n) that have a wall, last not included.
template <class HasWall, class Add>
void for_each_run(int n, HasWall&& has_wall, Add&& add) {
  for (int first = 0, last = 0; first < n; first = last + 1) {
    for (last = first; last < n && has_wall(last);) ++last;
    if (last > first) add(first, last);
  }
}

// Neighbouring walls in one line become one wall.
void add_maze_walls(Shapes& shapes, const CellWalls& walls, double side_m) {
  const int n = walls.size();
  for (int line = 0; line + 1 < n; ++line) {
    const double across_m = (line + 1) * side_m;
    for_each_run(
        n, [&](int cell) { return walls.right(line, cell); },
        [&](int first, int last) {
          add_wall(shapes, {across_m, first * side_m}, {across_m, last * side_m});
        });
    for_each_run(
        n, [&](int cell) { return walls.above(cell, line); },
        [&](int first, int last) {
          add_wall(shapes, {first * side_m, across_m}, {last * side_m, across_m});
        });
  }
}

GeneratedWorld closed_square(double side_m) {
  GeneratedWorld world;
  world.bounds = {Vec2::Zero(), Vec2::Constant(side_m)};
  add_enclosure(world.shapes, world.bounds);
  return world;
}

}  // namespace

WorldDraw draw_world(const RoomsConfig& config, Random& random) {
  constexpr double kAside = 0.6;  // between a door and the corner of the room
  const double slack_m = config.room_side_m - config.door_m - 2 * kAside;
  if (slack_m < 0) return std::nullopt;
  CellWalls without_door(config.rooms);
  without_door.carve(random);
  without_door.open_more(config.further_doors, random);
  GeneratedWorld world = closed_square(config.rooms * config.room_side_m);
  const auto add = [&](const Vec2& from, const Vec2& to, bool closed) {
    if (closed)
      add_wall(world.shapes, from, to);
    else
      add_wall_with_gap(world.shapes, from, to, kAside + random.uniform(0, slack_m), config.door_m);
  };
  for (int row = 0; row < config.rooms; ++row)
    for (int column = 0; column < config.rooms; ++column) {
      const Vec2 low = config.room_side_m * Vec2(column, row);
      const Vec2 high = low + Vec2::Constant(config.room_side_m);
      if (column + 1 < config.rooms)
        add({high.x(), low.y()}, high, without_door.right(column, row));
      if (row + 1 < config.rooms) add({low.x(), high.y()}, high, without_door.above(column, row));
    }
  const Bounds inside{Vec2::Ones(), Vec2::Constant(config.room_side_m - 1)};
  world.start = point_in(inside, random);
  world.goal = world.bounds.max - point_in(inside, random);
  return world;
}

WorldDraw draw_world(const MazeConfig& config, Random& random) {
  CellWalls walls(config.cells);
  walls.carve(random);
  walls.open_more(config.opened, random);
  GeneratedWorld world = closed_square(config.cells * config.cell_side_m);
  add_maze_walls(world.shapes, walls, config.cell_side_m);
  world.start = Vec2::Constant(config.cell_side_m / 2);
  world.goal = world.bounds.max - world.start;
  return world;
}

}  // namespace voronaut
