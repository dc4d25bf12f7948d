#include "voronaut/dynamics/regulators/path_form.h"

namespace voronaut {

PathForm PathForm::of(const PathSegment& segment) {
  PathForm form;
  if (segment.kind == PathSegment::Kind::line) {
    const Eigen::Vector2d along = (segment.end - segment.start).normalized();
    form.L = {-along.y(), along.x()};
    form.c = -form.L.dot(segment.start);
    form.sense = 1;
    return form;
  }
  const Eigen::Vector2d& center = segment.center;
  const double radius_m = (segment.start - center).norm();
  form.N = Eigen::Matrix2d::Identity() / (2 * radius_m);
  form.L = -center / radius_m;
  form.c = (center.squaredNorm() - radius_m * radius_m) / (2 * radius_m);
  form.sense = segment.counter_clockwise ? -1 : 1;
  return form;
}

}  // namespace voronaut
