#include "voronaut/benchmarks/suite/acceptance_criterion.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/reports/summary/statistic_text.h"

namespace voronaut {

namespace {

constexpr double kLargest = 1e9;

bool is_about(const AcceptanceCriterion& criterion, const RunRecord& record) {
  const auto fits = [](const std::string& wanted, const std::string& given) {
    return wanted.empty() || wanted == given;
  };
  return fits(criterion.group, record.scenario_group) && fits(criterion.vehicle, record.vehicle) &&
         fits(criterion.planner, record.planner);
}

std::string subject(const AcceptanceCriterion& criterion) {
  std::string text;
  for (const std::string& part : {criterion.planner, criterion.vehicle, criterion.group})
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  return text.empty() ? "every trial" : text;
}

// Collects the bounds that a criterion sets.
class Examination {
 public:
  explicit Examination(const AcceptanceCriterion& criterion)
      : finding_{subject(criterion) + ":", true} {}

  void add(const std::string& bound, const std::string& measured, bool holds) {
    finding_.text += (finding_.text.ends_with(':') ? " " : "; ") + bound + " (" + measured + ")";
    finding_.holds = finding_.holds && holds;
  }
  void add_over_arrivals(const std::string& bound, const std::string& measured, bool holds,
                         std::int64_t arrivals) {
    const bool judged = arrivals >= kFewestArrivals;
    add(bound,
        measured + " over " + std::to_string(arrivals) + (judged ? "" : ": too few to judge"),
        !judged || holds);
  }
  void fail(const std::string& reason) {
    finding_.text += " " + reason;
    finding_.holds = false;
  }
  Finding finding() const { return finding_; }

