#include "voronaut/environments/shapes/shape_index.h"

#include <cmath>
#include <numeric>
#include <tuple>

namespace voronaut {
namespace {

// Cells list what comes within this part of a cell too, so that rounding in a walk along cells
// never passes a primitive by.
constexpr double kCellMargin = 1e-6;
// Cells that a primitive is listed in, on average: as many as primitives that keep apart need at
// the density that is chosen for them. Where they lie over each other, cells become larger instead.
constexpr double kMostCellsEach = 24;

Bounds hull_of(const Bounds& s, const Bounds& t) {
  return {s.min.cwiseMin(t.min), s.max.cwiseMax(t.max)};
}

// Without those that are there already, the others in their order. O(n log n).
std::vector<Circle> distinct(const std::vector<Circle>& circles) {
  const auto key = [&](std::uint32_t i) {
    const Circle& c = circles[i];
    return std::tuple(c.center.x(), c.center.y(), c.radius_m);
  };
  std::vector<std::uint32_t> order(circles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return key(i) != key(j) ? key(i) < key(j) : i < j;
  });
  std::vector<bool> repeats(circles.size(), false);
  for (std::size_t k = 1; k < order.size(); ++k)
    repeats[order[k]] = key(order[k]) == key(order[k - 1]);
  std::vector<Circle> kept;
  kept.reserve(circles.size());
  for (std::size_t i = 0; i < circles.size(); ++i)
    if (!repeats[i]) kept.push_back(circles[i]);
  return kept;
}

// Cells of that size in which areas are listed.
double cells_listed(const std::vector<Bounds>& areas, double cell_m) {
  double cells = 0;
  for (const Bounds& area : areas) {
    const Vec2 size_m = area.max - area.min;
    cells += (size_m.x() / cell_m + 1) * (size_m.y() / cell_m + 1);
  }
  return cells;
}

// The straight way of a disc, with coordinates along it and across.
class Sweep {
 public:
  Sweep(const Vec2& a, const Vec2& b, double radius_m)
      : way_{a, b}, radius_m_(radius_m), length_m_((b - a).norm()) {
    along_ = length_m_ > 0 ? Vec2((b - a) / length_m_) : Vec2::UnitX();
  }

  bool touches(const Circle& circle) const {
    const Vec2 p = circle.center - way_.a;
    const double ahead_m = p.dot(along_);
    const double beside_m = cross(along_, p);
    const double past_m = ahead_m - std::clamp(ahead_m, 0.0, length_m_);
    const double reach_m = radius_m_ + circle.radius_m;
    return past_m * past_m + beside_m * beside_m < reach_m * reach_m;
  }

  bool touches(const Segment& wall) const {
    const Vec2 a = wall.a - way_.a;
    const Vec2 b = wall.b - way_.a;
    const double a_m = cross(along_, a);
    const double b_m = cross(along_, b);
    if (std::min(a_m, b_m) >= radius_m_ || std::max(a_m, b_m) <= -radius_m_) return false;
    return distance(way_, wall) < radius_m_;
  }

 private:
  Segment way_;
  double radius_m_;
  double length_m_;
  Vec2 along_;
};

}  // namespace

// Two rounds over the same cells: count, then place. each(add) calls add(id, cell).
template <class ForEach>
ShapeIndex::CellLists ShapeIndex::list(ForEach&& each) const {
  CellLists lists;
  lists.start.assign(grid_.size() + 1, 0);
  each([&](std::uint32_t, std::size_t at) { ++lists.start[at + 1]; });
  for (std::size_t c = 0; c < grid_.size(); ++c) lists.start[c + 1] += lists.start[c];
  lists.entry.resize(lists.start.back());
  std::vector<std::uint32_t> next(lists.start.begin(), lists.start.end() - 1);
  each([&](std::uint32_t id, std::size_t at) { lists.entry[next[at]++] = id; });
  return lists;
}

