#include "voronaut/planners/mapping/free_space/free_space.h"

#include <gtest/gtest.h>

#include "voronaut/environments/random.h"
#include "voronaut/environments/shapes/shapes.h"

namespace voronaut {
namespace {

constexpr double kRightAngle_rad = 1.5707963267948966;
constexpr double kFullCircle_rad = 4 * kRightAngle_rad;
const Bounds kBounds{Vec2(-4, -4), Vec2(4, 4)};

// Ranges of circles seen from p, by hand: the nearest positive root of each ray.
Scan look(const Vec2& p, const Vec2& heading, const std::vector<Circle>& circles,
          double field_of_view_rad = kRightAngle_rad, std::size_t rays = 91) {
  Scan scan;
  scan.sensor_world = {p, heading};
  scan.beams = std::make_shared<BeamFan>(BeamFan::spread(field_of_view_rad, rays));
  scan.max_range_m = 2.5;
  for (std::size_t i = 0; i < rays; ++i) {
    double range_m = scan.max_range_m;
    scan.range_m.push_back(range_m);
    const Vec2 d = scan.direction_world(i);
    for (const Circle& c : circles) {
      const double along_m = (c.center - p).dot(d);
      const double miss_m = cross(d, c.center - p);
      const double root = c.radius_m * c.radius_m - miss_m * miss_m;
      if (root >= 0 && along_m > 0) range_m = std::min(range_m, along_m - std::sqrt(root));
    }
    scan.range_m.back() = range_m;
  }
  return scan;
}

TEST(FreeSpace, KnowsNothingBeforeTheFirstScanAndNothingOutsideItsBounds) {
  FreeSpace space(kBounds);
  EXPECT_FALSE(space.is_free(Vec2(0, 0)));
  space.mark_disc(Vec2(3.9, 0), 0.5);
  EXPECT_TRUE(space.is_free(Vec2(3.9, 0.3)));
  EXPECT_FALSE(space.is_free(Vec2(4.1, 0)));
  EXPECT_FALSE(space.swept_disc_is_free(Vec2(3.9, 0), Vec2(3.9, 0), 0.3));
}

TEST(FreeSpace, SweptDiscEndsAtTheBorderOfWhatIsKnown) {
  FreeSpace space(kBounds);
  space.mark_disc(Vec2(3.5, 0), 1);
  for (const Vec2& from : {Vec2(3.72, 0), Vec2(3.5, 0.1)}) {
    EXPECT_TRUE(space.swept_disc_is_free(from, Vec2(3.72, 0), 0.27));
    EXPECT_FALSE(space.swept_disc_is_free(from, Vec2(3.72, 0), 0.29));
  }
}

// Every cell by hand: its distance from the polygon, by its sides and by what holds what.
TEST(FreeSpace, AConvexPolygonIsFreeIfEveryCellThatItTouchesIs) {
  Random random(5);
  int free_ones = 0, all = 0;
  for (int round = 0; round < 400; ++round) {
    FreeSpace space(kBounds, {.cell_m = 0.1});
    for (int i = 0; i < 6; ++i)
      space.mark_disc(Vec2(random.uniform(-1, 1), random.uniform(-1, 1)), random.uniform(0.3, 1.3));
    const Vec2 heading = Vec2(random.uniform(-1, 1), random.uniform(0.1, 1)).normalized();
    const Polygon polygon = box(Vec2(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)),
                                random.uniform(0.1, 1), random.uniform(0.05, 0.5), heading);
    const double grown_m = random.uniform(0, 0.1);
    bool expected = true, at_the_edge = false;
    std::vector<Vec2> middles, expected_middles;
    for (int row = -40; row < 40; ++row) {
      for (int column = -40; column < 40; ++column) {
        const Vec2 middle(0.1 * column + 0.05, 0.1 * row + 0.05);
        const Polygon cell = box(middle, 0.1, 0.1);
        double distance_m = kInfinity;
        for (std::size_t i = 0; i < 4; ++i)
          for (std::size_t k = 0; k < 4; ++k)
            distance_m = std::min(distance_m, distance(edge(cell, i), edge(polygon, k)));
        if (encloses(polygon, middle) || encloses(cell, polygon.vertices[0])) distance_m = 0;
        if (space.is_free(middle)) continue;
        at_the_edge = at_the_edge || std::abs(distance_m - grown_m) < 1e-6;
        if (distance_m <= grown_m) {
          expected = false;
          expected_middles.push_back(middle);
        }
      }
    }
    if (at_the_edge) continue;
    ASSERT_EQ(space.convex_is_free(polygon.vertices, grown_m), expected) << round;
    space.unknown_cells_in_convex(polygon.vertices, grown_m, middles);
    for (const Vec2& middle : expected_middles)
      EXPECT_TRUE(std::ranges::any_of(middles, [&](const Vec2& m) {
        return (m - middle).norm() < 1e-9;
      })) << round;
    free_ones += expected;
    ++all;
  }
  EXPECT_GT(all, 350);
  EXPECT_GT(free_ones, 50);
  EXPECT_LT(free_ones, all - 50);
}

TEST(FreeSpace, APolygonProvesTheCellsThatLieWhollyWithinItAndNothingBeside) {
  Random random(6);
  for (int round = 0; round < 100; ++round) {
    FreeSpace space(kBounds);
    const Polygon polygon = box(Vec2(random.uniform(-1, 1), random.uniform(-1, 1)), 0.7, 0.4,
                                Vec2(random.uniform(-1, 1), random.uniform(0.1, 1)).normalized());
    space.mark_convex(polygon.vertices);
    for (int row = -40; row < 40; ++row) {
      for (int column = -40; column < 40; ++column) {
        const Vec2 middle((column + 0.5) * space.cell_m(), (row + 0.5) * space.cell_m());
        double least_m = kInfinity;
        for (const Vec2& corner : box(middle, space.cell_m(), space.cell_m()).vertices)
          least_m = std::min(least_m, -signed_distance(corner, polygon));
        if (std::abs(least_m) < 1e-9) continue;
        ASSERT_EQ(space.is_free(middle), least_m > 0) << round;
      }
    }
  }
}

// A wall may begin right beside the body.
TEST(FreeSpace, ABodyProvesWhatLiesWhollyWithinItAndNothingBeside) {
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    FreeSpace space(kBounds);
    const Vec2 p(random.uniform(-2, 2), random.uniform(-2, 2));
    const double radius_m = random.uniform(0.02, 0.6);
    space.mark_disc(p, radius_m);
    for (int row = -80; row < 80; ++row) {
      for (int column = -80; column < 80; ++column) {
        const Vec2 low(column * space.cell_m(), row * space.cell_m());
        const Vec2 high = low + Vec2::Constant(space.cell_m());
        const Vec2 farthest = (p - low).cwiseAbs().cwiseMax((p - high).cwiseAbs());
        if (std::abs(farthest.norm() - radius_m) < 1e-9) continue;
        ASSERT_EQ(space.is_free(0.5 * (low + high)), farthest.norm() < radius_m)
            << round << ": " << column << ", " << row;
      }
    }
  }
}

