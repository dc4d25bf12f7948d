#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "voronaut/reports/trace/trace.h"

// For sources only: the lists of a trace beside its frames (layout and resolutions: trace_json.h).
// Reading throws nlohmann's exceptions or std::invalid_argument for what writing does not write.
namespace voronaut {

inline constexpr double kTracePerMetre = 1000.0;

using Polyline = std::vector<TracePoint>;

nlohmann::json polylines_to_json(const std::vector<Polyline>& polylines);
std::vector<Polyline> polylines_from_json(const nlohmann::json& list);

nlohmann::json edges_to_json(const std::vector<TraceEdge>& edges);
std::vector<TraceEdge> edges_from_json(const nlohmann::json& in);

nlohmann::json merges_to_json(const std::vector<TraceMerge>& merges);
std::vector<TraceMerge> merges_from_json(const nlohmann::json& flat);

nlohmann::json improvements_to_json(const std::vector<TraceImprovement>& improvements);
std::vector<TraceImprovement> improvements_from_json(const nlohmann::json& columns);

}  // namespace voronaut
