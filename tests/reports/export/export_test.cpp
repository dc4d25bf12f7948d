#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "voronaut/reports/export/mcap_log.h"
#include "voronaut/reports/export/ompl_log.h"
#include "voronaut/reports/export/planner_arena.h"
#include "voronaut/reports/store/sqlite.h"
#include "voronaut/tests/reports/synthetic_run.h"

namespace voronaut {
namespace {

namespace fs = std::filesystem;

class Export : public ::testing::Test {
 protected:
  Export()
      : folder_(fs::path(testing::TempDir()) /
                (std::string("voronaut_export_") +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    ResultStore store = ResultStore::create(folder_ / "results.db");
    synthetic::RunConfig small;
    small.groups = {"forest"};
    small.repetitions = 2;
    small.rays = 11;
    const synthetic::Run run = synthetic::make_run(small);
    for (const TraceWorld& world : run.worlds) store.insert_world(world);
    for (const RunRecord& record : run.records) {
      std::optional<Trace> trace;
      for (const Trace& one : run.traces)
        if (one.trial_id == record.trial_id) trace = one;
      store.insert(record, trace);
      if (trace) ++traced_;
    }
  }
  ~Export() override { fs::remove_all(folder_); }

  ResultStore store() const { return ResultStore::open(folder_ / "results.db"); }

  PlannerBenchmark benchmark(bool static_planning = false) const {
    PlannerBenchmark benchmark;
    benchmark.static_planning = static_planning;
    benchmark.name = "synthetic";
    benchmark.version = "0.1.0+abc";
    benchmark.host = "somewhere";
    benchmark.date = "2026-01-02 03:04:05";
    benchmark.setup = "suite: synthetic\nseed: 1\n";
    benchmark.processor = "a processor";
    benchmark.seed = 7;
    benchmark.time_limit_s = 300;
    benchmark.memory_limit_mb = 1024;
    add_stored_runs(store(), benchmark);
    benchmark.planners.front().settings = {"range = 2", "goal_bias = 0.05"};
    return benchmark;
  }

  fs::path folder_;
  std::size_t traced_ = 0;

  // Holds our database against what OMPL's script makes of our log.
  void expect_as_by_script(const PlannerBenchmark& exported) const;
};

// Every row of a table or view as text, each value with its storage class.
std::vector<std::string> rows_of(const fs::path& file, const std::string& table) {
  const sqlite::Database database(file, sqlite::OpenMode::existing);
  std::string columns;
  sqlite::Statement info(database, "SELECT name, type FROM pragma_table_info('" + table + "')");
  std::vector<std::string> rows;
  while (info.step()) {
    rows.push_back(info.text(0) + " " + info.text(1));
    columns += (columns.empty() ? "" : " || '|' || ") +
               ("typeof(" + info.text(0) + ") || ':' || ifnull(" + info.text(0) + ", '')");
  }
  sqlite::Statement all(database, "SELECT " + columns + " FROM " + table);
  while (all.step()) rows.push_back(all.text(0));
  return rows;
}

void Export::expect_as_by_script(const PlannerBenchmark& exported) const {
  std::ofstream(folder_ / "run.log") << ompl_log(exported);
  write_planner_arena(exported, folder_ / "ours.db");
  const std::string command = "cd '" + folder_.string() +
                              "' && ompl_benchmark_statistics -d theirs.db run.log >out.txt 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0);
  for (const char* table : {"experiments", "plannerConfigs", "enums", "runs", "progress",
                            "bestPlannerConfigsPerExperiment", "bestPlannerConfigs"}) {
    const auto theirs = rows_of(folder_ / "theirs.db", table);
    EXPECT_EQ(rows_of(folder_ / "ours.db", table), theirs) << table;
    EXPECT_GT(theirs.size(), 1U) << table;
  }
}

TEST_F(Export, PlannerArenaIsWhatOmplsOwnScriptMakesOfTheLog) {
  if (std::system("ompl_benchmark_statistics --help >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "no ompl_benchmark_statistics (package ompl-demos)";
  expect_as_by_script(benchmark());
}

TEST_F(Export, PlannerArenaIsWhatTheScriptMakesOfStaticPlanningToo) {
  if (std::system("ompl_benchmark_statistics --help >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "no ompl_benchmark_statistics (package ompl-demos)";
  expect_as_by_script(benchmark(true));
}

TEST_F(Export, KeepsTheColumnsThatPlannerArenaReadsByPosition) {
  write_planner_arena(benchmark(), folder_ / "ours.db");
  const sqlite::Database database(folder_ / "ours.db", sqlite::OpenMode::existing);
  sqlite::Statement counts(
      database,
      "SELECT (SELECT count(*) FROM pragma_table_info('experiments')), (SELECT name FROM "
      "pragma_table_info('runs') WHERE cid = 3), (SELECT count(*) FROM runs WHERE solved), (SELECT "
      "count(DISTINCT runid) FROM progress)");
  ASSERT_TRUE(counts.step());
  EXPECT_EQ(counts.integer(0), 12);
  EXPECT_EQ(counts.text(1), "time");
  std::int64_t solved = 0;
  for (const RunRecord& record : store().records())
    if (record.outcome == Outcome::goal_reached) ++solved;
  EXPECT_EQ(counts.integer(2), solved);
  EXPECT_EQ(counts.integer(3), static_cast<std::int64_t>(traced_));
}

// Reads an MCAP file as its specification says, on its own: no line is shared with the writer.
struct McapFile {
  explicit McapFile(const std::string& bytes) : bytes_(bytes) {
    const std::string magic("\x89MCAP0\r\n", 8);
    EXPECT_EQ(bytes.substr(0, 8), magic);
    EXPECT_EQ(bytes.substr(bytes.size() - 8), magic);
    at_ = 8;
    while (at_ < bytes.size() - 8) record();
  }

  std::map<int, std::string> schemas;                       // id, name
  std::map<int, std::pair<int, std::string>> channels;      // id, (schema, topic)
  std::map<std::string, std::vector<std::uint64_t>> times;  // by topic
  std::map<std::string, nlohmann::json> first_message;
  std::vector<int> opcodes;

 private:
  std::uint64_t number(int size) {
    std::uint64_t value = 0;
    for (int i = size - 1; i >= 0; --i)
      value =
          value * 256 + static_cast<unsigned char>(bytes_.at(at_ + static_cast<std::size_t>(i)));
    at_ += static_cast<std::size_t>(size);
    return value;
  }
  std::string text() {
    const auto size = number(4);
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }
  void record() {
    opcodes.push_back(static_cast<int>(number(1)));
    const std::uint64_t size = number(8);
    const std::size_t end = at_ + size;
    if (opcodes.back() == 3) {
      const int id = static_cast<int>(number(2));
      schemas[id] = text();
      EXPECT_EQ(text(), "jsonschema");
      EXPECT_TRUE(nlohmann::json::parse(text()).is_object());
    } else if (opcodes.back() == 4) {
      const int id = static_cast<int>(number(2));
      const int schema = static_cast<int>(number(2));
      channels[id] = {schema, text()};
      EXPECT_EQ(text(), "json");
      EXPECT_EQ(number(4), 0U);
    } else if (opcodes.back() == 5) {
      const std::string topic = channels.at(static_cast<int>(number(2))).second;
      number(4);
      times[topic].push_back(number(8));
      EXPECT_EQ(number(8), times[topic].back());
      const auto message = nlohmann::json::parse(bytes_.substr(at_, end - at_));
      if (times[topic].size() == 1) first_message[topic] = message;
      at_ = end;
    } else {
      at_ = end;
    }
    EXPECT_EQ(at_, end);
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

TEST_F(Export, McapHoldsEveryTraceForViewers) {
  const std::string bytes = mcap_log(store());
  const McapFile file(bytes);
  ASSERT_GE(file.opcodes.size(), 3U);
  EXPECT_EQ(file.opcodes.front(), 1);
  EXPECT_EQ(file.opcodes[file.opcodes.size() - 2], 15);
  EXPECT_EQ(file.opcodes.back(), 2);
  EXPECT_EQ(file.schemas.size(), 3U);
  std::size_t poses = 0;
  for (const RunRecord& record : store().records()) {
    const auto trace = store().trace(record.trial_id);
    if (!trace) continue;
    const std::string topic =
        "/" + record.scenario + "/" + record.planner + "/" + record.trial_id.substr(0, 8) + "/pose";
    ASSERT_EQ(file.times.count(topic), 1U) << topic;
    EXPECT_EQ(file.times.at(topic).size(), trace->frames.size());
    const auto position = file.first_message.at(topic)["pose"]["position"];
    EXPECT_EQ(position["x"].get<double>(), trace->frames.front().x_m);
    ++poses;
  }
  EXPECT_EQ(poses, traced_);
  EXPECT_EQ(file.channels.size(), 3 * traced_);
}

}  // namespace
}  // namespace voronaut
