#pragma once

#include <limits>

// The keys of a scenario entry beside those of TaskConfig, by what its world comes from. Most are
// forms that the readers read themselves.
namespace voronaut {

struct HeadingConfig {
  double start_heading_rad = std::numeric_limits<double>::quiet_NaN();  // none

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("start_heading_rad", start_heading_rad, -10, 10,
             "Where it looks at the start, from the x axis; none: towards the goal");
  }
};

struct ScenarioFileKeys {
  template <class Visitor>
  void visit(Visitor& v) {
    v.form("file", "file", "A scenario file, beside this one");
  }
};

struct ShapeKeys {
  template <class Visitor>
  void visit(Visitor& v) {
    v.form("circles", "[[x, y, r], ...]", "Round obstacles");
    v.form("boxes", "[[xmin, ymin, xmax, ymax], ...]", "Rectangles along the axes");
    v.form("polygons", "[[[x, y], ...], ...]", "Obstacles of straight edges, each by its corners");
    v.form("segments", "[[[x, y], [x, y]], ...]", "Walls without thickness");
    v.form("wkt", "[text, ...]", "Obstacles as well-known text: polygons with holes, lines");
  }
};

struct WorldKeys {
  ShapeKeys world;
  HeadingConfig heading;

  template <class Visitor>
  void visit(Visitor& v) {
    v.section("world", world, "The obstacles, in metres");
    v.form("bounds", "[[xmin, ymin], [xmax, ymax]]", "Where the vehicle may be, in metres");
    v.form("start", "[x, y]", "Where it starts, in metres");
    v.form("goal", "[x, y]", "Where it shall go, in metres");
    heading.visit(v);
  }
};

struct WorldFileKeys {
  HeadingConfig heading;

  template <class Visitor>
  void visit(Visitor& v) {
    v.form("world_file", "file", "A file of another project, beside this one");
    v.form("format", "text", "Its format, where the file does not tell");
    v.form("bounds", "[[xmin, ymin], [xmax, ymax]]",
           "Where the vehicle may be, where the file has none or others are wanted");
    v.form("start", "[x, y]", "Where it starts, the same");
    v.form("goal", "[x, y]", "Where it shall go, the same");
    v.form("queries", "file", "A file of starts and goals, or a selection from one");
    heading.visit(v);
  }
};

// Of `queries` where it is a map, beside QuerySelection.
struct QueryFileKeys {
  template <class Visitor>
  void visit(Visitor& v) {
    v.form("file", "file", "Where the queries are, beside this file");
    v.form("pick", "[text, ...]", "These, by name, instead of a selection");
  }
};

struct GeneratorKeys {
  HeadingConfig heading;

  template <class Visitor>
  void visit(Visitor& v) {
    v.form("generator", "family", "A family of random worlds and its parameters");
    heading.visit(v);
  }
};

struct DataSetKeys {
  int limit = 0;  // all

  template <class Visitor>
  void visit(Visitor& v) {
    v.form("dataset", "text", "A data set in the data folder");
    v.count("limit", limit, 1, 1'000'000, "At most so many of its ways; none: all");
    v.form("pick", "[text, ...]", "These of its worlds, by name, instead of a selection");
    v.form("queries", "selection", "What is selected of each world");
  }
};

}  // namespace voronaut
