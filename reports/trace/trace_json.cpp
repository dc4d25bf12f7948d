#include "voronaut/reports/trace/trace_json.h"

#include <cmath>
#include <stdexcept>

#include "voronaut/reports/encoding/deflate.h"
#include "voronaut/reports/encoding/json_text.h"
#include "voronaut/reports/trace/delta_json.h"
#include "voronaut/reports/trace/trace_lists_json.h"

namespace voronaut {

namespace {

using nlohmann::json;

constexpr int kVersion = 4;
constexpr double kPerMetre = kTracePerMetre;
constexpr double kRangePerMetre = 100.0;
constexpr std::int64_t kNoReturn = -1;

// One list for both directions: v(key, member of the frame, units per SI unit).
template <class Visitor>
void visit_columns(Visitor&& v) {
  v(
      "t_ms", [](auto& f) -> auto& { return f.t_s; }, 1000.0);
  v(
      "x_mm", [](auto& f) -> auto& { return f.x_m; }, kPerMetre);
  v(
      "y_mm", [](auto& f) -> auto& { return f.y_m; }, kPerMetre);
  v(
      "z_mm", [](auto& f) -> auto& { return f.z_m; }, kPerMetre);
  v(
      "vx_mm_s", [](auto& f) -> auto& { return f.vx_m_s; }, kPerMetre);
  v(
      "vy_mm_s", [](auto& f) -> auto& { return f.vy_m_s; }, kPerMetre);
  v(
      "heading_x_1e4", [](auto& f) -> auto& { return f.heading_x; }, 1e4);
  v(
      "heading_y_1e4", [](auto& f) -> auto& { return f.heading_y; }, 1e4);
  v(
      "tilt_1e4", [](auto& f) -> auto& { return f.tilt_rad; }, 1e4);
  v(
      "clearance_mm", [](auto& f) -> auto& { return f.clearance_m; }, kPerMetre);
  v(
      "actuator0_1e2", [](auto& f) -> auto& { return f.actuators[0]; }, 100.0);
  v(
      "actuator1_1e2", [](auto& f) -> auto& { return f.actuators[1]; }, 100.0);
  v(
      "actuator2_1e2", [](auto& f) -> auto& { return f.actuators[2]; }, 100.0);
  v(
      "actuator3_1e2", [](auto& f) -> auto& { return f.actuators[3]; }, 100.0);
  v(
      "planning_time_100ns", [](auto& f) -> auto& { return f.planning_time_us; }, 10.0);
  v(
      "target_x_mm", [](auto& f) -> auto& { return f.target_x_m; }, kPerMetre);
  v(
      "target_y_mm", [](auto& f) -> auto& { return f.target_y_m; }, kPerMetre);
  v(
      "mode", [](auto& f) -> auto& { return f.mode; }, 1.0);
  v(
      "plan", [](auto& f) -> auto& { return f.plan; }, 1.0);
  v(
      "search", [](auto& f) -> auto& { return f.search; }, 1.0);
  v(
      "replan", [](auto& f) -> auto& { return f.replan; }, 1.0);
  v(
      "solve_end", [](auto& f) -> auto& { return f.solve_end; }, 1.0);
  v(
      "share_1e3", [](auto& f) -> auto& { return f.speed_scale; }, 1e3);
  v(
      "known", [](auto& f) -> auto& { return f.known_points; }, 1.0);
}

json ranges_to_json(const std::vector<float>& range_m, double max_range_m) {
  json scan = json::array();
  std::int64_t previous = 0;
  for (const float range : range_m) {
    const bool hit = range > 0.0F && static_cast<double>(range) < max_range_m;
    const std::int64_t code =
        hit ? std::llround(static_cast<double>(range) * kRangePerMetre) : kNoReturn;
    scan.push_back(code - previous);
    previous = code;
  }
  return scan;
}

std::vector<float> ranges_from_json(const json& scan, double max_range_m) {
  std::vector<float> range_m;
  range_m.reserve(scan.size());
  std::int64_t code = 0;
  for (const json& delta : scan) {
    code += delta.get<std::int64_t>();
    range_m.push_back(static_cast<float>(
        code == kNoReturn ? max_range_m : static_cast<double>(code) / kRangePerMetre));
  }
  return range_m;
}

json frames_to_json(const Trace& trace) {
  json columns = json::object();
  visit_columns([&](const char* key, auto member, double scale) {
    DeltaWriter column;
    for (const TraceFrame& frame : trace.frames) {
      column.push(static_cast<double>(member(frame)), scale);
    }
    columns[key] = column.take();
  });
  json scans = json::array();
  for (const TraceFrame& frame : trace.frames) {
    scans.push_back(ranges_to_json(frame.range_m, trace.max_range_m));
  }
  columns["range_cm"] = std::move(scans);
  json tubes = json::array();
  for (const TraceFrame& frame : trace.frames) {
    tubes.push_back(points_to_json(frame.tube, kPerMetre, {frame.x_m, frame.y_m}));
  }
  columns["tube_mm"] = std::move(tubes);
  return columns;
}

std::vector<TraceFrame> frames_from_json(const json& columns, double max_range_m) {
  const json& scans = columns.at("range_cm");
  std::vector<TraceFrame> frames(scans.size());
  visit_columns([&](const char* key, auto member, double scale) {
    const json& column = columns.at(key);
    if (column.size() != frames.size()) {
      throw std::invalid_argument(std::string("column ") + key + " has another length");
    }
    DeltaReader reader;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      auto& target = member(frames[i]);
      using Target = std::remove_reference_t<decltype(target)>;
      const double value = reader.next(column[i], scale);
      if (std::is_integral_v<Target> && !(value >= (std::is_signed_v<Target> ? -1.0 : 0.0))) {
        throw std::invalid_argument(std::string("column ") + key + " is not an index");
      }
      target = static_cast<Target>(value);
    }
  });
  const json& tubes = columns.at("tube_mm");
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].range_m = ranges_from_json(scans[i], max_range_m);
    frames[i].tube = points_from_json(tubes.at(i), kPerMetre, {frames[i].x_m, frames[i].y_m});
  }
  return frames;
}

}  // namespace

