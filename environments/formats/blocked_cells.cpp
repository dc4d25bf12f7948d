#include "voronaut/environments/formats/blocked_cells.h"

#include <utility>

namespace voronaut {
namespace {

// A grid read with its lines along rows or along columns.
struct Lines {
  const BlockedCells& cells;
  bool along_rows;

  int count() const { return along_rows ? cells.rows() : cells.columns(); }
  int length() const { return along_rows ? cells.columns() : cells.rows(); }
  bool blocked(int line, int at) const {
    return along_rows ? cells.blocked(at, line) : cells.blocked(line, at);
  }
  CellBlock block(int line, int lines, int begin, int end) const {
    if (along_rows) return {begin, line, end - begin, lines};
    return {line, begin, lines, end - begin};
  }
};

struct Run {
  int begin = 0;
  int end = 0;
  int first_line = 0;
};

std::vector<Run> runs_in(const Lines& lines, int line) {
  std::vector<Run> runs;
  for (int at = 0; at < lines.length();) {
    if (!lines.blocked(line, at)) {
      ++at;
      continue;
    }
    const int begin = at;
    while (at < lines.length() && lines.blocked(line, at)) ++at;
    runs.push_back({begin, at, line});
  }
  return runs;
}

std::vector<CellBlock> joined_runs(const Lines& lines) {
  std::vector<CellBlock> blocks;
  std::vector<Run> open;  // runs that reach the line before, from left to right
  for (int line = 0; line <= lines.count(); ++line) {
    std::vector<Run> here = line < lines.count() ? runs_in(lines, line) : std::vector<Run>{};
    std::size_t next = 0;
    for (const Run& run : open) {
      while (next < here.size() && here[next].begin < run.begin) ++next;
      if (next < here.size() && here[next].begin == run.begin && here[next].end == run.end)
        here[next].first_line = run.first_line;
      else
        blocks.push_back(lines.block(run.first_line, line - run.first_line, run.begin, run.end));
    }
    open = std::move(here);
  }
  return blocks;
}

}  // namespace

std::vector<CellBlock> blocks_of(const BlockedCells& cells) {
  std::vector<CellBlock> wide = joined_runs({cells, true});
  std::vector<CellBlock> tall = joined_runs({cells, false});
  return tall.size() < wide.size() ? std::move(tall) : std::move(wide);
}

ForeignWorld world_of(const BlockedCells& cells, const CellFrame& frame) {
  ForeignWorld world;
  world.cells = frame;
  world.bounds = Bounds{frame.corner(0, 0), frame.corner(frame.columns, frame.rows)};
  for (const CellBlock& block : blocks_of(cells))
    world.shapes.polygons.push_back(
        box(Bounds{frame.corner(block.column, block.row),
                   frame.corner(block.column + block.columns, block.row + block.rows)}));
  return world;
}

}  // namespace voronaut
