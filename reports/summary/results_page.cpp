#include "voronaut/reports/summary/results_page.h"

#include "voronaut/reports/summary/statistics.h"
#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

using Align = TextTable::Align;

TextTable table_of(const std::vector<std::string>& headings) {
  TextTable table;
  for (const std::string& heading : headings) table.columns.push_back({heading, Align::left});
  return table;
}

std::string or_dash(std::string_view text) { return std::string(text.empty() ? "-" : text); }

std::string outcomes() {
  TextTable table = table_of({"outcome", "sign", "what happened", "failure", "cut off"});
  for (const OutcomeEntry& entry : kOutcomes)
    table.rows.push_back({std::string(entry.name), std::string(entry.sign),
                          std::string(entry.meaning), entry.failure ? "yes" : "no",
                          entry.cut_off ? "yes" : "no"});
  return table.markdown();
}

std::string columns() {
  TextTable table = table_of({"column", "unit", "what it is", "over", "measured"});
  for (const RecordColumn& column : record_columns())
    table.rows.push_back({std::string(column.name), or_dash(column.unit), std::string(column.about),
                          std::string(words(column.trials)),
                          column.kind == ColumnKind::measured     ? "yes"
                          : column.kind == ColumnKind::repeatable ? "no; not in the digest"
                                                                  : "no"});
  return table.markdown();
}

std::string better(const Statistic& statistic) {
  if (statistic.better == Better::neither) return "-";
  return statistic.better == Better::more ? "more" : "less";
}

std::string statistics_table() {
  TextTable table = table_of({"statistic", "unit", "better", "what it is"});
  for (const Statistic& one : statistics())
    table.rows.push_back(
        {std::string(one.name), or_dash(unit_of(one)), better(one), description_of(one)});
  return table.markdown();
}

const ExampleQuery kQueries[] = {
    {"How often did each planner reach the goal?",
     "SELECT scenario_group, planner, count(*) AS n,\n"
     "       avg(outcome = 'goal_reached') AS goal_reached_share\n"
     "FROM trials GROUP BY scenario_group, planner ORDER BY scenario_group, planner;"},
    {"What ended the others, and where?",
     "SELECT planner, outcome, scenario, repetition, reason FROM trials\n"
     "WHERE outcome <> 'goal_reached' ORDER BY planner, outcome, scenario, repetition;"},
    {"How much longer is one planner's path than another's in the same world?",
     "SELECT a.scenario, a.repetition, a.planner, b.planner,\n"
     "       a.path_length_m / b.path_length_m AS ratio\n"
     "FROM trials a JOIN trials b USING (scenario, vehicle, regulator, repetition)\n"
     "WHERE a.planner < b.planner AND a.outcome = 'goal_reached' AND b.outcome = 'goal_reached';"},
    {"Which worlds are hard for all?",
     "SELECT world_id, json_extract(json, '$.start') AS start, count(*) AS n,\n"
     "       sum(outcome <> 'goal_reached') AS failed\n"
     "FROM trials JOIN worlds USING (world_id)\n"
     "GROUP BY world_id ORDER BY failed DESC, world_id LIMIT 10;"},
    {"What does planning cost, and which trials have a trace to replay?",
     "SELECT planner, scenario, repetition, planning_time_us_mean, cpu_time_s,\n"
     "       length(traces.data) AS trace_bytes\n"
     "FROM trials LEFT JOIN traces USING (trial_id)\n"
     "ORDER BY planning_time_us_mean DESC LIMIT 20;"},
    {"Along an axis of a sweep over a planner's key, how often is the goal reached?",
     "SELECT json_extract(said.value, '$.path') AS axis, swept.value, count(*) AS n,\n"
     "       avg(outcome = 'goal_reached') AS goal_reached_share\n"
     "FROM meta, json_each(meta.value) AS said,\n"
     "     json_each(said.value, '$.values') AS swept JOIN trials ON trials.planner = swept.key\n"
     "WHERE meta.key = 'sweep' AND json_extract(said.value, '$.column') = 'planner'\n"
     "GROUP BY 1, 2 ORDER BY 1, 2;"},
};