 private:
  Finding finding_;
};

void examine_bound(const AcceptanceBound& bound, double limit, const Trials& trials,
                   Examination& examination) {
  const Statistic& statistic = *bound.statistic;
  const Estimate found = estimate_of(statistic, trials, {.resamples = 0});
  const bool is_rate = statistic.estimator == Estimator::rate;
  std::string unit(is_rate ? "%" : unit_of(statistic));
  if (!unit.empty()) unit = " " + unit;
  std::string text(statistic.label);
  if (!is_rate) text.append(" ").append(estimator_words(statistic));
  text += (bound.is_min ? " >= " : " <= ") +
          number_text(is_rate ? std::round(1e8 * limit) / 1e6 : limit) + unit;
  const bool holds = bound.is_min ? found.value >= limit : found.value <= limit;
  if (found.n == 0)
    examination.add(text, "over none of the " + std::string(words(statistic.trials)), false);
  else if (is_rate)
    examination.add(text, std::to_string(found.successes) + " of " + std::to_string(found.n),
                    holds);
  else if (statistic.trials == TrialSet::goal_reached)
    examination.add_over_arrivals(text, fixed(found.value, statistic.digits) + unit, holds,
                                  found.n);
  else
    examination.add(text, fixed(found.value, statistic.digits) + unit, holds);
}

// By world, vehicle and repetition: the mean speed of the arrivals of one planner.
using Speeds = std::map<std::tuple<std::string, std::string, std::int64_t>, double>;

Speeds speeds_of(const AcceptanceCriterion& criterion, const std::vector<RunRecord>& records) {
  Speeds speeds;
  for (const RunRecord& record : records) {
    if (!is_about(criterion, record) || record.outcome != Outcome::goal_reached) continue;
    speeds[{record.scenario, record.vehicle, record.repetition}] = record.speed_mean_m_s;
  }
  return speeds;
}

// Of sums over pairs, with the lower end of its 95 % interval: the ratio estimator and its variance
// (W. G. Cochran, Sampling Techniques, 3rd ed. 1977, eq. 6.9).
struct PairedRatio {
  std::int64_t pairs = 0;
  double value = 0, lower = 0;
};

PairedRatio ratio_of(const Speeds& mine, const Speeds& others) {
  std::vector<std::pair<double, double>> pairs;
  double sum = 0, sum_beside = 0;
  for (const auto& [world, speed_m_s] : mine) {
    const auto beside = others.find(world);
    if (beside == others.end()) continue;
    pairs.emplace_back(speed_m_s, beside->second);
    sum += speed_m_s;
    sum_beside += beside->second;
  }
  if (pairs.empty()) return {};
  const double ratio = sum / sum_beside;
  double residual_sq = 0;
  for (const auto& [speed_m_s, beside_m_s] : pairs)
    residual_sq += (speed_m_s - ratio * beside_m_s) * (speed_m_s - ratio * beside_m_s);
  constexpr double kNormal95 = 1.96;
  return {static_cast<std::int64_t>(pairs.size()), ratio,
          ratio - kNormal95 * std::sqrt(residual_sq) / sum_beside};
}

void examine_speed(const AcceptanceCriterion& criterion, const std::vector<RunRecord>& records,
                   Examination& examination) {
  if (criterion.speed_beside.empty()) return;
  AcceptanceCriterion other = criterion;
  other.planner = criterion.speed_beside;
  const Speeds mine = speeds_of(criterion, records);
  const PairedRatio ratio = ratio_of(mine, speeds_of(other, records));
  if (ratio.pairs == 0 && static_cast<std::int64_t>(mine.size()) >= kFewestArrivals)
    return examination.fail("no world that both finished");
  const std::string beside = " x " + criterion.speed_beside;
  examination.add_over_arrivals("mean speed >= " + number_text(criterion.speed_ratio_min) + beside,
                                fixed(ratio.value, 3), ratio.value >= criterion.speed_ratio_min,
                                ratio.pairs);
  if (criterion.speed_ratio_lower_min > 0)
    examination.add_over_arrivals(
        "its lower bound >= " + number_text(criterion.speed_ratio_lower_min) + beside,
        fixed(ratio.lower, 3), ratio.lower >= criterion.speed_ratio_lower_min, ratio.pairs);
}

}  // namespace

const std::vector<AcceptanceBound>& acceptance_bounds() {
  static const std::vector<AcceptanceBound> kBounds = [] {
    std::vector<AcceptanceBound> bounds;
    for (const Statistic& one : statistics()) {
      const std::string name(one.name);
      const double largest = one.estimator == Estimator::rate ? 1 : kLargest;
      if (one.better != Better::less) bounds.push_back({name + "_min", &one, true, largest});
      if (one.better != Better::more) bounds.push_back({name + "_max", &one, false, largest});
    }
    return bounds;
  }();
  return kBounds;
}

AcceptanceCriterion::AcceptanceCriterion() {
  for (const AcceptanceBound& bound : acceptance_bounds()) bounds.push_back(bound.idle());
}

double& AcceptanceCriterion::bound(std::string_view key) {
  for (std::size_t i = 0; i < bounds.size(); ++i)
    if (acceptance_bounds()[i].key == key) return bounds[i];
  throw std::invalid_argument("no bound '" + std::string(key) + "'");
}

Finding examine(const AcceptanceCriterion& criterion, const std::vector<RunRecord>& records) {
  Trials trials;
  for (const RunRecord& record : records)
    if (is_about(criterion, record)) trials.push_back(&record);
  Examination examination(criterion);
  if (trials.empty()) {
    examination.fail("no such trial");
    return examination.finding();
  }
  for (std::size_t i = 0; i < criterion.bounds.size(); ++i) {
    const AcceptanceBound& bound = acceptance_bounds()[i];
    if (criterion.bounds[i] != bound.idle())
      examine_bound(bound, criterion.bounds[i], trials, examination);
  }
  examine_speed(criterion, records, examination);
  return examination.finding();
}

Finding examine_all(const std::vector<AcceptanceCriterion>& criteria,
                    const std::vector<std::string>& flying, const std::vector<RunRecord>& records) {
  const auto left_out = [&](const std::string& label) {
    return !label.empty() && std::find(flying.begin(), flying.end(), label) == flying.end() &&
           std::none_of(records.begin(), records.end(),
                        [&](const RunRecord& record) { return record.planner == label; });
  };
  Finding all{"", true};
  for (const AcceptanceCriterion& criterion : criteria) {
    if (left_out(criterion.planner) || left_out(criterion.speed_beside)) {
      all.text += "  not judged: " +
                  (left_out(criterion.planner) ? criterion.planner : criterion.speed_beside) +
                  " was left out\n";
      continue;
    }
    const Finding one = examine(criterion, records);
    all.holds = all.holds && one.holds;
    all.text += (one.holds ? "  holds: " : "  broken: ") + one.text + "\n";
  }
  return all;
}

}  // namespace voronaut
