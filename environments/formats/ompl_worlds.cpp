#include "voronaut/environments/formats/ompl_worlds.h"

#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/blocked_cells.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/text_lines.h"

namespace voronaut {
namespace {

constexpr double kFar = kFarthestCoordinate;

// The words after `key` in the next line, so many.
std::vector<std::string_view> expect_values(TextLines& lines, const std::string& key,
                                            std::size_t count) {
  if (!lines.next()) throw lines.error("the file ends before '" + key + "'");
  auto words = lines.words();
  if (words.size() != count + 1 || words[0] != key)
    throw lines.error("expected '" + key + "' and " + std::to_string(count) + " values, got " +
                      in_quotes(lines.line()));
  words.erase(words.begin());
  return words;
}

Vec2 expect_place(TextLines& lines, const std::string& number, const std::string& what) {
  const auto words = lines.words();
  if (words.size() != 4 || words[0] != number || words[1] != what)
    throw lines.error("expected '" + number + " " + what + " x y', got " + in_quotes(lines.line()));
  return {lines.real(words[2], "x", -kFar, kFar), lines.real(words[3], "y", -kFar, kFar)};
}

}  // namespace

ForeignWorld parse_ompl_circles(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  if (expect_values(lines, "units:", 1)[0] != "meter")
    throw lines.error("expected the units meter, got " + in_quotes(lines.line()));
  if (!lines.next() || lines.words() != std::vector<std::string_view>{"x", "y", "r"})
    throw lines.error("expected the headings x, y, r, got " + in_quotes(lines.line()));
  ForeignWorld world;
  while (lines.next()) {
    const auto words = lines.words();
    if (words.empty()) continue;
    if (words.size() != 4)
      throw lines.error("expected a number, x, y and r, got " + in_quotes(lines.line()));
    const double x = lines.real(words[1], "x", -kFar, kFar);
    const double y = lines.real(words[2], "y", -kFar, kFar);
    const Circle circle{{x, y}, lines.real(words[3], "r", kSmallestRadius, kLargestRadius)};
    const Bounds around = bounds_of(circle);
    world.bounds = world.bounds ? Bounds{world.bounds->min.cwiseMin(around.min),
                                         world.bounds->max.cwiseMax(around.max)}
                                : around;
    world.shapes.circles.push_back(circle);
  }
  if (world.shapes.empty()) throw lines.error("no circle in the file");
  return world;
}

std::vector<ForeignQuery> parse_ompl_circle_queries(std::string_view text,
                                                    const std::string& file) {
  TextLines lines(text, file);
  std::vector<ForeignQuery> queries;
  while (lines.next()) {
    if (lines.words().empty()) continue;
    ForeignQuery query;
    query.name = std::to_string(queries.size());
    query.start = expect_place(lines, query.name, "start:");
    if (!lines.next()) throw lines.error("the file ends before the goal of query " + query.name);
    query.goal = expect_place(lines, query.name, "goal:");
    queries.push_back(std::move(query));
  }
  if (queries.empty()) throw lines.error("no query in the file");
  return queries;
}

ForeignWorld parse_ompl_environment(std::string_view text, const std::string& file,
                                    double cell_size_m) {
  TextLines lines(text, file);
  const auto sizes = expect_values(lines, "discretization(cells):", 2);
  const auto whole = [&](std::string_view word, const char* what, int lo, int hi) {
    return static_cast<int>(lines.whole(word, what, lo, hi));
  };
  const int columns = whole(sizes[0], "columns", 1, BlockedCells::kLongestSide);
  const int rows = whole(sizes[1], "rows", 1, BlockedCells::kLongestSide);
  if (!BlockedCells::may_have(columns, rows))
    throw lines.error("more than " + std::to_string(BlockedCells::kMostCells) + " cells");
  const CellFrame frame{columns, rows, cell_size_m};
  const auto place = [&](const char* key) {
    const auto words = expect_values(lines, key, 2);
    const int row = whole(words[0], "row", 0, rows - 1);
    return frame.center(whole(words[1], "column", 0, columns - 1), rows - 1 - row);
  };
  const Vec2 start = place("start(cells):");
  const Vec2 goal = place("end(cells):");
  expect_values(lines, "environment:", 0);
  BlockedCells cells(columns, rows);
  for (int row = rows - 1; row >= 0; --row) {
    if (!lines.next())
      throw lines.error("the file ends after " + std::to_string(rows - 1 - row) + " of " +
                        std::to_string(rows) + " rows");
    const auto words = lines.words();
    if (words.size() != static_cast<std::size_t>(columns))
      throw lines.error("expected a row of " + std::to_string(columns) + " cells, got " +
                        std::to_string(words.size()));
    for (int column = 0; column < columns; ++column)
      if (lines.whole(words[static_cast<std::size_t>(column)], "cell", 0, 1) == 1)
        cells.block(column, row);
  }
  lines.expect_blank_rest();
  ForeignWorld world = world_of(cells, frame);
  world.start = start;
  world.goal = goal;
  return world;
}

}  // namespace voronaut
