#include "voronaut/environments/formats/dodgedrone.h"

#include <algorithm>
#include <cmath>

#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/text_lines.h"

namespace voronaut {
namespace {

constexpr double kParked_m = 1000;

std::vector<std::string_view> comma_separated(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t comma = 0; comma != std::string_view::npos;) {
    comma = line.find(',');
    std::string_view field = line.substr(0, comma);
    while (!field.empty() && (field.front() == ' ' || field.front() == '\t'))
      field.remove_prefix(1);
    while (!field.empty() && (field.back() == ' ' || field.back() == '\t')) field.remove_suffix(1);
    fields.push_back(field);
    if (comma != std::string_view::npos) line.remove_prefix(comma + 1);
  }
  return fields;
}

// Equal but for what rounding leaves of a diameter.
bool is_near(double one_m, double other_m) { return std::abs(one_m - other_m) <= 1e-6 * other_m; }

struct Sphere {
  double x_m, y_m, z_m, radius_m;

  bool is_parked() const {
    return std::max({std::abs(x_m), std::abs(y_m), std::abs(z_m)}) >= kParked_m;
  }
};

Sphere sphere_of(const TextLines& lines) {
  const auto fields = comma_separated(lines.line());
  if (fields.size() != 11)
    throw lines.error("expected 11 fields (prefab, x, y, z, qw, qx, qy, qz, sx, sy, sz), got " +
                      std::to_string(fields.size()));
  const Sphere sphere{lines.real(fields[1], "x", -kFarthestCoordinate, kFarthestCoordinate),
                      lines.real(fields[2], "y", -kFarthestCoordinate, kFarthestCoordinate),
                      lines.real(fields[3], "z", -kFarthestCoordinate, kFarthestCoordinate),
                      lines.real(fields[8], "sx", kSmallestRadius, kLargestRadius) / 2};
  const double width_m = lines.real(fields[9], "sy", 0, kLargestRadius);
  const double height_m = lines.real(fields[10], "sz", 0, kLargestRadius);
  if (!sphere.is_parked() &&
      !(is_near(width_m, 2 * sphere.radius_m) && is_near(height_m, 2 * sphere.radius_m)))
    throw lines.error("sx, sy and sz differ: only spheres are read");
  return sphere;
}

}  // namespace

ForeignWorld parse_dodgedrone(std::string_view text, const std::string& file,
                              const ForeignOptions& options) {
  ForeignWorld world;
  world.bounds = Bounds{{-2, -12}, {20, 12}};
  world.start = Vec2(0, 0);
  world.goal = Vec2(18, 0);
  TextLines lines(text, file);
  while (lines.next()) {
    if (lines.words().empty()) continue;
    const Sphere sphere = sphere_of(lines);
    if (sphere.is_parked()) continue;
    const double above_m = options.cut == BodyCut::columns ? 0 : sphere.z_m - options.height_m;
    const double left_sq = sphere.radius_m * sphere.radius_m - above_m * above_m;
    if (left_sq >= kSmallestRadius * kSmallestRadius)
      world.shapes.circles.push_back({{sphere.x_m, sphere.y_m}, std::sqrt(left_sq)});
    else
      ++world.bodies_off_plane;
  }
  if (lines.number() == 0) throw lines.error("the file is empty");
  return world;
}

}  // namespace voronaut
