#pragma once

#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "voronaut/environments/shapes/geometry.h"

// A point in one vector register: x and y go through the same operations at once, with the same
// results as one by one.
namespace voronaut {

using PackedPoint __attribute__((vector_size(16))) = double;

inline PackedPoint packed(const Vec2& p) { return PackedPoint{p.x(), p.y()}; }

inline void store(PackedPoint p, Vec2& at) { std::memcpy(at.data(), &p, sizeof p); }

inline bool all_eight_equal(const double* numbers, double value) {
#ifdef __SSE2__
  const __m128d values = _mm_set1_pd(value);
  const auto two_equal = [=](int i) { return _mm_cmpeq_pd(_mm_loadu_pd(numbers + i), values); };
  const __m128d equal =
      _mm_and_pd(_mm_and_pd(two_equal(0), two_equal(2)), _mm_and_pd(two_equal(4), two_equal(6)));
  return _mm_movemask_pd(equal) == 3;
#else
  for (int i = 0; i < 8; ++i) {
    if (numbers[i] != value) return false;
  }
  return true;
#endif
}

inline double distance_sq(PackedPoint a, PackedPoint b) {
  const PackedPoint apart = a - b;
  const PackedPoint squares = apart * apart;
  return squares[0] + squares[1];
}

// What turns and moves points of a frame into the frame in which its origin and x axis are given.
struct PackedFrame {
  explicit PackedFrame(const Pose2& pose)
      : origin(packed(pose.p_world)),
        along_x{pose.heading.x(), pose.heading.x()},
        along_y{-pose.heading.y(), pose.heading.y()} {}

  PackedPoint at(const Vec2& direction, double range_m) const {
    const PackedPoint across{direction.y(), direction.x()};
    return origin +
           PackedPoint{range_m, range_m} * (along_x * packed(direction) + along_y * across);
  }

  PackedPoint origin;
  PackedPoint along_x;
  PackedPoint along_y;
};

}  // namespace voronaut