TEST(FreeSpace, AClearViewIsFreeWithinTheFieldOfViewAndTheRange) {
  FreeSpace space(kBounds);
  space.update(look(Vec2(0, 0), Vec2(1, 0), {}));
  EXPECT_TRUE(space.is_free(Vec2(1, 0)));
  EXPECT_TRUE(space.is_free(Vec2(1.5, 1.2)));
  EXPECT_FALSE(space.is_free(Vec2(2.6, 0)));
  EXPECT_FALSE(space.is_free(Vec2(1, 1.2)));
  EXPECT_FALSE(space.is_free(Vec2(-1, 0)));
}

TEST(FreeSpace, WhatLiesBehindAnObstacleStaysUnknown) {
  FreeSpace space(kBounds);
  space.update(look(Vec2(0, 0), Vec2(1, 0), {{Vec2(1.5, 0), 0.3}}));
  EXPECT_TRUE(space.is_free(Vec2(1.0, 0)));
  EXPECT_FALSE(space.is_free(Vec2(1.3, 0)));
  EXPECT_FALSE(space.is_free(Vec2(2.2, 0)));
  EXPECT_TRUE(space.is_free(Vec2(2.0, 1.0)));
}

TEST(FreeSpace, ABeamWithoutAMeasurementProvesNothing) {
  Scan scan = look(Vec2(0, 0), Vec2(1, 0), {});
  scan.range_m[45] = std::numeric_limits<double>::quiet_NaN();
  FreeSpace space(kBounds);
  space.update(scan);
  EXPECT_FALSE(space.is_free(Vec2(2, 0)));
  EXPECT_TRUE(space.is_free(Vec2(2, 0.3)));
}

