#include "voronaut/reports/summary/summary_text.h"

#include <algorithm>
#include <cmath>

#include "voronaut/reports/store/csv_writer.h"
#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

using Align = TextTable::Align;

std::string title(const SummaryGroup& group) {
  return printable((group.all_scenarios ? "all scenarios" : group.scenario_group) + ", " +
                   group.vehicle + (group.regulator.empty() ? "" : " with " + group.regulator));
}

// What no row has a value of is not shown.
std::vector<const Statistic*> shown_of(const Summary& summary) {
  std::vector<const Statistic*> shown = statistics_shown(kText);
  std::erase_if(shown, [&](const Statistic* one) {
    return std::all_of(summary.groups.begin(), summary.groups.end(),
                       [&](const PlannerSummary& s) { return s.of(one->name).n == 0; });
  });
  return shown;
}

// "goal reached, SPL".
std::string labels_over(TrialSet trials, const std::vector<const Statistic*>& shown) {
  std::string text;
  std::string_view last;
  for (const Statistic* one : shown) {
    if (one->trials != trials || one->label == last) continue;
    text.append(text.empty() ? "" : ", ").append(one->label);
    last = one->label;
  }
  return text;
}

// "all trials: goal reached, SPL; trials that moved: clearance".
std::string trials_of(const std::vector<const Statistic*>& shown) {
  std::string text;
  for (const TrialSet trials : {TrialSet::all, TrialSet::moved, TrialSet::goal_reached}) {
    const std::string labels = labels_over(trials, shown);
    if (labels.empty()) continue;
    text.append(text.empty() ? "" : "; ").append(words(trials)).append(": ").append(labels);
  }
  return text;
}

TextTable statistics_table(const std::vector<const Statistic*>& shown) {
  TextTable table{{{"planner", Align::left}, {"n"}, {"rank"}}, {}};
  for (const Statistic* one : shown) table.columns.push_back({heading(*one)});
  table.columns.push_back({"ended otherwise", Align::left});
  return table;
}

std::vector<std::string> statistics_row(const PlannerSummary& s,
                                        const std::vector<const Statistic*>& shown) {
  std::vector<std::string> row{printable(s.planner), std::to_string(s.n), std::to_string(s.rank)};
  for (const Statistic* one : shown) row.push_back(brief_text(*one, s.of(one->name), s.outcomes));
  const bool flown = s.of("speed_mean_median_m_s").n > 0;
  row.push_back(other_outcomes(s.outcomes, kText, flown));
  return row;
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

// Of decided pairs, written as the share of trials that reach the goal is.
std::string share_text(const Estimate& share) {
  OutcomeCounts counts{};
  counts.front() = share.n;
  return brief_text(statistic("goal_reached_share"), share, counts);
}

std::vector<std::string> pairing_row(const PlannerPairing& p) {
  return {printable(p.planner_a),   printable(p.planner_b), std::to_string(p.n),
          std::to_string(p.wins_a), std::to_string(p.ties), std::to_string(p.wins_b),
          share_text(p.win_share_a)};
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
  const auto shown = shown_of(summary);
  const auto row = [&](const PlannerSummary& s) { return statistics_row(s, shown); };
  write_sections(summary.groups, statistics_table(shown), "", row, write);
  write_sections(summary.totals, statistics_table(shown), "", row, write);
  write_sections(headline_pairings(summary), pairing_table(), ": same worlds and repetitions",
                 pairing_row, write);
}

}  // namespace

std::string summary_text(const Summary& summary) {
  std::string out;
  write_all(summary, [&out](const std::string& heading, const TextTable& table) {
    out += (out.empty() ? "" : "\n") + heading + "\n" + table.aligned();
  });
  if (!out.empty()) {
    out += "\nOver " + trials_of(shown_of(summary)) +
           ". Brackets are 95 % intervals. Rank: 1 + planners that "
           "are better, p < 0.05 after Holm (docs/results.md).\n";
  }
  return out;
}

std::string summary_csv(const Summary& summary, const std::vector<AxisColumn>& axes) {
  std::string csv = "scenario_group,vehicle,regulator,planner";
  for (const AxisColumn& axis : axes) csv += "," + csv_field(axis.path);
  csv += ",n,rank";
  for (const Statistic& one : statistics())
    for (const char* part : {"", "_low", "_high", "_n"})
      csv.append(",").append(one.name).append(part);
  for (const PlannerSummary& s : summary.groups) {
    csv += "\r\n" + csv_field(s.group.scenario_group) + "," + csv_field(s.group.vehicle) + "," +
           csv_field(s.group.regulator) + "," + csv_field(s.planner);
    for (const AxisColumn& axis : axes)
      csv += "," + csv_field(axis.value_of(s.group.scenario_group, s.group.vehicle, s.planner));
    csv += "," + std::to_string(s.n) + "," + std::to_string(s.rank);
    for (const Estimate& e : s.estimates)
      csv += "," + cell_text(e.value) + "," + cell_text(e.interval.low) + "," +
             cell_text(e.interval.high) + "," + std::to_string(e.n);
  }
  return csv + "\r\n";
}

std::string summary_markdown(const Summary& summary) {
  std::string out;
  write_all(summary, [&out](const std::string& heading, const TextTable& table) {
    out += (out.empty() ? "**" : "\n**") + heading + "**\n\n" + table.markdown();
  });
  return out;
}

}  // namespace voronaut
