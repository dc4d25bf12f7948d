#include "voronaut/planners/voronoi/delaunay.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <boost/polygon/voronoi.hpp>
#include <gmock/gmock.h>

#include "voronaut/tests/planners/voronoi/voronoi_worlds.h"

namespace voronaut {
namespace {

using namespace voronoi_test;

const Bounds kFrame{Vec2(-20, -20), Vec2(20, 20)};

DelaunayTriangulation triangulated(const std::vector<Vec2>& points) {
  DelaunayTriangulation d;
  d.reset(kFrame);
  for (const Vec2& p : points) d.insert(p);
  return d;
}

std::vector<Vec2> random_points(std::uint64_t seed, std::size_t n, double side_m = 30) {
  Random random(seed);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < n; ++i)
    points.emplace_back(random.uniform(-side_m / 2, side_m / 2),
                        random.uniform(-side_m / 2, side_m / 2));
  return points;
}

// Every triangle counter-clockwise, twins consistent, area covered, no site inside a circumcircle.
void expect_delaunay(const DelaunayTriangulation& d) {
  const Vec2 size = d.frame().max - d.frame().min;
  double area = 0;
  for (HalfEdgeId h = 0; h < static_cast<HalfEdgeId>(3 * d.triangle_count()); ++h) {
    const HalfEdgeId g = d.twin(h);
    if (g >= 0) {
      EXPECT_EQ(d.twin(g), h);
      EXPECT_EQ(d.origin(g), d.target(h));
      EXPECT_EQ(d.target(g), d.origin(h));
    }
    if (h % 3 != 0) continue;
    const Vec2 &a = d.site(d.origin(h)), &b = d.site(d.target(h)), &c = d.site(d.apex(h));
    const double doubled = cross(b - a, c - a);
    EXPECT_GT(doubled, 0);
    area += doubled / 2;
    const Vec2& center = d.circumcenter(h / 3);
    const double radius_m = (center - a).norm();
    for (const Vec2& s : d.sites())
      EXPECT_GE((center - s).norm(), radius_m * (1 - 1e-12) - 1e-9) << "triangle " << h / 3;
  }
  EXPECT_NEAR(area, size.x() * size.y(), 1e-6);
  EXPECT_EQ(d.triangle_count(), 2 * (d.site_count() - 4) + 2);
}

TEST(DelaunayTriangulation, HasNoSiteInsideACircumcircle) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    expect_delaunay(triangulated(random_points(seed, 20 * seed)));
}

TEST(DelaunayTriangulation, TakesCollinearAndCocircularSites) {
  std::vector<Vec2> grid, line, circle;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) grid.emplace_back(i, j);
  add_wall(line, {-10, 0}, {10, 0});
  add_wall(line, {0, -10}, {0, 10});
  add_circle(circle, {1, 2}, 5);
  for (const auto& points : {grid, line, circle}) expect_delaunay(triangulated(points));
}

TEST(DelaunayTriangulation, MakesOneSiteOfPointsThatRoundToOnePlace) {
  DelaunayTriangulation d;
  d.reset(kFrame);
  const SiteId s = d.insert(Vec2(1, 1));
  EXPECT_EQ(d.insert(Vec2(1, 1)), s);
  EXPECT_EQ(d.insert(Vec2(1 + 3e-6, 1 - 3e-6)), s);
  EXPECT_NE(d.insert(Vec2(1 + 2e-5, 1)), s);
  EXPECT_EQ(d.site_count(), 6u);
}

TEST(DelaunayTriangulation, RoundsByNoMoreThanItSays) {
  for (const Vec2& p : random_points(5, 2000)) {
    const auto d = triangulated({p});
    EXPECT_LE((d.site(4) - p).norm(), DelaunayTriangulation::kRounding * d.quantum_m());
  }
}