// Property: no point of a cell that is called free lies inside an obstacle, whatever the scans.
TEST(FreeSpace, NeverCallsAnObstacleFree) {
  std::size_t free_cells = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    std::vector<Circle> circles;
    for (int i = 0; i < 12; ++i) {
      circles.push_back(
          {Vec2(random.uniform(-4, 4), random.uniform(-4, 4)), random.uniform(0.1, 0.6)});
    }
    FreeSpace space(kBounds);
    for (int i = 0; i < 10; ++i) {
      const Vec2 p(random.uniform(-3, 3), random.uniform(-3, 3));
      const bool inside = std::any_of(circles.begin(), circles.end(), [&](const Circle& c) {
        return (c.center - p).norm() < c.radius_m + 0.05;
      });
      if (inside) continue;
      const Vec2 heading = Vec2(random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
      space.update(i % 2 ? look(p, heading, circles)
                         : look(p, heading, circles, kFullCircle_rad, 360));
    }
    for (int i = 0; i < 4000; ++i) {
      const Vec2 p(random.uniform(-4, 4), random.uniform(-4, 4));
      if (!space.is_free(p)) continue;
      for (const Circle& c : circles) {
        ASSERT_GT((c.center - p).norm(), c.radius_m) << "seed " << seed << " at " << p.transpose();
      }
    }
    free_cells += space.free_cells();
  }
  EXPECT_GT(free_cells, 60 * 5000U);
}

// The outline of a scan's star in cells from the bounds' corner, written down from its definition:
// triangles between neighbouring beams, chords of up to 0.07 rad where nothing is in range.
std::vector<Vec2> outline_of(const Scan& scan, const Vec2& origin, double cell_m) {
  const bool full = scan.beams->full_circle();
  const std::size_t n = scan.size(), triangles = full ? n : n - 1;
  const double step_rad = scan.beams->bearing_step_rad;
  const auto length_m = [&](std::size_t i) {
    const double range_m = scan.range_m[i % n];
    if (range_m == scan.max_range_m) return range_m;
    return scan.is_return(i % n) ? range_m * (1 - step_rad / 2) : 0;
  };
  const auto at = [&](std::size_t i, double m) -> Vec2 {
    return (scan.sensor_world.p_world + m * scan.direction_world(i % n) - origin) / cell_m;
  };
  std::vector<Vec2> outline;
  if (!full) outline.push_back(at(0, 0));
  const std::size_t chord = std::max<std::size_t>(1, static_cast<std::size_t>(0.07 / step_rad));
  for (std::size_t i = 0; i < triangles;) {
    const double both_m = std::min(length_m(i), length_m(i + 1));
    std::size_t end = i + 1;
    while (both_m == scan.max_range_m && end < triangles && end - i < chord &&
           length_m(end + 1) == scan.max_range_m)
      ++end;
    outline.push_back(at(i, both_m));
    outline.push_back(at(end, both_m));
    i = end;
  }
  return outline;
}

// Whether a segment comes into the square of a cell: -1 no, 1 yes, 0 too close to its rim to say.
int meets_cell(const Vec2& a, const Vec2& b, int column, int row) {
  const double rim = 1e-6;
  if (std::min(a.x(), b.x()) > column + 1 + rim || std::max(a.x(), b.x()) < column - rim ||
      std::min(a.y(), b.y()) > row + 1 + rim || std::max(a.y(), b.y()) < row - rim)
    return -1;
  double enter[2] = {0, 0}, leave[2] = {1, 1};
  const double grown[2] = {1e-9, -1e-9};  // a larger square and a smaller one
  const Vec2 low(column, row);
  for (int k = 0; k < 2; ++k) {
    for (int axis = 0; axis < 2; ++axis) {
      const double along = b[axis] - a[axis];
      const double from = low[axis] - grown[k] - a[axis], to = low[axis] + 1 + grown[k] - a[axis];
      if (std::abs(along) < 1e-12) {
        if (from > 0 || to < 0) leave[k] = -1;
        continue;
      }
      enter[k] = std::max(enter[k], std::min(from / along, to / along));
      leave[k] = std::min(leave[k], std::max(from / along, to / along));
    }
  }
  if (enter[0] > leave[0]) return -1;
  return enter[1] <= leave[1] ? 1 : 0;
}

