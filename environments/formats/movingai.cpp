#include "voronaut/environments/formats/movingai.h"

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/text_lines.h"

namespace voronaut {
namespace {

std::string_view expect_pair(TextLines& lines, const std::string& key) {
  if (!lines.next()) throw lines.error("the file ends before '" + key + "'");
  const auto words = lines.words();
  if (words.size() != 2 || words[0] != key)
    throw lines.error("expected '" + key + "' and its value, got " + in_quotes(lines.line()));
  return words[1];
}

int expect_size(TextLines& lines, const std::string& key) {
  return static_cast<int>(lines.whole(expect_pair(lines, key), key, 1, BlockedCells::kLongestSide));
}

std::string_view without_trailing_blanks(std::string_view line) {
  return line.substr(0, line.find_last_not_of(" \t") + 1);
}

// "arena" of "maps/dao/arena.map".
std::string_view map_name_of(std::string_view path) {
  constexpr std::string_view kEnding = ".map";
  path.remove_prefix(path.find_last_of("/\\") + 1);
  return path.ends_with(kEnding) ? path.substr(0, path.size() - kEnding.size()) : path;
}

}  // namespace

BlockedCells parse_movingai_map(std::string_view text, const std::string& file) {
  constexpr std::string_view kPassable = ".GS";
  constexpr std::string_view kBlocked = "@OTW";
  TextLines lines(text, file);
  if (const auto type = expect_pair(lines, "type"); type != "octile")
    throw lines.error("expected the type octile, got " + in_quotes(type));
  const int rows = expect_size(lines, "height");
  const int columns = expect_size(lines, "width");
  if (!BlockedCells::may_have(columns, rows))
    throw lines.error("more than " + std::to_string(BlockedCells::kMostCells) + " cells");
  if (!lines.next() || lines.words() != std::vector<std::string_view>{"map"})
    throw lines.error("expected the line 'map', got " + in_quotes(lines.line()));
  BlockedCells cells(columns, rows);
  for (int row = rows - 1; row >= 0; --row) {
    if (!lines.next())
      throw lines.error("the file ends after " + std::to_string(rows - 1 - row) + " of " +
                        std::to_string(rows) + " rows");
    const std::string_view line = without_trailing_blanks(lines.line());
    if (line.size() != static_cast<std::size_t>(columns))
      throw lines.error("expected a row of " + std::to_string(columns) + " cells, got " +
                        std::to_string(line.size()));
    for (int column = 0; column < columns; ++column) {
      const char cell = line[static_cast<std::size_t>(column)];
      if (kBlocked.find(cell) != std::string_view::npos)
        cells.block(column, row);
      else if (kPassable.find(cell) == std::string_view::npos)
        throw lines.error("column " + std::to_string(column) + ": expected one of " +
                          std::string(kPassable) + std::string(kBlocked) + ", got " +
                          in_quotes(line.substr(static_cast<std::size_t>(column), 1)));
    }
  }
  lines.expect_blank_rest();
  return cells;
}

std::vector<ForeignQuery> parse_movingai_scen(std::string_view text, const std::string& file,
                                              const CellFrame& frame, const std::string& map_file) {
  TextLines lines(text, file);
  const std::string_view version = expect_pair(lines, "version");
  if (version != "1" && version != "1.0")
    throw lines.error("expected version 1, got " + in_quotes(version));
  const int top = frame.rows - 1;
  std::vector<ForeignQuery> queries;
  while (lines.next()) {
    const auto words = lines.words();
    if (words.empty()) continue;
    if (words.size() != 9)
      throw lines.error(
          "expected 9 columns (bucket, map, width, height, start x, start y, goal x, goal y, "
          "length), got " +
          std::to_string(words.size()));
    if (map_name_of(words[1]) != map_name_of(map_file))
      throw lines.error("a query of the map " + in_quotes(words[1]) + ", not of " +
                        in_quotes(map_file));
    const auto cell = [&](std::size_t word, const char* what, int count) {
      return static_cast<int>(lines.whole(words[word], what, 0, count - 1));
    };
    lines.whole(words[2], "width of the map", frame.columns, frame.columns);
    lines.whole(words[3], "height of the map", frame.rows, frame.rows);
    ForeignQuery query;
    query.name = std::to_string(queries.size());
    query.bucket = static_cast<int>(lines.whole(words[0], "bucket", 0, 1'000'000));
    const int start_column = cell(4, "start x", frame.columns);
    query.start = frame.center(start_column, top - cell(5, "start y", frame.rows));
    const int goal_column = cell(6, "goal x", frame.columns);
    query.goal = frame.center(goal_column, top - cell(7, "goal y", frame.rows));
    query.length_m = lines.real(words[8], "length", 0, 1e9) * frame.cell_size_m;
    queries.push_back(std::move(query));
  }
  if (queries.empty()) throw lines.error("no query in the file");
  return queries;
}

}  // namespace voronaut
