#pragma once

#include <cmath>
#include <cstdint>

// Exact signs for points with integer coordinates below 2^29 in size.
namespace voronaut::lattice {

__extension__ using Int128 = __int128;

// Twice the signed area of (a, b, c): positive if counter-clockwise.
template <class Point>
std::int64_t doubled_area(const Point& a, const Point& b, const Point& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
         (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

// Whether d lies strictly inside the circle through a, b, c (counter-clockwise). The error bound of
// the filter is Shewchuk's iccerrboundA, https://doi.org/10.1007/PL00009321: differences of lattice
// points are exact in double precision.
template <class Point>
bool in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const std::int64_t ax = std::int64_t{a.x} - d.x;
  const std::int64_t ay = std::int64_t{a.y} - d.y;
  const std::int64_t bx = std::int64_t{b.x} - d.x;
  const std::int64_t by = std::int64_t{b.y} - d.y;
  const std::int64_t cx = std::int64_t{c.x} - d.x;
  const std::int64_t cy = std::int64_t{c.y} - d.y;

  const auto real = [](std::int64_t v) { return static_cast<double>(v); };
  const double bc1 = real(bx) * real(cy), bc2 = real(cx) * real(by);
  const double ca1 = real(cx) * real(ay), ca2 = real(ax) * real(cy);
  const double ab1 = real(ax) * real(by), ab2 = real(bx) * real(ay);
  const double a_sq = real(ax) * real(ax) + real(ay) * real(ay);
  const double b_sq = real(bx) * real(bx) + real(by) * real(by);
  const double c_sq = real(cx) * real(cx) + real(cy) * real(cy);
  const double determinant = a_sq * (bc1 - bc2) + b_sq * (ca1 - ca2) + c_sq * (ab1 - ab2);
  const double permanent = (std::fabs(bc1) + std::fabs(bc2)) * a_sq +
                           (std::fabs(ca1) + std::fabs(ca2)) * b_sq +
                           (std::fabs(ab1) + std::fabs(ab2)) * c_sq;
  constexpr double kEpsilon = 0x1p-53;
  constexpr double kBound = (10.0 + 96.0 * kEpsilon) * kEpsilon;
  if (std::fabs(determinant) > kBound * permanent) return determinant > 0;

  const Int128 exact = Int128{ax * ax + ay * ay} * (bx * cy - cx * by) +
                       Int128{bx * bx + by * by} * (cx * ay - ax * cy) +
                       Int128{cx * cx + cy * cy} * (ax * by - bx * ay);
  return exact > 0;
}

}  // namespace voronaut::lattice