// Cell by cell from the outline: 1 wholly within, -1 not, 0 too close to say.
int lies_within(const std::vector<Vec2>& outline, int column, int row) {
  const Vec2 middle(column + 0.5, row + 0.5);
  bool inside = false, unsure = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const int meets = meets_cell(a, b, column, row);
    if (meets > 0) return -1;
    unsure = unsure || meets == 0;
    if ((a.y() > middle.y()) != (b.y() > middle.y()) &&
        middle.x() < a.x() + (middle.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return unsure ? 0 : inside ? 1 : -1;
}

// Property: after some scans exactly those cells are known free that one star covers, wherever the
// sensor stands: beside the bounds and across them, at corners of tiles, in bounds of any size.
TEST(FreeSpace, KnowsExactlyTheCellsThatTheStarOfOneScanCovers) {
  constexpr double kTile_m = 64 * 0.05;
  std::size_t free_cells = 0, compared = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const Vec2 corner(random.uniform(-30, 30), random.uniform(-30, 30));
    const Bounds narrow{corner, corner + Vec2(random.uniform(3, 8), random.uniform(3, 8))};
    const Bounds wide{corner - Vec2(8000, 9000), corner + Vec2(11'000, 9'000)};
    const Bounds bounds = seed % 2 ? narrow : wide;
    FreeSpace space(bounds);
    std::vector<Circle> circles;
    std::vector<std::vector<Vec2>> outlines;
    // Of a corner of tiles, or of the bounds.
    const Vec2 around =
        seed % 4 < 2 ? narrow.min
                     : Vec2(bounds.min +
                            kTile_m * Vec2((0.5 * (narrow.min + narrow.max) - bounds.min) / kTile_m)
                                          .array()
                                          .round()
                                          .matrix());
    for (int i = 0; i < 8; ++i)
      circles.push_back(
          {around + Vec2(random.uniform(-2, 2), random.uniform(-2, 2)), random.uniform(0.05, 0.4)});
    for (int i = 0; i < 3; ++i) {
      const Vec2 p = around + Vec2(random.uniform(-2, 2), random.uniform(-2, 2));
      const Vec2 heading = Vec2(random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
      Scan scan = i == 0   ? look(p, heading, circles)
                  : i == 1 ? look(p, heading, circles, kFullCircle_rad, 360)
                           : look(p, heading, circles, 3 * kRightAngle_rad, 40);
      if (seed % 5 == 0) scan.range_m[scan.size() / 3] = 0;
      space.update(scan);
      outlines.push_back(outline_of(scan, bounds.min, space.cell_m()));
    }
    const Vec2 cell = (around - bounds.min) / space.cell_m();
    const Vec2 size = (bounds.max - bounds.min) / space.cell_m();  // the last cells reach beyond
    for (int row = static_cast<int>(cell.y()) - 95; row < cell.y() + 95; ++row) {
      for (int column = static_cast<int>(cell.x()) - 95; column < cell.x() + 95; ++column) {
        const Vec2 middle = bounds.min + space.cell_m() * Vec2(column + 0.5, row + 0.5);
        int expected = -1;
        for (const std::vector<Vec2>& outline : outlines)
          expected = std::max(expected, lies_within(outline, column, row));
        if (column < 0 || row < 0 || column >= size.x() || row >= size.y()) expected = -1;
        if (expected == 0) continue;
        ASSERT_EQ(space.is_free(middle), expected > 0)
            << "seed " << seed << " column " << column << " row " << row;
        ++compared;
        free_cells += expected > 0;
      }
    }
  }
  EXPECT_GT(compared, 1'000'000U);
  EXPECT_GT(free_cells, 100'000U);
}

// A star larger than what is drawn at once, in rows that take many words.
TEST(FreeSpace, KnowsFarViewsToo) {
  const Bounds bounds{Vec2(-700, -700), Vec2(700, 700)};
  int free_cells = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    FreeSpace space(bounds, {.cell_m = 0.05});
    Scan scan = look(Vec2(0.01, 0.02), Vec2(1, 0), {}, kFullCircle_rad, 360);
    scan.max_range_m = 300;
    Random random(seed);
    for (double& range_m : scan.range_m)
      range_m = random.uniform(0, 1) < 0.5 ? 300 : random.uniform(1, 300);
    space.update(scan);
    const std::vector<Vec2> outline = outline_of(scan, bounds.min, space.cell_m());
    for (int i = 0; i < 6'000; ++i) {
      const int column = static_cast<int>(14'000 + random.uniform(-6100, 6100));
      // Two beams run along the row of the sensor.
      const int row = i % 4 ? static_cast<int>(14'000 + random.uniform(-6100, 6100)) : 14'000;
      const int expected = lies_within(outline, column, row);
      if (expected == 0) continue;
      ASSERT_EQ(space.is_free(bounds.min + space.cell_m() * Vec2(column + 0.5, row + 0.5)),
                expected > 0)
          << "seed " << seed << " column " << column << " row " << row;
      free_cells += expected > 0;
    }
  }
  EXPECT_GT(free_cells, 3000);
}

TEST(FreeSpace, RefusesBoundsOfMoreCellsThanItCounts) {
  EXPECT_THROW(FreeSpace({Vec2(0, 0), Vec2(1e6, 1)}), std::invalid_argument);
  EXPECT_THROW(FreeSpace({Vec2(0, 0), Vec2(0, 1)}), std::invalid_argument);
  for (const int splits : {0, 3, 16})
    EXPECT_THROW(FreeSpace(kBounds, {.splits = splits}), std::invalid_argument);
}

// Property: the row by row test of a swept disc equals asking every cell that it touches.
TEST(FreeSpace, SweptDiscIsFreeExactlyIfEveryCellItTouchesIs) {
  const double cell_m = 0.05;
  int free_count = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    FreeSpace space(kBounds, {.cell_m = cell_m});
    for (int i = 0; i < 8; ++i) {
      space.mark_disc(Vec2(random.uniform(-2, 2), random.uniform(-2, 2)), random.uniform(0.5, 1.5));
    }
    for (int i = 0; i < 100; ++i) {
      const Vec2 a(random.uniform(-2, 2), random.uniform(-2, 2));
      const Vec2 b = a + Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
      const double radius_m = random.uniform(0.05, 0.4);
      bool all_free = true;
      bool close_call = false;
      for (int row = -80; row < 80; ++row) {
        for (int column = -80; column < 80; ++column) {
          // Distance from the cell to the segment: its closest point by fine sampling of the edge.
          const Vec2 low(column * cell_m, row * cell_m);
          const Vec2 center = low + Vec2(0.5, 0.5) * cell_m;
          if (std::abs(distance(center, Segment{a, b}) - radius_m) > cell_m) {
            if (distance(center, Segment{a, b}) < radius_m && !space.is_free(center))
              all_free = false;
            continue;
          }
          double nearest_m = 1e9;
          for (int k = 0; k <= 200; ++k) {
            const Vec2 q = a + (b - a) * (k / 200.0);
            const Vec2 in = q.cwiseMax(low).cwiseMin(low + Vec2(cell_m, cell_m));
            nearest_m = std::min(nearest_m, (q - in).norm());
          }
          if (std::abs(nearest_m - radius_m) < 2e-4) close_call = true;
          const bool touched = nearest_m <= radius_m;
          if (touched && !space.is_free(center)) all_free = false;
        }
      }
      if (close_call) continue;
      ASSERT_EQ(space.swept_disc_is_free(a, b, radius_m), all_free) << "seed " << seed << " " << i;
      free_count += all_free;
    }
  }
  EXPECT_GT(free_count, 10);
}

// What a near part of a star is known to hold: its own definition, a disc around each surface.
bool lies_beside_a_surface(const Scan& scan, const Vec2& middle_world, double near_m,
                           double beside_m) {
  for (std::size_t i = 0; i < scan.size(); ++i)
    if (scan.is_return(i) && scan.range_m[i] < near_m &&
        (scan.point_world(i) - middle_world).norm() < beside_m)
      return true;
  return false;
}

// Scans are taken by turns: what a whole star proves, and what it proves beside near surfaces.
void see(FreeSpace& space, const Scan& scan) {
  space.update(scan);
  space.update(scan);
}

// Property: cell by cell and part by part, nothing is known free that no single star covers, and
// beside surfaces that are near all that one covers is.
TEST(FreeSpace, KnowsPartsOfCellsBesideSurfacesAndNoneThatNoStarCovers) {
  constexpr double kCell_m = 0.1, kNear_m = 1.0;
  std::size_t free_parts = 0, wanted_parts = 0, compared = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    Random random(seed);
    const int splits = seed % 3 == 0 ? 4 : 8;
    const double part_m = kCell_m / splits;
    const Vec2 corner(random.uniform(-30, 30), random.uniform(-30, 30));
    const Bounds narrow{corner, corner + Vec2(random.uniform(3, 8), random.uniform(3, 8))};
    const Bounds wide{corner - Vec2(8000, 9000), corner + Vec2(9'000, 9'000)};
    const Bounds bounds = seed % 2 ? narrow : wide;
    FreeSpace space(bounds, {.cell_m = kCell_m, .splits = splits, .near_m = kNear_m});
    const Vec2 around = seed % 4 < 2 ? narrow.min : Vec2(0.5 * (narrow.min + narrow.max));
    std::vector<Circle> circles;
    for (int i = 0; i < 10; ++i)
      circles.push_back({around + Vec2(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)),
                         random.uniform(0.05, 0.4)});
    std::vector<Scan> scans;
    std::vector<std::vector<Vec2>> cell_outlines, part_outlines;
    for (int i = 0; i < 3; ++i) {
      const Vec2 p = around + Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
      const Vec2 heading = Vec2(random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
      Scan scan = i == 0   ? look(p, heading, circles)
                  : i == 1 ? look(p, heading, circles, kFullCircle_rad, 360)
                           : look(p, heading, circles, 3 * kRightAngle_rad, 61);
      if (seed % 5 == 0) scan.range_m[scan.size() / 3] = 0;
      see(space, scan);
      cell_outlines.push_back(outline_of(scan, bounds.min, kCell_m));
      part_outlines.push_back(outline_of(scan, bounds.min, part_m));
      scans.push_back(scan);
    }
    const auto covered = [](const std::vector<std::vector<Vec2>>& outlines, int column, int row) {
      int most = -1;
      for (const std::vector<Vec2>& outline : outlines)
        most = std::max(most, lies_within(outline, column, row));
      return most;
    };
    const Vec2 size = (bounds.max - bounds.min) / part_m;
    const Vec2 middle_part = (around - bounds.min) / part_m;
    for (int i = 0; i < 12'000; ++i) {
      const int column = static_cast<int>(middle_part.x() + random.uniform(-2, 2) / part_m);
      const int row = static_cast<int>(middle_part.y() + random.uniform(-2, 2) / part_m);
      const Vec2 middle = bounds.min + part_m * Vec2(column + 0.5, row + 0.5);
      const bool inside = column >= 0 && row >= 0 && column < size.x() && row < size.y();
      const int in_cells =
          covered(cell_outlines, column >= 0 ? column / splits : -1, row >= 0 ? row / splits : -1);
      const int in_parts = covered(part_outlines, column, row);
      const bool known = space.is_free(middle);
      ++compared;
      if (known) {
        ++free_parts;
        ASSERT_TRUE(inside && (in_cells >= 0 || in_parts >= 0))
            << "seed " << seed << " column " << column << " row " << row;
        continue;
      }
      ASSERT_FALSE(inside && in_cells > 0) << "seed " << seed << " " << column << " " << row;
      // The one scan of a full circle has a seam, the others have none.
      for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
        if (!inside || lies_within(part_outlines[k], column, row) <= 0) continue;
        const double away_m = (middle - scans[k].sensor_world.p_world).norm();
        const bool wanted =
            away_m < 0.9 * kNear_m && lies_beside_a_surface(scans[k], middle, 0.95 * kNear_m, 0.1);
        ASSERT_FALSE(wanted) << "seed " << seed << " scan " << k << " " << column << " " << row;
      }
    }
    wanted_parts += space.free_parts();
  }
  EXPECT_GT(compared, 250'000U);
  EXPECT_GT(free_parts, 50'000U);
  EXPECT_GT(wanted_parts, 20'000U);
}

// Property: the same of a swept disc, against asking the part in each place.
TEST(FreeSpace, SweptDiscIsFreeExactlyIfEveryPartItTouchesIs) {
  constexpr double kPart_m = 0.0125;
  int free_count = 0, refused = 0, in_parts = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    FreeSpace space(kBounds, {.cell_m = 0.1, .splits = 8});
    std::vector<Circle> circles;
    for (int i = 0; i < 5; ++i)
      circles.push_back(
          {Vec2(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8)), random.uniform(0.05, 0.2)});
    for (int i = 0; i < 10; ++i) {
      const Vec2 p(random.uniform(-1, 1), random.uniform(-1, 1));
      if (std::ranges::any_of(
              circles, [&](const Circle& c) { return (c.center - p).norm() < c.radius_m + 0.02; }))
        continue;
      see(space, look(p, Vec2(1, 0), circles, kFullCircle_rad, 360));
    }
    for (int i = 0; i < 100; ++i) {
      const Vec2 a(random.uniform(-1, 1), random.uniform(-1, 1));
      const Vec2 b = a + Vec2(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
      const double radius_m = random.uniform(0.02, 0.2);
      bool all_free = true, close_call = false;
      for (double y = -1.6; y < 1.6; y += kPart_m) {
        for (double x = -1.6; x < 1.6; x += kPart_m) {
          const Vec2 low(std::round(x / kPart_m) * kPart_m, std::round(y / kPart_m) * kPart_m);
          const Vec2 middle = low + Vec2::Constant(0.5 * kPart_m);
          const double middle_m = distance(middle, Segment{a, b});
          if (middle_m > radius_m + kPart_m) continue;
          double nearest_m = middle_m;
          for (int k = 0; k <= 100; ++k) {
            const Vec2 q = a + (b - a) * (k / 100.0);
            const Vec2 in = q.cwiseMax(low).cwiseMin(low + Vec2::Constant(kPart_m));
            nearest_m = std::min(nearest_m, (q - in).norm());
          }
          if (std::abs(nearest_m - radius_m) < 2e-4)
            close_call = close_call || !space.is_free(middle);
          if (nearest_m <= radius_m && !space.is_free(middle)) all_free = false;
        }
      }
      if (close_call) continue;
      ASSERT_EQ(space.swept_disc_is_free(a, b, radius_m), all_free) << "seed " << seed << " " << i;
      free_count += all_free;
      refused += !all_free;
    }
    in_parts += space.free_parts() > 0;
  }
  EXPECT_GT(free_count, 200);
  EXPECT_GT(refused, 200);
  EXPECT_EQ(in_parts, 40);
}

TEST(FreeSpace, NamesEveryUnknownCellThatATubeTouches) {
  Random random(5);
  std::vector<Vec2> unknown;
  int refused = 0;
  for (int round = 0; round < 400; ++round) {
    FreeSpace space(kBounds, {.cell_m = 0.05, .splits = round % 2 ? 1 : 4});
    space.mark_disc(Vec2(0, 0), random.uniform(0.5, 1.5));
    std::vector<Vec2> corners;
    for (int i = 0; i < 3; ++i)
      corners.emplace_back(random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6));
    const double radius_m = random.uniform(0.05, 0.4);
    space.unknown_cells_in_tube(corners, radius_m, unknown);
    const bool free = space.swept_disc_is_free(corners[0], corners[1], radius_m) &&
                      space.swept_disc_is_free(corners[1], corners[2], radius_m);
    EXPECT_TRUE(free || !unknown.empty());
    refused += free ? 0 : 1;
    for (const Vec2& middle : unknown) {
      EXPECT_FALSE(space.is_free(middle));
      const double distance_m = std::min(distance(middle, Segment{corners[0], corners[1]}),
                                         distance(middle, Segment{corners[1], corners[2]}));
      EXPECT_LE(distance_m, radius_m + space.part_radius_m());
    }
  }
  EXPECT_GT(refused, 50);
  EXPECT_LT(refused, 350);
}

}  // namespace
}  // namespace voronaut
