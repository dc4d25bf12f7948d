#include "voronaut/planners/mapping/free_space/scan_star.h"

#include <algorithm>

#include "voronaut/planners/mapping/free_space/row_words.h"

namespace voronaut {

using row_words::floor_of;

namespace {

// Where nothing is in range, one chord spans several beams, a millimetre inside their arc; where a
// part begins, it may be coarser.
constexpr double kChord_rad = 0.07;
constexpr double kFirstChord_rad = 0.2;

// At least one.
std::size_t beams_across(double angle_rad, const Scan& scan) {
  const double most = static_cast<double>(scan.size());
  return static_cast<std::size_t>(std::clamp(angle_rad / scan.beams->bearing_step_rad, 1.0, most));
}

// How much of a beam that hit something is known to be free. The surface between two beams may
// stand out towards the sensor: a right-angled corner by half their spacing.
double free_share(const Scan& scan) { return 1 - 0.5 * scan.beams->bearing_step_rad; }

// How far a beam is free, counted no longer than longest_m.
inline double free_length_m(double range_m, double max_range_m, double share, double longest_m) {
  if (range_m == max_range_m) return longest_m;
  const double free_m = range_m > 0 && range_m < max_range_m ? range_m * share : 0;
  return free_m < longest_m ? free_m : longest_m;
}

}  // namespace

// Writes corners one after the other. Truncates their places to cells.
class ScanStar::Pen {
 public:
  Pen(Corner* corner, const Vec2& sensor)
      : corner_(corner),
        x_(sensor.x()),
        y_(sensor.y()),
        low_x_(x_),
        low_y_(y_),
        high_x_(x_),
        high_y_(y_) {}

  // A place on a beam.
  void add(double length, const Vec2& direction) {
    const double x = x_ + length * direction.x(), y = y_ + length * direction.y();
    *corner_++ = {x, y, static_cast<int>(x), static_cast<int>(y)};
    low_x_ = low_x_ < x ? low_x_ : x;
    low_y_ = low_y_ < y ? low_y_ : y;
    high_x_ = high_x_ > x ? high_x_ : x;
    high_y_ = high_y_ > y ? high_y_ : y;
  }
  const Corner* end() const { return corner_; }
  Box box() const {
    return {floor_of(low_x_), floor_of(high_x_), floor_of(low_y_), floor_of(high_y_)};
  }

