#include "voronaut/benchmarks/suite/claim.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "voronaut/environments/config/config_reader.h"
#include "voronaut/reports/summary/path_ratio.h"
#include "voronaut/reports/summary/statistics.h"

namespace voronaut {

namespace {

bool is_about(const Claim& claim, const RunRecord& record) {
  const auto fits = [](const std::string& wanted, const std::string& given) {
    return wanted.empty() || wanted == given;
  };
  return fits(claim.group, record.scenario_group) && fits(claim.vehicle, record.vehicle) &&
         fits(claim.planner, record.planner);
}

std::string subject(const Claim& claim) {
  std::string text;
  for (const std::string& part : {claim.planner, claim.vehicle, claim.group})
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  return text.empty() ? "every trial" : text;
}

std::string rounded(double value) { return number_text(std::round(value * 1000) / 1000); }

// Collects the bounds that a claim states.
class Examination {
 public:
  explicit Examination(const Claim& claim) : finding_{subject(claim) + ":", true} {}

  void add(const std::string& bound, const std::string& measured, bool holds) {
    finding_.text += (finding_.text.ends_with(':') ? " " : "; ") + bound + " (" + measured + ")";
    finding_.holds = finding_.holds && holds;
  }
  void fail(const std::string& reason) {
    finding_.text += " " + reason;
    finding_.holds = false;
  }
  Finding finding() const { return finding_; }

 private:
  Finding finding_;
};

std::string count_text(std::int64_t count, std::size_t n) {
  return std::to_string(count) + " of " + std::to_string(n);
}

void add_ratio(Examination& examination, const std::string& bound, double value, bool holds,
               std::size_t arrivals) {
  const bool judged = arrivals >= kFewestArrivals;
  examination.add(
      bound,
      rounded(value) + " over " + std::to_string(arrivals) + (judged ? "" : ": too few to judge"),
      !judged || holds);
}

// Path ratios of the arrivals.
struct Ratios {
  std::vector<double> of_body;
  std::vector<double> at_clearance;

  void add(const RunRecord& record) {
    if (!std::isnan(record.path_ratio)) of_body.push_back(record.path_ratio);
    const double at = path_ratio_at_clearance(record);
    if (!std::isnan(at)) at_clearance.push_back(at);
  }
};

// `statistic` of some ratios against its bound; nothing where none is stated.
void examine_ratio(const std::string& what, double max, const std::vector<double>& ratios,
                   double (*statistic)(const std::vector<double>&), Examination& examination) {
  const Claim nothing;
  if (max >= nothing.path_ratio_mean_max) return;
  if (ratios.empty()) return examination.fail("no trial reached the goal");
  const double value = statistic(ratios);
  add_ratio(examination, what + " <= " + number_text(max), value, value <= max, ratios.size());
}

void examine_ratios(const Claim& claim, Ratios ratios, Examination& examination) {
  std::sort(ratios.of_body.begin(), ratios.of_body.end());
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  const auto tail = [](const std::vector<double>& values) {
    return quantile_of_sorted(values, 0.95);
  };
  examine_ratio("mean path ratio", claim.path_ratio_mean_max, ratios.of_body, mean, examination);
  examine_ratio("95 % of path ratios", claim.path_ratio_p95_max, ratios.of_body, tail, examination);
  examine_ratio("mean path ratio at clearance_min_m", claim.path_ratio_at_clearance_mean_max,
                ratios.at_clearance, mean, examination);
}

// By world, vehicle and repetition: the mean speed of the arrivals of one planner.
using Speeds = std::map<std::tuple<std::string, std::string, int>, double>;

Speeds speeds_of(const Claim& claim, const std::vector<RunRecord>& records) {
  Speeds speeds;
  for (const RunRecord& record : records) {
    if (!is_about(claim, record) || record.outcome != Outcome::goal_reached) continue;
    speeds[{record.scenario, record.vehicle, record.repetition}] = record.speed_mean_m_s;
  }
  return speeds;
}

void examine_speed(const Claim& claim, const std::vector<RunRecord>& records,
                   Examination& examination) {
  if (claim.speed_beside.empty()) return;
  Claim other = claim;
  other.planner = claim.speed_beside;
  const Speeds others = speeds_of(other, records);
  double sum = 0, sum_beside = 0;
  std::size_t pairs = 0;
  const Speeds mine = speeds_of(claim, records);
  for (const auto& [world, speed_m_s] : mine) {
    const auto beside = others.find(world);
    if (beside == others.end()) continue;
    sum += speed_m_s;
    sum_beside += beside->second;
    ++pairs;
  }
  if (pairs == 0 && mine.size() >= kFewestArrivals)
    return examination.fail("no world that both finished");
  const double ratio = pairs > 0 ? sum / sum_beside : 0;
  add_ratio(examination,
            "mean speed >= " + number_text(claim.speed_ratio_min) + " x " + claim.speed_beside,
            ratio, ratio >= claim.speed_ratio_min, pairs);
}

}  // namespace

Finding examine(const Claim& claim, const std::vector<RunRecord>& records) {
  const Claim nothing;
  std::size_t n = 0;
  std::int64_t as_claimed = 0, collisions = 0;
  double clearance_m = kAbsent;
  Ratios ratios;
  for (const RunRecord& record : records) {
    if (!is_about(claim, record)) continue;
    ++n;
    as_claimed += record.outcome == claim.outcome ? 1 : 0;
    collisions += record.outcome == Outcome::collision ? 1 : 0;
    clearance_m = std::fmin(clearance_m, record.clearance_min_m);
    ratios.add(record);
  }
  Examination examination(claim);
  if (n == 0) {
    examination.fail("no such trial");
    return examination.finding();
  }
  const auto share = [n](std::int64_t count) {
    return static_cast<double>(count) / static_cast<double>(n);
  };
  if (claim.outcome_share_min > nothing.outcome_share_min)
    examination.add(std::string(to_string(claim.outcome)) +
                        " >= " + number_text(100 * claim.outcome_share_min) + " %",
                    count_text(as_claimed, n), share(as_claimed) >= claim.outcome_share_min);
  if (claim.collision_share_max < nothing.collision_share_max)
    examination.add("collisions <= " + number_text(100 * claim.collision_share_max) + " %",
                    count_text(collisions, n), share(collisions) <= claim.collision_share_max);
  if (claim.clearance_min_m > nothing.clearance_min_m)
    examination.add("clearance >= " + number_text(claim.clearance_min_m) + " m",
                    rounded(clearance_m) + " m", clearance_m >= claim.clearance_min_m);
  examine_ratios(claim, std::move(ratios), examination);
  examine_speed(claim, records, examination);
  return examination.finding();
}

}  // namespace voronaut
