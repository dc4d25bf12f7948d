#include "voronaut/reports/trace/delta_json.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace voronaut {

namespace {

using nlohmann::json;

constexpr double kLargest = 9007199254740992.0;  // 2^53: the integers a browser's number can hold

bool representable(double scaled) { return std::abs(scaled) < kLargest; }

// Where a polyline's differences begin: 0 where the origin is not finite.
std::int64_t begin_of(double origin_m, double per_metre) {
  return representable(origin_m * per_metre) ? std::llround(origin_m * per_metre) : 0;
}

}  // namespace

void DeltaWriter::push(double value, double scale) {
  const double scaled = value * scale;
  if (!representable(scaled)) {
    column_.push_back(nullptr);
    return;
  }
  const std::int64_t rounded = std::llround(scaled);
  column_.push_back(rounded - previous_);
  previous_ = rounded;
}

double DeltaReader::next(const json& entry, double scale) {
  if (entry.is_null()) return std::numeric_limits<double>::quiet_NaN();
  sum_ += entry.get<std::int64_t>();
  return static_cast<double>(sum_) / scale;
}

json points_to_json(const std::vector<TracePoint>& points, double per_metre,
                    const TracePoint& origin) {
  json flat = json::array();
  std::int64_t x_before = begin_of(origin.x_m, per_metre);
  std::int64_t y_before = begin_of(origin.y_m, per_metre);
  for (const TracePoint& p : points) {
    if (!representable(p.x_m * per_metre) || !representable(p.y_m * per_metre)) {
      throw std::invalid_argument("a trace holds a point that is not finite");
    }
    const std::int64_t x = std::llround(p.x_m * per_metre);
    const std::int64_t y = std::llround(p.y_m * per_metre);
    flat.push_back(x - x_before);
    flat.push_back(y - y_before);
    x_before = x;
    y_before = y;
  }
  return flat;
}

std::vector<TracePoint> points_from_json(const json& flat, double per_metre,
                                         const TracePoint& origin) {
  if (flat.size() % 2 != 0) {
    throw std::invalid_argument("a polyline with half a point");
  }
  std::int64_t x = begin_of(origin.x_m, per_metre);
  std::int64_t y = begin_of(origin.y_m, per_metre);
  std::vector<TracePoint> points;
  points.reserve(flat.size() / 2);
  for (std::size_t i = 0; i < flat.size(); i += 2) {
    x += flat[i].get<std::int64_t>();
    y += flat[i + 1].get<std::int64_t>();
    points.push_back({static_cast<double>(x) / per_metre, static_cast<double>(y) / per_metre});
  }
  return points;
}

}  // namespace voronaut