 private:
  Corner* corner_;
  double x_, y_;
  double low_x_, low_y_, high_x_, high_y_;
};

ScanStar::Outline ScanStar::trace(const Scan& scan, const Vec2& sensor, double cell_m) {
  Pen pen(room_for(scan), sensor);
  if (scan.beams->full_circle()) {
    draw<true>(scan, cell_m, {0, scan.size(), scan.max_range_m, 0}, pen);
  } else {
    draw<false>(scan, cell_m, {0, scan.size() - 1, scan.max_range_m, 0}, pen);
  }
  return outline(pen);
}

ScanStar::Outline ScanStar::trace_near(const Scan& scan, const Vec2& sensor, double cell_m,
                                       double within_m, double depth_m, std::size_t& first_beam) {
  const auto part = near_part(scan, std::min(within_m, scan.max_range_m), depth_m, first_beam);
  if (!part) return {};
  Pen pen(room_for(scan), sensor);
  draw<false>(scan, cell_m, *part, pen);
  draw_back(scan, cell_m, *part, pen);
  return outline(pen);
}

// Surfaces belong to one part if what is drawn beside each would meet.
std::optional<ScanStar::Part> ScanStar::near_part(const Scan& scan, double within_m, double depth_m,
                                                  std::size_t& first_beam) {
  const std::size_t beams = scan.size();
  const double* const range_m = scan.range_m.data();
  const double returns_within_m = within_m / free_share(scan);
  const auto is_near = [&](std::size_t beam) {
    return range_m[beam] > 0 && range_m[beam] < returns_within_m;
  };
  std::size_t beam = first_beam;
  while (beam < beams && !is_near(beam)) ++beam;
  if (beam == beams) return std::nullopt;
  const std::size_t first_near = beam;
  std::size_t last_near = beam, beside = 0;
  double closest_m = returns_within_m;
  for (; beam < beams; ++beam) {
    if (is_near(beam)) {
      last_near = beam;
      closest_m = range_m[beam] < closest_m ? range_m[beam] : closest_m;
      beside = 0;
      continue;
    }
    if (beside == 0) beside = beams_across(depth_m / closest_m, scan) + 1;
    if (beam - last_near > 2 * beside) break;
  }
  if (beside == 0) beside = beams_across(depth_m / closest_m, scan) + 1;
  first_beam = last_near + 1;
  Part part{first_near - std::min(first_near, beside), std::min(beams - 1, last_near + beside),
            within_m, within_m};
  // Nothing of it may end before it begins.
  const double share = free_share(scan);
  for (std::size_t i = part.first; i <= part.end; ++i)
    part.shortest_m =
        std::min(part.shortest_m, free_length_m(range_m[i], scan.max_range_m, share, within_m));
  part.shortest_m = std::max(0.0, part.shortest_m - depth_m);
  return part;
}

ScanStar::Corner* ScanStar::room_for(const Scan& scan) {
  const std::size_t most = 3 * scan.size() + 4;
  if (corners_.size() < most) corners_.resize(most);
  return corners_.data() + 1;
}

ScanStar::Outline ScanStar::outline(const Pen& pen) {
  const auto count = static_cast<std::size_t>(pen.end() - corners_.data());
  const std::span<Corner> corners(corners_.data(), count);
  const Box box = pen.box();
  corners.front() = corners.back();
  if (box.low_column < 0 || box.low_row < 0) {
    for (Corner& corner : corners) {
      corner.column = floor_of(corner.x);
      corner.row = floor_of(corner.y);
    }
  }
  return {corners, box};
}

// The far side; `full`: all around.
template <bool full>
void ScanStar::draw(const Scan& scan, double cell_m, const Part& part, Pen& out) {
  Pen pen = out;  // in registers
  const double* const range_m = scan.range_m.data();
  const std::size_t beams = scan.size(), end = part.end;
  const double max_range_m = scan.max_range_m, longest_m = part.longest_m;
  const double share = free_share(scan);
  const auto wrapped = [beams](std::size_t i) { return full && i == beams ? 0 : i; };
  const auto free_m = [=](std::size_t i) {
    return free_length_m(range_m[wrapped(i)], max_range_m, share, longest_m);
  };
  const auto direction_cells = [&](std::size_t i) -> Vec2 {
    return scan.direction_world(wrapped(i)) / cell_m;
  };
  const std::size_t chord = beams_across(kChord_rad, scan);

  Vec2 direction = direction_cells(part.first);
  if (!full) pen.add(part.shortest_m, direction);
  double before_m = full ? -1 : part.shortest_m;  // how far the outline came on beam i
  double length_m = free_m(part.first);
  for (std::size_t i = part.first; i < end;) {
    std::size_t next = i + 1;
    const double next_m = free_m(next);
    const double both_m = length_m < next_m ? length_m : next_m;
    if (both_m == longest_m) {
      const std::size_t farthest = std::min(end, i + chord);
      while (next < farthest && free_m(next + 1) == longest_m) ++next;
    }
    if (both_m != before_m) pen.add(both_m, direction);
    direction = direction_cells(next);
    pen.add(both_m, direction);
    before_m = both_m;
    length_m = next_m;
    i = next;
  }
  out = pen;
}

// The near side, from the last beam to the second.
void ScanStar::draw_back(const Scan& scan, double cell_m, const Part& part, Pen& pen) {
  if (part.shortest_m == 0) return;
  const std::size_t chord = beams_across(kFirstChord_rad, scan);
  for (std::size_t i = part.end; i > part.first; i -= std::min(chord, i - part.first))
    pen.add(part.shortest_m, scan.direction_world(i) / cell_m);
}

}  // namespace voronaut
