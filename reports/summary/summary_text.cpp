#include "voronaut/reports/summary/summary_text.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

using Align = TextTable::Align;

std::string fixed(double value, int decimals) {
  if (std::isnan(value)) {
    return "-";
  }
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  return buffer.data();
}

// Halves away from zero, as the report's JavaScript does: 25 of 40 is 63 % in both.
std::string percent(double value) { return fixed(std::round(100.0 * value), 0); }

std::string rate_text(const Rate& rate) {
  if (rate.n == 0) {
    return "-";
  }
  return percent(rate.value) + " % [" + percent(rate.interval.low) + ", " +
         percent(rate.interval.high) + "]";
}

std::string other_outcomes(const PlannerSummary& s) {
  std::string text;
  for (std::size_t i = 1; i < kOutcomes.size(); ++i) {
    if (s.outcomes[i] > 0) {
      text += (text.empty() ? "" : ", ") + std::to_string(s.outcomes[i]) + " " +
              std::string(to_string(kOutcomes[i]));
    }
  }
  return text;
}

std::string title(const SummaryGroup& group) {
  return printable((group.all_scenarios ? "all scenarios" : group.scenario_group) + ", " +
                   group.vehicle + (group.regulator.empty() ? "" : " with " + group.regulator));
}

TextTable outcome_table() {
  return {{{"planner", Align::left},
           {"n", Align::right},
           {"success [95 %]", Align::right},
           {"path ratio", Align::right},
           {"95th", Align::right},
           {"over", Align::right},
           {"SPL", Align::right},
           {"clearance m", Align::right},
           {"m/s", Align::right},
           {"s to goal", Align::right},
           {"plan us", Align::right},
           {"ended otherwise", Align::left}},
          {}};
}

std::vector<std::string> outcome_row(const PlannerSummary& s) {
  return {printable(s.planner),
          std::to_string(s.n),
          rate_text(s.success),
          fixed(s.path_ratio_median.value, 3),
          fixed(s.path_ratio_p95.value, 3),
          std::to_string(s.path_ratio_median.n),
          fixed(s.spl_mean.value, 3),
          fixed(s.clearance_min_m, 2),
          fixed(s.speed_mean_median_m_s.value, 2),
          fixed(s.duration_median_s.value, 1),
          fixed(s.planning_time_us_median.value, s.planning_time_us_median.value < 10 ? 1 : 0),
          other_outcomes(s)};
}

TextTable pairing_table() {
  return {{{"planner", Align::left},
           {"against", Align::left},
           {"n", Align::right},
           {"win", Align::right},
           {"tie", Align::right},
           {"loss", Align::right},
           {"won of decided [95 %]", Align::right}},
          {}};
}

std::vector<std::string> pairing_row(const PlannerPairing& p) {
  return {printable(p.planner_a),   printable(p.planner_b), std::to_string(p.n),
          std::to_string(p.wins_a), std::to_string(p.ties), std::to_string(p.wins_b),
          rate_text(p.win_share_a)};
}

// One section per run of rows with the same group; write(title, table).
template <class Rows, class Row, class Write>
void write_sections(const Rows& rows, const TextTable& empty, const std::string& suffix, Row&& row,
                    Write&& write) {
  for (auto first = rows.begin(); first != rows.end();) {
    TextTable table = empty;
    auto last = first;
    for (; last != rows.end() && last->group == first->group; ++last) {
      table.rows.push_back(row(*last));
    }
    write(title(first->group) + suffix, table);
    first = last;
  }
}

// Pairings of single groups are in the JSON and in the report; here only the widest view of each.
std::vector<PlannerPairing> headline_pairings(const Summary& summary) {
  std::vector<PlannerPairing> list;
  for (const PlannerPairing& p : summary.pairings) {
    bool pooled_too = false;
    for (const PlannerSummary& total : summary.totals) {
      pooled_too = pooled_too || (total.group.vehicle == p.group.vehicle &&
                                  total.group.regulator == p.group.regulator);
    }
    if (p.group.all_scenarios || !pooled_too) {
      list.push_back(p);
    }
  }
  return list;
}

template <class Write>
void write_all(const Summary& summary, Write&& write) {
  write_sections(summary.groups, outcome_table(), "", outcome_row, write);
  write_sections(summary.totals, outcome_table(), "", outcome_row, write);
  write_sections(headline_pairings(summary), pairing_table(), ": same worlds and repetitions",
                 pairing_row, write);
}

std::string change_text(const Estimate& change, const char* unit) {
  if (change.n == 0) {
    return "-";
  }
  const auto signed_text = [](double value) {
    return (value > 0 ? "+" : "") + fixed(100.0 * value, 1);
  };
  const std::string interval = std::isnan(change.interval.low)
                                   ? ""
                                   : " [" + signed_text(change.interval.low) + ", " +
                                         signed_text(change.interval.high) + "]";
  return signed_text(change.value) + unit + interval + " over " + std::to_string(change.n);
}

TextTable change_table() {
  return {{{"scenarios", Align::left},
           {"vehicle", Align::left},
           {"planner", Align::left},
           {"pairs", Align::right},
           {"reached before", Align::right},
           {"now", Align::right},
           {"change in points", Align::right},
           {"path ratio", Align::right},
           {"time to goal", Align::right},
           {"state checks", Align::right},
           {"planning time", Align::right}},
          {}};
}

std::vector<std::string> change_row(const PlannerChange& c) {
  return {printable(c.group.scenario_group),
          printable(c.group.vehicle),
          printable(c.planner),
          std::to_string(c.n),
          rate_text(c.reached_before),
          rate_text(c.reached_now),
          change_text(c.success_change, ""),
          change_text(c.path_ratio_change, " %"),
          change_text(c.duration_change, " %"),
          change_text(c.state_checks_change, " %"),
          change_text(c.planning_time_change, " %")};
}

}  // namespace

std::string comparison_markdown(const RunComparison& comparison) {
  TextTable table = change_table();
  for (const PlannerChange& change : comparison.changes) {
    table.rows.push_back(change_row(change));
  }
  return "**against " + printable(comparison.title) + "**\n\n" + table.markdown() + "\n" +
         std::to_string(comparison.outcomes.size()) + " trials end differently; " +
         std::to_string(comparison.only_here) + " here and " +
         std::to_string(comparison.only_there) + " there have no partner.\n";
}

std::string summary_text(const Summary& summary) {
  std::string out;
  write_all(summary, [&out](const std::string& heading, const TextTable& table) {
    out += (out.empty() ? "" : "\n") + heading + "\n" + table.aligned();
  });
  if (!out.empty()) {
    out +=
        "\nSuccess and SPL are over all n trials, path ratio and time over those that reached the "
        "goal.\nClearance is the smallest of all trials, speed the median of the trials' means.\n";
  }
  return out;
}

std::string summary_markdown(const Summary& summary) {
  std::string out;
  write_all(summary, [&out](const std::string& heading, const TextTable& table) {
    out += (out.empty() ? "**" : "\n**") + heading + "**\n\n" + table.markdown();
  });
  return out;
}

}  // namespace voronaut
