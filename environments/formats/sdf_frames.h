#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "voronaut/environments/formats/xml_document.h"

// Poses and named frames of SDF (http://sdformat.org/tutorials?tut=pose_frame_semantics).
namespace voronaut {

// T_a_b: where frame b stands in frame a. Metres.
struct SdfPose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();

  SdfPose operator*(const SdfPose& inner) const {
    return {rotation * inner.rotation, p + rotation * inner.p};
  }
  SdfPose inverse() const { return {rotation.transpose(), -(rotation.transpose() * p)}; }
};

// So many numbers, which the text of the element is; `what` names them in the error.
std::vector<double> read_numbers(const XmlElement& element, std::string_view what,
                                 std::size_t count);

// The numbers of the element's <pose>: x y z roll pitch yaw, or x y z and a quaternion; identity
// where it has none. The frame that the pose is relative to is not looked at.
SdfPose read_pose(const XmlElement& element);

// What a pose is relative to, by its attribute; empty: the default of its element.
std::string pose_frame(const XmlElement& element);

// The frames that a <model> or a <world> names: itself ("__model__", "world"), its links, joints,
// frames and models, and what those name ("arm::hand").
class SdfFrames {
 public:
  explicit SdfFrames(const XmlElement& scope) : scope_(scope) {}

  // Where a link, joint, frame or model of the scope stands in it; of a model, its
  // `placement_frame` is put where its pose says. Throws ConfigError where a frame is not there or
  // frames are relative to each other.
  SdfPose pose_of(const XmlElement& element) const;
  // Of a frame by its name, which `asker` has.
  SdfPose frame(const std::string& name, const XmlElement& asker) const;

 private:
  // `steps` are those from frame to frame that are left: what goes round in circles uses them up.
  SdfPose pose_of(const XmlElement& element, int& steps) const;
  SdfPose frame(const std::string& name, const XmlElement& asker, int& steps) const;

  XmlElement scope_;
};

}  // namespace voronaut
