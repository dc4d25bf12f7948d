#include "voronaut/environments/formats/sdf_body.h"

#include <cmath>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/formats/csv_table.h"

namespace voronaut {
namespace {

// What a simulator leaves of a tilt when it saves a world: 0.1 mm in 1 m of height.
constexpr double kUpright_rad = 1e-4;
// Bodies that end at the plane touch it, whatever rounding left of their height.
constexpr double kTouching_m = 1e-9;

double checked_size_m(const XmlElement& element, double size_m) {
  if (size_m < kSmallestRadius || size_m > kLargestRadius)
    throw element.error("expected a size from " + number_text(kSmallestRadius) + " to " +
                        number_text(kLargestRadius) + ", got " + number_text(size_m));
  return size_m;
}

XmlElement required(const XmlElement& shape, const char* key) {
  if (const auto found = shape.child(key)) return *found;
  throw shape.error("a <" + shape.name() + "> without its " + key);
}

double radius_m(const XmlElement& shape) {
  const XmlElement radius = required(shape, "radius");
  return checked_size_m(radius, read_numbers(radius, "radius", 1)[0]);
}

// SDF's own where a cylinder does not say.
double length_m(const XmlElement& cylinder) {
  const auto length = cylinder.child("length");
  return length ? checked_size_m(*length, read_numbers(*length, "length", 1)[0]) : 1;
}

void require_level(const XmlElement& plane) {
  const auto normal = plane.child("normal");
  if (!normal) return;
  const auto n = read_numbers(*normal, "normal", 3);
  if (std::abs(n[0]) + std::abs(n[1]) > kUpright_rad * std::abs(n[2]))
    throw normal->error("a plane that is not level cannot be read");
}

std::optional<SdfBody> read_shape(const XmlElement& shape) {
  const std::string kind = shape.name();
  if (kind == "empty") return std::nullopt;
  if (kind == "plane") {
    require_level(shape);
    return std::nullopt;
  }
  if (kind == "cylinder") {
    const double width_m = 2 * radius_m(shape);
    return SdfBody{SdfBody::Kind::cylinder, {width_m, width_m, length_m(shape)}};
  }
  if (kind == "sphere")
    return SdfBody{SdfBody::Kind::sphere, Eigen::Vector3d::Constant(2 * radius_m(shape))};
  if (kind == "box") {
    const XmlElement size = required(shape, "size");
    const auto sides = read_numbers(size, "size", 3);
    for (const double side_m : sides) checked_size_m(size, side_m);
    return SdfBody{SdfBody::Kind::box, {sides[0], sides[1], sides[2]}};
  }
  throw shape.error("a collision of <" + kind +
                    "> cannot be read (allowed: cylinder, box, sphere, plane)");
}

SdfBody scaled(SdfBody body, const Eigen::Vector3d& scale, const XmlElement& collision) {
  body.size = body.size.cwiseProduct(scale);
  for (const double side_m : body.size) checked_size_m(collision, side_m);
  const bool is_round = body.kind != SdfBody::Kind::box;
  const bool is_sphere = body.kind == SdfBody::Kind::sphere;
  if ((is_round && scale.x() != scale.y()) || (is_sphere && scale.x() != scale.z()))
    throw collision.error("a round body that is scaled out of round cannot be read");
  return body;
}

}  // namespace

std::optional<SdfBody> read_body(const XmlElement& collision, const Eigen::Vector3d& scale) {
  const auto geometry = collision.child("geometry");
  std::optional<SdfBody> body;
  for (const XmlElement& shape : geometry ? geometry->children() : std::vector<XmlElement>{})
    if (const auto read = read_shape(shape)) body = scaled(*read, scale, collision);
  return body;
}

void add_footprint(const SdfBody& body, const SdfPose& T_world_body, const ForeignOptions& options,
                   const XmlElement& place, ForeignWorld& world) {
  const Eigen::Matrix3d& turn = T_world_body.rotation;
  const Vec2 p = T_world_body.p.head<2>();
  const bool is_cut = options.cut == BodyCut::plane;
  const double above_m = std::abs(T_world_body.p.z() - options.height_m);
  const double half_height_m = body.size.z() / 2;
  const bool is_sphere = body.kind == SdfBody::Kind::sphere;
  if (!is_sphere && std::hypot(turn(0, 2), turn(1, 2)) > kUpright_rad)
    throw place.error("a tilted obstacle cannot be read");
  if (is_cut && above_m > half_height_m + kTouching_m) {
    ++world.bodies_off_plane;
    return;
  }
  double radius_m = body.size.x() / 2;
  if (is_sphere && is_cut)
    radius_m = std::sqrt(std::max(radius_m * radius_m - above_m * above_m, 0.0));
  if (body.kind == SdfBody::Kind::box)
    world.shapes.polygons.push_back(
        box(p, body.size.x(), body.size.y(), Vec2(turn(0, 0), turn(1, 0)).normalized()));
  else if (radius_m >= kSmallestRadius)
    world.shapes.circles.push_back({p, radius_m});
}

}  // namespace voronaut