TEST(DelaunayTriangulation, FindsTheNearestSite) {
  const std::vector<Vec2> points = random_points(7, 300);
  const auto d = triangulated(points);
  for (const Vec2& q : random_points(8, 1000, 39)) {
    double least = 1e9;
    for (const Vec2& s : d.sites()) least = std::min(least, (s - d.rounded(q)).norm());
    EXPECT_EQ((d.site(d.nearest_site(q)) - d.rounded(q)).norm(), least);
  }
}

TEST(DelaunayTriangulation, VisitsEveryNeighbourOfASiteOnce) {
  const auto d = triangulated(random_points(9, 100));
  for (SiteId s = 0; s < static_cast<SiteId>(d.site_count()); ++s) {
    std::multiset<SiteId> seen, expected;
    d.for_each_leaving(s, [&](HalfEdgeId h) { seen.insert(d.target(h)); });
    for (HalfEdgeId h = 0; h < static_cast<HalfEdgeId>(3 * d.triangle_count()); ++h)
      if (d.origin(h) == s) expected.insert(d.target(h));
    EXPECT_EQ(seen, expected) << "site " << s;
  }
}

TEST(DelaunayTriangulation, TakesACoarserLatticeForAFrameBeyondTenKilometres) {
  for (const double half_m : {4'999.0, 5'001.0, 15'000.0, 20'000.0}) {
    DelaunayTriangulation d;
    d.reset({Vec2(-half_m, -half_m), Vec2(half_m, half_m)});
    EXPECT_EQ(d.quantum_m(), half_m < 5'000 ? 1e-5 : half_m < 10'000 ? 2e-5 : 4e-5);
    Random random(11);
    for (int i = 0; i < 300; ++i) {
      const double reach_m = i % 2 ? 0.99 * half_m : 5;
      const Vec2 p(random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m));
      EXPECT_LE((d.site(d.insert(p)) - p).norm(), DelaunayTriangulation::kRounding * d.quantum_m());
    }
    expect_delaunay(d);
  }
}

TEST(DelaunayTriangulation, RefusesAFrameThatIsTooLarge) {
  DelaunayTriangulation d;
  EXPECT_THROW(d.reset({Vec2(-20'001, 0), Vec2(20'001, 10)}), std::invalid_argument);
  EXPECT_THROW(d.reset({Vec2(0, 0), Vec2(0, 10)}), std::invalid_argument);
}

// Boost.Polygon shares no code with us: same lattice in, same Voronoi vertices out.
TEST(DelaunayTriangulation, IsDualToTheVoronoiDiagramOfBoostPolygon) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<Vec2> points = random_points(seed, 50 * seed, 20);
    if (seed % 2 == 0) add_wall(points, {-5, 1}, {5, 1.5});
    const auto d = triangulated(points);
    std::vector<boost::polygon::point_data<int>> lattice;
    for (const Vec2& s : d.sites())
      lattice.emplace_back(static_cast<int>(std::lround(s.x() / 1e-5)),
                           static_cast<int>(std::lround(s.y() / 1e-5)));
    boost::polygon::voronoi_diagram<double> diagram;
    boost::polygon::construct_voronoi(lattice.begin(), lattice.end(), &diagram);
    std::vector<Vec2> ours, theirs;
    for (std::size_t t = 0; t < d.triangle_count(); ++t)
      ours.push_back(d.circumcenter(static_cast<TriangleId>(t)));
    for (const auto& v : diagram.vertices()) theirs.emplace_back(v.x() * 1e-5, v.y() * 1e-5);
    const auto covered = [](const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
      return std::all_of(a.begin(), a.end(), [&](const Vec2& p) {
        return std::any_of(b.begin(), b.end(),
                           [&](const Vec2& q) { return (p - q).norm() <= 1e-9 * (1 + p.norm()); });
      });
    };
    EXPECT_TRUE(covered(ours, theirs)) << "seed " << seed;
    EXPECT_TRUE(covered(theirs, ours)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace voronaut
