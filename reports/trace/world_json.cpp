#include <array>
#include <cmath>
#include <stdexcept>

#include "voronaut/reports/encoding/json_text.h"
#include "voronaut/reports/trace/trace_json.h"

namespace voronaut {

namespace {

using nlohmann::json;

double round_to_tenth_mm(double metres) { return std::round(metres * 1e4) / 1e4; }

json flat_point(const TracePoint& p) {
  return json::array({round_to_tenth_mm(p.x_m), round_to_tenth_mm(p.y_m)});
}

TracePoint point_at(const json& flat, std::size_t index) {
  return {flat.at(index).get<double>(), flat.at(index + 1).get<double>()};
}

}  // namespace

std::string world_to_json(const TraceWorld& world) {
  json out;
  out["world_id"] = world.world_id;
  out["bounds"] = {round_to_tenth_mm(world.bounds_min.x_m), round_to_tenth_mm(world.bounds_min.y_m),
                   round_to_tenth_mm(world.bounds_max.x_m),
                   round_to_tenth_mm(world.bounds_max.y_m)};
  out["circles"] = json::array();
  for (const auto& [x_m, y_m, radius_m] : world.circles) {
    out["circles"].push_back(
        json::array({round_to_tenth_mm(x_m), round_to_tenth_mm(y_m), round_to_tenth_mm(radius_m)}));
  }
  out["polygons"] = json::array();
  for (const auto& polygon : world.polygons) {
    json flat = json::array();
    for (const TracePoint& p : polygon) {
      flat.push_back(round_to_tenth_mm(p.x_m));
      flat.push_back(round_to_tenth_mm(p.y_m));
    }
    out["polygons"].push_back(std::move(flat));
  }
  out["segments"] = json::array();
  for (const auto& [a, b] : world.segments) {
    out["segments"].push_back(json::array({round_to_tenth_mm(a.x_m), round_to_tenth_mm(a.y_m),
                                           round_to_tenth_mm(b.x_m), round_to_tenth_mm(b.y_m)}));
  }
  out["start"] = flat_point(world.start);
  out["goal"] = flat_point(world.goal);
  return json_text(out);
}

TraceWorld world_from_json(std::string_view text) {
  return parse_as("world", [&] {
    const json in = json::parse(text);
    TraceWorld world;
    in.at("world_id").get_to(world.world_id);
    world.bounds_min = point_at(in.at("bounds"), 0);
    world.bounds_max = point_at(in.at("bounds"), 2);
    for (const json& circle : in.at("circles")) {
      world.circles.push_back(circle.get<std::array<double, 3>>());
    }
    for (const json& flat : in.at("polygons")) {
      auto& polygon = world.polygons.emplace_back();
      for (std::size_t i = 0; i + 1 < flat.size(); i += 2) {
        polygon.push_back(point_at(flat, i));
      }
    }
    for (const json& flat : in.at("segments")) {
      world.segments.push_back({point_at(flat, 0), point_at(flat, 2)});
    }
    world.start = point_at(in.at("start"), 0);
    world.goal = point_at(in.at("goal"), 0);
    return world;
  });
}

}  // namespace voronaut
