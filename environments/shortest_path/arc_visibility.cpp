#include "voronaut/environments/shortest_path/arc_visibility.h"

#include <cmath>

#include "voronaut/environments/shortest_path/sight_cone.h"

namespace voronaut {
namespace {

// Tangents to a disc this many times both radii away deviate from the line of the centres by less
// than asin(1 / 4) = 0.253 rad; sectors are 1/16 to 1/8 rad wide.
constexpr double kFarInRadii = 4;
constexpr int kNeighbours = 5;
// Tangents are longer than the axis of their sector tells, by less than 1 / cos(1 / 16).
constexpr double kSlant = 1.01;

}  // namespace

ArcVisibility::ArcVisibility(const ShapeIndex& shapes, const Disc& disc, const FreeArc& arc,
                             int turn, double radius_m, double limit_m)
    : disc_(disc), turn_(turn) {
  constexpr double kHalf = 0.5 / kPerQuarter;
  for (int i = 0; i < kSectors; ++i) {
    const double middle = (i + 0.5) / kPerQuarter;
    const Vec2 out = direction_at(middle);
    const Vec2 side = direction_at(middle + kHalf);
    Sector& sector = sectors_[static_cast<std::size_t>(i)];
    sector = {disc.center + disc.radius_m * out, turn * left_of(out), -1, -1};
    const double past_start = quarters_ahead(arc.from_quarters, middle);
    if (!arc.whole() && past_start > arc.span_quarters + 1.1 * kHalf &&
        past_start < 4 - 1.1 * kHalf) {
      continue;
    }
    const double sine = cross(out, side) * (1 + 1e-9);
    const double slope = sine / out.dot(side);
    // The point of departure moves along the rim, and so along the axis, by less than radius x
    // sine.
    const SightCone cone{sector.apex, sector.axis, disc.radius_m * sine * (1 + slope), slope};
    sector.range_m = sight_range_m(shapes, cone, radius_m, limit_m);
  }
  for (int i = 0; i < kSectors; ++i) {
    double& around_m = sectors_[static_cast<std::size_t>(i)].around_m;
    for (int k = i - kNeighbours; k <= i + kNeighbours; ++k) {
      const auto near = static_cast<std::size_t>((k + kSectors) % kSectors);
      around_m = std::max(around_m, sectors_[near].range_m);
    }
  }
}

bool ArcVisibility::may_reach(const Disc& target) const {
  const Vec2 between = target.center - disc_.center;
  const double distance_m = between.norm();
  const double radii_m = disc_.radius_m + target.radius_m;
  if (distance_m <= kFarInRadii * radii_m) return true;
  // Tangents along the line of the centres depart a quarter turn to its side.
  const double around_m = sectors_[sector_of(quarter_turns(-turn_ * left_of(between)))].around_m;
  return around_m >= 0 && distance_m - radii_m <= kSlant * (around_m + disc_.radius_m);
}

bool ArcVisibility::may_reach(double depart_quarters, const Vec2& arrival) const {
  const Sector& sector = sectors_[sector_of(depart_quarters)];
  return sector.range_m >= 0 && sector.axis.dot(arrival - sector.apex) <= sector.range_m;
}

}  // namespace voronaut