void ShapeIndex::add_edges(const Polygon& polygon) {
  const auto first = static_cast<std::uint32_t>(edges_.size());
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) edges_.push_back(edge(polygon, i));
  solids_.push_back({first, static_cast<std::uint32_t>(edges_.size())});
}

ShapeIndex::ShapeIndex(const Shapes& shapes, double cell_m)
    : circles_(distinct(shapes.circles)), edges_(shapes.segments) {
  for (const Polygon& polygon : shapes.polygons) add_edges(polygon);
  if (shapes.empty()) return;
  lay_out_cells(cell_m);

  const double margin_m = kCellMargin * grid_.cell_m();
  const auto fill = [&](const Bounds& area, std::uint32_t id, auto&& add) {
    const CellGrid::Range range = grid_.cells_in(grown(area, margin_m));
    for (int y = range.y0; y <= range.y1; ++y) {
      for (int x = range.x0; x <= range.x1; ++x) add(id, grid_.cell(x, y));
    }
  };
  const auto follow = [&](const Segment& e, std::uint32_t id, auto&& add) {
    grid_.for_cells_near(e, margin_m, [&](int y, int x0, int x1) {
      for (int x = x0; x <= x1; ++x) add(id, grid_.cell(x, y));
      return true;
    });
  };
  primitives_ = list([&](auto&& add) {
    std::uint32_t id = 0;
    for (const Circle& circle : circles_) fill(bounds_of(circle), id++, add);
    for (const Segment& e : edges_) follow(e, id++, add);
  });
  solids_at_ = list([&](auto&& add) {
    std::uint32_t id = 0;
    for (const Polygon& polygon : shapes.polygons) fill(bounds_of(polygon), id++, add);
  });
}

void ShapeIndex::lay_out_cells(double cell_m) {
  Bounds area{Vec2::Constant(kInfinity), Vec2::Constant(-kInfinity)};
  for (const Circle& circle : circles_) area = hull_of(area, bounds_of(circle));
  for (const Segment& e : edges_) area = hull_of(area, bounds_of(e));
  const Vec2 size_m = area.max - area.min;
  const auto count = static_cast<double>(circles_.size() + edges_.size());
  // Four cells per primitive: single rays and swept discs cost least, fan sweeps hardly care.
  if (cell_m <= 0) cell_m = std::sqrt(size_m.x() * size_m.y() / count) / 2;
  if (cell_m <= 0) cell_m = std::max(size_m.maxCoeff() / count, 1.0);
  while ((size_m.x() / cell_m + 1) * (size_m.y() / cell_m + 1) > 5 * count + 64) cell_m *= 1.25;
  // Edges are listed along their way only: twice their length is a bound for them.
  std::vector<Bounds> areas;
  double edges_m = 0;
  for (const Circle& circle : circles_) areas.push_back(bounds_of(circle));
  for (const Segment& e : edges_) edges_m += (e.b - e.a).norm();
  for (const Solid& solid : solids_) {
    Bounds around = bounds_of(edges_[solid.first_edge]);
    for (std::uint32_t i = solid.first_edge; i < solid.last_edge; ++i)
      around = hull_of(around, bounds_of(edges_[i]));
    areas.push_back(around);
  }
  while (cells_listed(areas, cell_m) + 2 * edges_m / cell_m > kMostCellsEach * count + 64)
    cell_m *= 1.25;
  grid_ = CellGrid(grown(area, kCellMargin * cell_m), cell_m);
}

double ShapeIndex::solid_distance(const Solid& solid, const Vec2& p) const {
  double nearest_m = kInfinity;
  bool inside = false;
  for (std::uint32_t i = solid.first_edge; i < solid.last_edge; ++i) {
    nearest_m = std::min(nearest_m, distance(p, edges_[i]));
    if (crosses_rightward_ray(edges_[i], p)) inside = !inside;
  }
  return inside ? -nearest_m : nearest_m;
}