std::string trace_to_json(const Trace& trace) {
  json out;
  out["version"] = kVersion;
  out["trial_id"] = trace.trial_id;
  out["body_radius_m"] = trace.body_radius_m;
  if (!trace.footprint.empty()) out["footprint"] = points_to_json(trace.footprint, kPerMetre);
  out["clearance_min_m"] = trace.clearance_min_m;
  out["field_of_view_rad"] = trace.field_of_view_rad;
  out["max_range_m"] = trace.max_range_m;
  out["modes"] = trace.modes;
  out["replan_reasons"] = trace.replan_reasons;
  out["solve_ends"] = trace.solve_ends;
  out["plans"] = polylines_to_json(trace.plans);
  out["known_points"] = points_to_json(trace.known_points, kPerMetre);
  out["cluster_of"] = trace.cluster_of;
  out["merges"] = merges_to_json(trace.merges);
  out["hulls"] = polylines_to_json(trace.hulls);
  out["edges"] = edges_to_json(trace.edges);
  out["searches"] = trace.searches;
  out["kept_searches"] = trace.kept_searches;
  out["static"] = trace.static_planning;
  out["improvements"] = improvements_to_json(trace.improvements);
  out["frames"] = frames_to_json(trace);
  return json_text(out);
}

Trace trace_from_json(std::string_view text) {
  return parse_as("trace", [&] {
    const json in = json::parse(text);
    if (in.at("version").get<int>() != kVersion) {
      throw std::invalid_argument("trace: version " + in.at("version").dump() + ", not " +
                                  std::to_string(kVersion));
    }
    Trace trace;
    in.at("trial_id").get_to(trace.trial_id);
    in.at("body_radius_m").get_to(trace.body_radius_m);
    if (in.contains("footprint")) trace.footprint = points_from_json(in.at("footprint"), kPerMetre);
    in.at("clearance_min_m").get_to(trace.clearance_min_m);
    in.at("field_of_view_rad").get_to(trace.field_of_view_rad);
    in.at("max_range_m").get_to(trace.max_range_m);
    in.at("modes").get_to(trace.modes);
    in.at("replan_reasons").get_to(trace.replan_reasons);
    in.at("solve_ends").get_to(trace.solve_ends);
    in.at("cluster_of").get_to(trace.cluster_of);
    trace.merges = merges_from_json(in.at("merges"));
    trace.plans = polylines_from_json(in.at("plans"));
    trace.known_points = points_from_json(in.at("known_points"), kPerMetre);
    trace.hulls = polylines_from_json(in.at("hulls"));
    trace.edges = edges_from_json(in.at("edges"));
    in.at("searches").get_to(trace.searches);
    in.at("kept_searches").get_to(trace.kept_searches);
    in.at("static").get_to(trace.static_planning);
    trace.improvements = improvements_from_json(in.at("improvements"));
    trace.frames = frames_from_json(in.at("frames"), trace.max_range_m);
    return trace;
  });
}

std::string compress_trace(const Trace& trace) { return deflate_raw(trace_to_json(trace)); }

Trace decompress_trace(std::string_view blob) { return trace_from_json(inflate_raw(blob)); }

}  // namespace voronaut
