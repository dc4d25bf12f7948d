#include "voronaut/reports/trace/trace_lists_json.h"

#include <array>
#include <stdexcept>

#include "voronaut/reports/trace/delta_json.h"

namespace voronaut {

using nlohmann::json;

namespace {

constexpr double kEdgePerMetre = 100.0;
// Checks, microseconds and micrometres.
constexpr std::array<double, 3> kImprovementScale{1, 1e6, 1e6};

}  // namespace

json polylines_to_json(const std::vector<Polyline>& polylines) {
  json list = json::array();
  for (const Polyline& polyline : polylines)
    list.push_back(points_to_json(polyline, kTracePerMetre));
  return list;
}

std::vector<Polyline> polylines_from_json(const json& list) {
  std::vector<Polyline> polylines;
  for (const json& polyline : list) polylines.push_back(points_from_json(polyline, kTracePerMetre));
  return polylines;
}

// The edges' ends as one polyline, so that neighbours cost little.
json edges_to_json(const std::vector<TraceEdge>& edges) {
  Polyline ends;
  DeltaWriter first;
  json searches_on = json::array();
  for (const TraceEdge& edge : edges) {
    ends.push_back(edge.a);
    ends.push_back(edge.b);
    first.push(edge.first_search, 1);
    searches_on.push_back(edge.last_search - edge.first_search);
  }
  return {{"ends_cm", points_to_json(ends, kEdgePerMetre)},
          {"first", first.take()},
          {"on", std::move(searches_on)}};
}

std::vector<TraceEdge> edges_from_json(const json& in) {
  const Polyline ends = points_from_json(in.at("ends_cm"), kEdgePerMetre);
  const json& first = in.at("first");
  const json& searches_on = in.at("on");
  if (ends.size() != 2 * first.size() || searches_on.size() != first.size()) {
    throw std::invalid_argument("edges without two ends, a first and a last search");
  }
  std::vector<TraceEdge> edges;
  DeltaReader reader;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const int from = static_cast<int>(reader.next(first[i], 1));
    edges.push_back({ends[2 * i], ends[2 * i + 1], from, from + searches_on[i].get<int>()});
  }
  return edges;
}

// [frame, from, into, ...]
json merges_to_json(const std::vector<TraceMerge>& merges) {
  json flat = json::array();
  for (const TraceMerge& merge : merges) {
    for (const std::uint32_t value : {merge.frame, merge.from, merge.into}) flat.push_back(value);
  }
  return flat;
}

std::vector<TraceMerge> merges_from_json(const json& flat) {
  if (flat.size() % 3 != 0) throw std::invalid_argument("half a merge");
  std::vector<TraceMerge> merges;
  for (std::size_t i = 0; i < flat.size(); i += 3) {
    merges.push_back({flat[i].get<std::uint32_t>(), flat[i + 1].get<std::uint32_t>(),
                      flat[i + 2].get<std::uint32_t>()});
  }
  return merges;
}

json improvements_to_json(const std::vector<TraceImprovement>& improvements) {
  std::array<DeltaWriter, 3> columns;
  for (const TraceImprovement& i : improvements) {
    columns[0].push(static_cast<double>(i.state_checks), kImprovementScale[0]);
    columns[1].push(i.time_s, kImprovementScale[1]);
    columns[2].push(i.cost_m, kImprovementScale[2]);
  }
  return {columns[0].take(), columns[1].take(), columns[2].take()};
}

std::vector<TraceImprovement> improvements_from_json(const json& columns) {
  if (columns.size() != 3 || columns[0].size() != columns[1].size() ||
      columns[0].size() != columns[2].size()) {
    throw std::invalid_argument("improvements are not three columns of one length");
  }
  std::array<DeltaReader, 3> readers;
  std::vector<TraceImprovement> improvements;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    const auto next = [&](std::size_t k) {
      return readers[k].next(columns[k][i], kImprovementScale[k]);
    };
    const auto checks = static_cast<std::int64_t>(next(0));
    const double time_s = next(1);
    improvements.push_back({checks, time_s, next(2)});
  }
  return improvements;
}

}  // namespace voronaut