std::string database() {
  TextTable table = table_of({"table", "columns", "what it holds"});
  table.rows = {
      {"trials", "those above", "one row for each trial; texts and counts are never NULL"},
      {"worlds", "world_id, json",
       "the true world of trials: bounds, circles, polygons, segments, start and goal, in m"},
      {"traces", "trial_id, data",
       "what a replay draws, where the suite keeps it: JSON (reports/trace/trace_json.h), "
       "compressed as raw deflate (RFC 1951)"},
      {"files", "path, data",
       "what was read to make the trials, byte for byte, compressed in the same way"},
      {"meta", "key, value",
       "the suite's text, seed and repetitions, the build that flew it; `set`, where --set changed "
       "it; `sweep`, the axes that it sweeps over"}};
  std::string text = table.markdown();
  text +=
      "\nA trace is unpacked by `python3 -c \"import sqlite3, zlib, sys; "
      "print(zlib.decompress(sqlite3.connect(sys.argv[1]).execute('SELECT data FROM "
      "traces').fetchone()[0], -15).decode())\" DIR/results.db`, and by `voronaut export DIR "
      "--format mcap` with all others.\n";
  for (const ExampleQuery& query : kQueries)
    text.append("\n")
        .append(query.question)
        .append("\n\n```sql\n")
        .append(query.sql)
        .append("\n```\n");
  return text;
}

}  // namespace

std::span<const ExampleQuery> example_queries() { return kQueries; }

std::string results_page() {
  return "# Results\n\n`voronaut list results` prints this page.\n\n## Outcomes\n\nA trial that is "
         "cut "
         "off says that something is wrong with the planner or the suite, not how well it flew: "
         "`voronaut run` ends with exit code 1. Every failure stays in the denominators.\n\n" +
         outcomes() +
         "\n## Columns\n\nOf a record: `results.csv`, table `trials` of `results.db`, exports. "
         "What is "
         "measured differs from run to run and is not part of the digest, nor is what says how "
         "hard "
         "the world is; an absent number is NULL in SQL and empty in CSV.\n\n" +
         columns() +
         "\nA suite that sweeps has a column for each axis besides, after these in `results.csv` "
         "and before the statistics of `voronaut summary --csv`, called by its path. Its value "
         "follows from the name of the scenario, the vehicle or the planner; row `sweep` of table "
         "`meta` says how, as JSON: [{path, column, zipped, values: {name: value}, groups: "
         "{scenario_group: value}, bases: {name: what the suite calls it}}].\n" +
         "\n## Statistics\n\nOf the trials of one planner in one group of scenarios: `voronaut "
         "summary` "
         "(all of them with `--json` and `--csv`), the report, docs/evidence.md. A share has "
         "Wilson's "
         "95 % interval at any n, the others a bootstrap interval over six values or more, the "
         "smallest none; of fewer the values themselves are printed, `too_few` in JSON. An "
         "acceptance "
         "criterion "
         "bounds a statistic by its name with `_min` where more is better, `_max` where less "
         "is.\n\n" +
         statistics_table() +
         "\nOf more than 20 000 values the interval is what the bootstrap tends to: order "
         "statistics at the binomial's limits for a quantile, 1.96 standard errors for a mean.\n"
         "\n`rank` is 1 + the number of planners of the group that are better. Two planners are "
         "compared on the same scenario and repetition by two exact tests: who reached the goal "
         "(McNemar's), and where both did, whose path is shorter by more than 1 % (a sign test); p "
         "is corrected after Holm over all tests of the group. Better is who reaches the goal more "
         "often at p < 0.05; where that is undecided, who has the shorter path more often at p < "
         "0.05. As many better ones give the same rank: as a rule, "
         "where the data cannot tell. `pairings` of `--json` has the p of every pair.\n"
         "\n## Database\n\n`results.db` is an SQLite database, `PRAGMA user_version` the version "
         "of "
         "its schema. A trial is safe as soon as it has ended: killing the program loses nothing "
         "of "
         "it. Rows share transactions and are in `results.db-pending` until then; every command of "
         "the program takes them in. A loss of power may cost the trials of the last 30 s, never "
         "more and never the database.\n\n" +
         database();
}

}  // namespace voronaut