double ShapeIndex::nearest_in_cell(std::size_t at, const Vec2& p) const {
  const auto circle_count = static_cast<std::uint32_t>(circles_.size());
  double nearest_m = kInfinity;
  for (std::uint32_t k = primitives_.start[at]; k < primitives_.start[at + 1]; ++k) {
    const std::uint32_t id = primitives_.entry[k];
    nearest_m = std::min(nearest_m, id < circle_count ? signed_distance(p, circles_[id])
                                                      : distance(p, edges_[id - circle_count]));
  }
  return nearest_m;
}

double ShapeIndex::clearance_m(const Vec2& p, double within_m) const {
  double nearest_m = within_m;
  if (grid_.size() == 0) return nearest_m;
  const int px = std::clamp(grid_.column(p.x()), 0, grid_.columns() - 1);
  const int py = std::clamp(grid_.row(p.y()), 0, grid_.rows() - 1);
  const std::size_t home = grid_.cell(px, py);
  for (std::uint32_t k = solids_at_.start[home]; k < solids_at_.start[home + 1]; ++k) {
    nearest_m = std::min(nearest_m, solid_distance(solids_[solids_at_.entry[k]], p));
  }
  // Square rings of cells around the home cell: what ring k + 1 and beyond hold is at least k
  // cells away.
  const int last_ring = std::max({px, grid_.columns() - 1 - px, py, grid_.rows() - 1 - py});
  for (int ring = 0; ring <= last_ring && nearest_m > (ring - 1) * grid_.cell_m(); ++ring)
    nearest_m = std::min(nearest_m, nearest_in_ring(px, py, ring, p));
  return nearest_m;
}

double ShapeIndex::nearest_in_ring(int column, int row, int ring, const Vec2& p) const {
  double nearest_m = kInfinity;
  for (int y = std::max(row - ring, 0); y <= std::min(row + ring, grid_.rows() - 1); ++y) {
    const bool whole_row = std::abs(y - row) == ring;
    const int step = whole_row || ring == 0 ? 1 : 2 * ring;
    for (int x = column - ring; x <= column + ring; x += step) {
      if (x >= 0 && x < grid_.columns())
        nearest_m = std::min(nearest_m, nearest_in_cell(grid_.cell(x, y), p));
    }
  }
  return nearest_m;
}

bool ShapeIndex::is_inside_polygon(const Vec2& p) const {
  if (solids_.empty()) return false;
  const std::size_t home = grid_.cell(std::clamp(grid_.column(p.x()), 0, grid_.columns() - 1),
                                      std::clamp(grid_.row(p.y()), 0, grid_.rows() - 1));
  for (std::uint32_t k = solids_at_.start[home]; k < solids_at_.start[home + 1]; ++k) {
    const Solid& solid = solids_[solids_at_.entry[k]];
    bool inside = false;
    for (std::uint32_t i = solid.first_edge; i < solid.last_edge; ++i) {
      if (crosses_rightward_ray(edges_[i], p)) inside = !inside;
    }
    if (inside) return true;
  }
  return false;
}

bool ShapeIndex::segment_is_clear(const Vec2& a, const Vec2& b, double radius_m) const {
  if (grid_.size() == 0) return true;
  if (is_inside_polygon(a)) return false;
  const Sweep sweep(a, b, radius_m);
  const auto circle_count = static_cast<std::uint32_t>(circles_.size());
  return grid_.for_cells_near({a, b}, radius_m, [&](int y, int x0, int x1) {
    const std::uint32_t end = primitives_.start[grid_.cell(x1, y) + 1];
    for (std::uint32_t k = primitives_.start[grid_.cell(x0, y)]; k < end; ++k) {
      const std::uint32_t id = primitives_.entry[k];
      if (id < circle_count ? sweep.touches(circles_[id])
                            : sweep.touches(edges_[id - circle_count]))
        return false;
    }
    return true;
  });
}

}  // namespace voronaut
