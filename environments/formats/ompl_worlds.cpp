#include "voronaut/environments/formats/ompl_worlds.h"

#include <algorithm>

#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/blocked_cells.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/text_lines.h"

namespace voronaut {
namespace {

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
  return {lines.real(words[2], "x", -kFarthestCoordinate, kFarthestCoordinate),
          lines.real(words[3], "y", -kFarthestCoordinate, kFarthestCoordinate)};
}

// A text word by word: line breaks are blanks like others.
class Words {
 public:
  Words(std::string_view text, const std::string& file) : lines_(text, file) {}

  void expect(const std::string& key) {
    if (const auto word = next("'" + key + "'"); word != key)
      throw error("expected '" + key + "', got " + in_quotes(word));
  }

  int whole(const std::string& what, int lo, int hi) {
    const std::string_view word = next(what);
    return static_cast<int>(lines_.whole(word, what, lo, hi));
  }

  void expect_end() {
    if (to_word()) throw error("expected the end of the file, got " + in_quotes(rest_));
  }

  ConfigError error(const std::string& problem) const { return lines_.error(problem); }

 private:
  static constexpr std::string_view kBlank = " \t";

  // Whether there is one.
  bool to_word() {
    while (true) {
      rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlank), rest_.size()));
      if (!rest_.empty()) return true;
      if (!lines_.next()) return false;
      rest_ = lines_.line();
    }
  }

  std::string_view next(const std::string& what) {
    if (!to_word()) throw error("the file ends before " + what);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlank));
    rest_.remove_prefix(word.size());
    return word;
  }

  TextLines lines_;
  std::string_view rest_;  // of the line, not read yet
};

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
    const double x = lines.real(words[1], "x", -kFarthestCoordinate, kFarthestCoordinate);
    const double y = lines.real(words[2], "y", -kFarthestCoordinate, kFarthestCoordinate);
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
  Words words(text, file);
  words.expect("discretization(cells):");
  CellFrame frame{1, 1, cell_size_m};
  frame.columns = words.whole("columns", 1, BlockedCells::kLongestSide);
  frame.rows = words.whole("rows", 1, BlockedCells::kLongestSide);
  if (!BlockedCells::may_have(frame.columns, frame.rows))
    throw words.error("more than " + std::to_string(BlockedCells::kMostCells) + " cells");
  const auto place = [&](const char* key) {
    words.expect(key);
    const int column = words.whole("column", 0, frame.columns - 1);
    return frame.center(column, words.whole("row", 0, frame.rows - 1));
  };
  const Vec2 start = place("start(cells):");
  const Vec2 goal = place("end(cells):");
  words.expect("environment:");
  BlockedCells cells(frame.columns, frame.rows);
  for (int column = 0; column < frame.columns; ++column) {
    for (int row = 0; row < frame.rows; ++row) {
      if (words.whole("cell", 0, 1) == 1) cells.block(column, row);
    }
  }
  words.expect_end();
  ForeignWorld world = world_of(cells, frame);
  world.start = start;
  world.goal = goal;
  return world;
}

}  // namespace voronaut
