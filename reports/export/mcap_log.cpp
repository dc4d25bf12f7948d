#include "voronaut/reports/export/mcap_log.h"

#include <algorithm>
#include <cmath>

#include "voronaut/reports/encoding/json_text.h"
#include "voronaut/reports/export/mcap_writer.h"

namespace voronaut {
namespace {

using Json = nlohmann::json;

constexpr double kDrawnHeight_m = 1;

std::uint64_t nanoseconds(double t_s) {
  return static_cast<std::uint64_t>(std::llround(t_s * 1e9));
}

Json timestamp(double t_s) {
  const std::uint64_t ns = nanoseconds(t_s);
  return {{"sec", ns / 1'000'000'000}, {"nsec", ns % 1'000'000'000}};
}

Json vector(double x, double y, double z) { return {{"x", x}, {"y", y}, {"z", z}}; }

// Turned about the vertical so that x points along the heading, a unit vector.
Json pose(const TracePoint& p, double z_m, double heading_x, double heading_y) {
  const double z = std::copysign(std::sqrt(std::max(0.0, (1 - heading_x) / 2)), heading_y);
  const double w = std::sqrt(std::max(0.0, (1 + heading_x) / 2));
  return {{"position", vector(p.x_m, p.y_m, z_m)},
          {"orientation", {{"x", 0}, {"y", 0}, {"z", z}, {"w", w}}}};
}

Json pose_message(const TraceFrame& frame) {
  return {{"timestamp", timestamp(frame.t_s)},
          {"frame_id", "world"},
          {"pose", pose({frame.x_m, frame.y_m}, frame.z_m, frame.heading_x, frame.heading_y)}};
}

Json scan_message(const TraceFrame& frame, const Trace& trace) {
  Json ranges = Json::array();
  for (const float range_m : frame.range_m)
    ranges.push_back(range_m > 0 && range_m < trace.max_range_m ? range_m : 0.0F);
  Json message = pose_message(frame);
  message["start_angle"] = -trace.field_of_view_rad / 2;
  message["end_angle"] = trace.field_of_view_rad / 2;
  message["ranges"] = std::move(ranges);
  message["intensities"] = Json::array();
  return message;
}

const Json kGrey = {{"r", 0.5}, {"g", 0.5}, {"b", 0.5}, {"a", 1}};

Json line(const std::vector<TracePoint>& points, bool closed) {
  Json vertices = Json::array();
  for (const TracePoint& p : points) vertices.push_back(vector(p.x_m, p.y_m, 0));
  return {{"type", closed ? 1 : 0},  {"pose", pose({0, 0}, 0, 1, 0)},
          {"thickness", 0.03},       {"scale_invariant", false},
          {"points", vertices},      {"color", kGrey},
          {"colors", Json::array()}, {"indices", Json::array()}};
}

Json world_message(const TraceWorld& world) {
  Json cylinders = Json::array();
  for (const auto& [x_m, y_m, radius_m] : world.circles)
    cylinders.push_back({{"pose", pose({x_m, y_m}, kDrawnHeight_m / 2, 1, 0)},
                         {"size", vector(2 * radius_m, 2 * radius_m, kDrawnHeight_m)},
                         {"bottom_scale", 1},
                         {"top_scale", 1},
                         {"color", kGrey}});
  Json lines = Json::array();
  for (const auto& polygon : world.polygons) lines.push_back(line(polygon, true));
  for (const auto& [a, b] : world.segments) lines.push_back(line({a, b}, false));
  Json entity = {{"timestamp", timestamp(0)}, {"frame_id", "world"},   {"id", "world"},
                 {"lifetime", timestamp(0)},  {"frame_locked", false}, {"metadata", Json::array()},
                 {"cylinders", cylinders},    {"lines", lines}};
  for (const char* unused : {"arrows", "cubes", "spheres", "triangles", "texts", "models"})
    entity[unused] = Json::array();
  return {{"deletions", Json::array()}, {"entities", Json::array({entity})}};
}

// An object with these properties; what lies inside them is Foxglove's to know by the schema's
// name.
std::string schema(const Json& properties) {
  return json_text({{"type", "object"}, {"properties", properties}});
}

struct Schemas {
  explicit Schemas(McapWriter& writer) {
    const Json object = {{"type", "object"}};
    const Json text = {{"type", "string"}};
    const Json number = {{"type", "number"}};
    const Json list = {{"type", "array"}};
    Json posed = {{"timestamp", object}, {"frame_id", text}, {"pose", object}};
    pose = writer.add_schema("foxglove.PoseInFrame", schema(posed));
    posed.update(
        {{"start_angle", number}, {"end_angle", number}, {"ranges", list}, {"intensities", list}});
    scan = writer.add_schema("foxglove.LaserScan", schema(posed));
    world = writer.add_schema("foxglove.SceneUpdate",
                              schema({{"deletions", list}, {"entities", list}}));
  }

  std::uint16_t pose = 0;
  std::uint16_t scan = 0;
  std::uint16_t world = 0;
};

void add_trial(const RunRecord& record, const Trace& trace, const TraceWorld* world,
               const Schemas& schemas, McapWriter& writer) {
  const std::string prefix =
      "/" + record.scenario + "/" + record.planner + "/" + record.trial_id.substr(0, 8) + "/";
  if (world != nullptr)
    writer.add_message(writer.add_json_channel(schemas.world, prefix + "world"), 0,
                       json_text(world_message(*world)));
  const std::uint16_t pose = writer.add_json_channel(schemas.pose, prefix + "pose");
  const std::uint16_t scan = writer.add_json_channel(schemas.scan, prefix + "scan");
  for (const TraceFrame& frame : trace.frames) {
    const std::uint64_t time_ns = nanoseconds(frame.t_s);
    writer.add_message(pose, time_ns, json_text(pose_message(frame)));
    if (!frame.range_m.empty())
      writer.add_message(scan, time_ns, json_text(scan_message(frame, trace)));
  }
}

}  // namespace

std::string mcap_log(const ResultStore& store) {
  McapWriter writer("voronaut");
  const Schemas schemas(writer);
  const std::vector<TraceWorld> worlds = store.worlds();
  for (const RunRecord& record : store.records()) {
    const auto trace = store.trace(record.trial_id);
    if (!trace) continue;
    const auto world = std::find_if(worlds.begin(), worlds.end(), [&](const TraceWorld& one) {
      return one.world_id == record.world_id;
    });
    add_trial(record, *trace, world == worlds.end() ? nullptr : &*world, schemas, writer);
  }
  return std::move(writer).finish();
}

}  // namespace voronaut
