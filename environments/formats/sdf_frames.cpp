#include "voronaut/environments/formats/sdf_frames.h"

#include <array>
#include <cmath>
#include <numbers>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/generators/placement.h"

namespace voronaut {
namespace {

constexpr int kMostSteps = 1000;

// About a coordinate axis: 0 is x, 1 is y, 2 is z.
Eigen::Matrix3d turn_about(int axis, double angle_rad) {
  const Vec2 cos_sin = unit_vector(angle_rad);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn(u, u) = turn(v, v) = cos_sin.x();
  turn(u, v) = -cos_sin.y();
  turn(v, u) = cos_sin.y();
  return turn;
}

Eigen::Matrix3d of_quaternion(const XmlElement& pose, Eigen::Vector3d v, double w) {
  const double length = std::sqrt(v.squaredNorm() + w * w);
  if (!(length > 1e-9)) throw pose.error("pose: a quaternion without length");
  v /= length;
  w /= length;
  Eigen::Matrix3d cross_with_v;
  cross_with_v << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return (w * w - v.squaredNorm()) * Eigen::Matrix3d::Identity() + 2 * v * v.transpose() +
         2 * w * cross_with_v;
}

}  // namespace

std::vector<double> read_numbers(const XmlElement& element, std::string_view what,
                                 std::size_t count) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::string text = element.text();
  std::vector<double> numbers;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view word = rest.substr(0, rest.find_first_of(kBlank));
    rest.remove_prefix(word.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlank), rest.size()));
    const auto value = parse_number(word);
    if (!value || std::abs(*value) > kFarthestCoordinate)
      throw element.error(std::string(what) + ": expected a number, got " + in_quotes(word));
    numbers.push_back(*value);
  }
  if (numbers.size() != count)
    throw element.error(std::string(what) + ": expected " + std::to_string(count) +
                        " numbers, got " + std::to_string(numbers.size()));
  return numbers;
}

SdfPose read_pose(const XmlElement& element) {
  const auto pose = element.child("pose");
  if (!pose || pose->text().empty()) return {};
  if (pose->attribute("rotation_format") == "quat_xyzw") {
    const auto q = read_numbers(*pose, "pose", 7);
    return {of_quaternion(*pose, {q[3], q[4], q[5]}, q[6]), {q[0], q[1], q[2]}};
  }
  const auto numbers = read_numbers(*pose, "pose", 6);
  const std::string degrees = pose->attribute("degrees");
  const double unit_rad = degrees == "true" || degrees == "1" ? std::numbers::pi / 180 : 1;
  return {turn_about(2, numbers[5] * unit_rad) * turn_about(1, numbers[4] * unit_rad) *
              turn_about(0, numbers[3] * unit_rad),
          {numbers[0], numbers[1], numbers[2]}};
}

std::string pose_frame(const XmlElement& element) {
  const auto pose = element.child("pose");
  if (!pose) return "";
  // Its name since SDF 1.7, and before.
  const std::string frame = pose->attribute("relative_to");
  return frame.empty() ? pose->attribute("frame") : frame;
}

SdfPose SdfFrames::pose_of(const XmlElement& element) const {
  int steps = kMostSteps;
  return pose_of(element, steps);
}

SdfPose SdfFrames::frame(const std::string& name, const XmlElement& asker) const {
  int steps = kMostSteps;
  return frame(name, asker, steps);
}

SdfPose SdfFrames::pose_of(const XmlElement& element, int& steps) const {
  std::string base = pose_frame(element);
  if (base.empty() && element.name() == "frame") base = element.attribute("attached_to");
  if (base.empty() && element.name() == "joint") {
    const auto child = element.child("child");
    base = child ? child->text() : "";
  }
  const SdfPose pose =
      base.empty() ? read_pose(element) : frame(base, element, steps) * read_pose(element);
  const std::string placed = element.name() == "model" ? element.attribute("placement_frame") : "";
  if (placed.empty()) return pose;
  return pose * SdfFrames(element).frame(placed, element, steps).inverse();
}

SdfPose SdfFrames::frame(const std::string& name, const XmlElement& asker, int& steps) const {
  constexpr std::array kNamed = {"link", "frame", "joint", "model"};
  if (name == (scope_.name() == "world" ? "world" : "__model__")) return {};
  if (--steps < 0) throw asker.error("frames that are relative to each other");
  const std::size_t parts = name.find("::");
  for (const char* kind : kNamed) {
    for (const XmlElement& element : scope_.children(kind)) {
      if (element.attribute("name") != name.substr(0, parts)) continue;
      const SdfPose pose = pose_of(element, steps);
      if (parts == std::string::npos) return pose;
      if (element.name() == "model")
        return pose * SdfFrames(element).frame(name.substr(parts + 2), asker, steps);
    }
  }
  throw asker.error("a pose relative to " + in_quotes(name) +
                    " cannot be read: there is no such frame");
}

}  // namespace voronaut
