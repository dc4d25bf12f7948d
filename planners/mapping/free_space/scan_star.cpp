#include "voronaut/planners/mapping/free_space/scan_star.h"

#include <algorithm>

#include "voronaut/planners/mapping/free_space/row_words.h"

namespace voronaut {

using row_words::floor_of;

namespace {

// Where nothing is in range, one chord spans several beams, a millimetre inside their arc.
constexpr double kChord_rad = 0.07;

std::size_t beams_per_chord(double spacing_rad, std::size_t beams) {
  const double most = static_cast<double>(beams);
  return static_cast<std::size_t>(std::clamp(kChord_rad / spacing_rad, 1.0, most));
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

void ScanStar::trace(const Scan& scan, const Vec2& sensor, double cell_m) {
  const std::size_t most = 2 * scan.size() + 2;
  if (corners_.size() < most) corners_.resize(most);
  Pen pen(corners_.data() + 1, sensor);
  if (scan.beams->full_circle()) {
    draw<true>(scan, cell_m, pen);
  } else {
    draw<false>(scan, cell_m, pen);
  }
  count_ = static_cast<std::size_t>(pen.end() - corners_.data());
  box_ = pen.box();
  corners_.front() = corners_[count_ - 1];
  if (box_.low_column < 0 || box_.low_row < 0) round_down();
}

void ScanStar::round_down() {
  for (std::size_t i = 0; i < count_; ++i) {
    Corner& corner = corners_[i];
    corner.column = floor_of(corner.x);
    corner.row = floor_of(corner.y);
  }
}

// On a full circle the beam after the last is the first.
template <bool full>
void ScanStar::draw(const Scan& scan, double cell_m, Pen& out) {
  Pen pen = out;  // in registers
  const double* const range_m = scan.range_m.data();
  const double max_range_m = scan.max_range_m;
  // The surface between two beams may stand out towards the sensor: a right-angled corner by half
  // their spacing.
  const double shortened = 1 - 0.5 * scan.beams->bearing_step_rad;
  const auto free_length_m = [=](double range) {
    if (range == max_range_m) return range;
    return range > 0 && range < max_range_m ? range * shortened : 0;
  };
  const std::size_t beams = scan.size();
  const std::size_t triangles = full ? beams : beams - 1;
  const auto wrapped = [beams](std::size_t i) { return full && i == beams ? 0 : i; };
  const auto direction_cells = [&](std::size_t i) -> Vec2 {
    return scan.direction_world(i) / cell_m;
  };
  const std::size_t chord = beams_per_chord(scan.beams->bearing_step_rad, beams);

  Vec2 direction = direction_cells(0);
  if (!full) pen.add(0, direction);
  double before_m = full ? -1 : 0;  // how far from the sensor the outline came to beam i
  double length_m = free_length_m(range_m[0]);
  for (std::size_t i = 0; i < triangles;) {
    std::size_t next = i + 1;
    const double next_m = free_length_m(range_m[wrapped(next)]);
    const double both_m = length_m < next_m ? length_m : next_m;
    if (both_m == max_range_m) {
      const std::size_t farthest = std::min(triangles, i + chord);
      while (next < farthest && range_m[wrapped(next + 1)] == max_range_m) ++next;
    }
    if (both_m != before_m) pen.add(both_m, direction);
    direction = direction_cells(wrapped(next));
    pen.add(both_m, direction);
    before_m = both_m;
    length_m = next_m;
    i = next;
  }
  out = pen;
}

}  // namespace voronaut
