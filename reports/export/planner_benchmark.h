#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "voronaut/reports/store/store.h"

// A run of a suite as OMPL's benchmark tools see one: what its log and the database of Planner
// Arena hold (https://ompl.kavrakilab.org/benchmark.html, "The Benchmark Logfile Format").
namespace voronaut {

struct BenchmarkColumn {
  std::string name;  // letters, digits and '_' only: it becomes a column of SQL without quotes
  std::string type;  // BOOLEAN, ENUM, INTEGER, REAL, STRING
};

// One value for each column; empty: absent.
using BenchmarkRow = std::vector<std::string>;

struct BenchmarkedPlanner {
  std::string name;
  std::vector<std::string> settings;                // "range = 2"
  std::vector<BenchmarkRow> runs;                   // of PlannerBenchmark::run_columns
  std::vector<std::vector<BenchmarkRow>> progress;  // for each run, of progress_columns
};

struct PlannerBenchmark {
  bool static_planning = false;  // a suite of `kind: static`
  std::string name;              // without blanks: the tools keep the last word only
  std::string version;           // without blanks
  std::string host;
  std::string date;  // "2026-11-25 12:42:59"
  std::string setup;
  std::string processor;
  std::int64_t seed = 0;
  double time_limit_s = 0;
  double memory_limit_mb = 0;
  int runs_per_planner = 0;
  double total_time_s = 0;
  std::string enum_name;
  std::vector<std::string> enum_words;
  std::vector<BenchmarkColumn> run_columns;
  std::vector<BenchmarkColumn> progress_columns;
  std::vector<BenchmarkedPlanner> planners;
};

// Fills columns and planners from what is stored; the rest is the caller's, `static_planning`
// before. One planner for each label, in the order of the alphabet, its runs in the order of trial
// ids. Columns are those of RunRecord that are numbers or names, with what OMPL's tools ask for:
//   time     the flight's simulated duration, or the wall time of a static solve, s
//   solved   whether the goal was reached              memory   MB
//   trial_seed   seed (the tables' own `seed` is the suite's)        status   the outcome
// and of static planning, empty without a path, as OMPL's Benchmark calls it:
//   approximate_solution   the path leads elsewhere     correct_solution   the check accepts it
//   solution_length        m                            solution_clearance   mean at its vertices,
//   m
// Progress is taken from stored traces; a trial without one has none. Of a flight every 0.5 s of
// simulated time: distance to goal, length flown. Of a static plan whenever an anytime planner had
// a better path: its cost (best_cost, m), the state checks made by then, and wall time.
void add_stored_runs(const ResultStore& store, PlannerBenchmark& benchmark);

}  // namespace voronaut
