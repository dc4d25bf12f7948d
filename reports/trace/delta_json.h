#pragma once

#include <cstdint>
#include <vector>

#include <nlohmann/json.hpp>

#include "voronaut/reports/trace/trace.h"

// For sources only: columns of numbers and polylines as integers, each the difference from the one
// before, the first from 0: short, and easy to compress. Reading throws nlohmann's exceptions or
// std::invalid_argument for what writing does not write.
namespace voronaut {

// Of values in units of 1 / scale; a value that is not finite becomes null.
class DeltaWriter {
 public:
  void push(double value, double scale);
  nlohmann::json take() { return std::move(column_); }

 private:
  nlohmann::json column_ = nlohmann::json::array();
  std::int64_t previous_ = 0;
};

// Null reads back as NaN.
class DeltaReader {
 public:
  double next(const nlohmann::json& entry, double scale);

 private:
  std::int64_t sum_ = 0;
};

// [dx, dy, ...] in units of 1 / per_metre, the first from `origin`. A point that is not finite
// throws std::invalid_argument.
nlohmann::json points_to_json(const std::vector<TracePoint>& points, double per_metre,
                              const TracePoint& origin = {});
std::vector<TracePoint> points_from_json(const nlohmann::json& flat, double per_metre,
                                         const TracePoint& origin = {});

}  // namespace voronaut
