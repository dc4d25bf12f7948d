#include "voronaut/reports/store/store.h"

#include <algorithm>
#include <csignal>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/reports/figures/figure_panels.h"
#include "voronaut/tests/reports/synthetic_run.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;

class Store : public ::testing::Test {
 protected:
  Store()
      : folder_(std::filesystem::temp_directory_path() /
                ("voronaut-store-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~Store() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file() const { return folder_ / "results.db"; }

  template <class Action>
  static std::string error_of(Action&& action) {
    try {
      action();
    } catch (const StoreError& error) {
      return error.what();
    }
    return "no error";
  }

  std::filesystem::path folder_;
};

TEST_F(Store, GivesBackEveryColumnOfARecord) {
  RunRecord record = synthetic::make_record("t1");
  record.reason = std::string("quote ' and \" and \0 zero", 23);
  ResultStore store = ResultStore::create(file());
  EXPECT_TRUE(store.insert(record, std::nullopt));
  const auto back = store.record("t1");
  ASSERT_TRUE(back);
  EXPECT_FALSE(first_difference(*back, record));
  EXPECT_EQ(back->reason, record.reason);
  EXPECT_EQ(back->duration_s, 0.1 + 0.2);
  EXPECT_EQ(back->planning_time_us_mean, 41.5);
  EXPECT_TRUE(std::isnan(back->clearance_mean_m));
  EXPECT_TRUE(std::isnan(back->cpu_time_s));
  EXPECT_FALSE(store.record("t2"));
  EXPECT_FALSE(store.trace("t1"));
}

TEST_F(Store, StoresAbsentNumbersAsNull) {
  ResultStore store = ResultStore::create(file());
  store.insert(synthetic::make_record("t1"), std::nullopt);
  sqlite::Database database(file(), sqlite::OpenMode::existing);
  sqlite::Statement query(database,
                          "SELECT count(*) FROM trials WHERE end_x_m IS NULL AND spl > 0.9 AND "
                          "outcome = 'goal_reached' AND typeof(seed) = 'integer'");
  ASSERT_TRUE(query.step());
  EXPECT_EQ(query.integer(0), 1);
}

TEST_F(Store, OrdersRecordsByTrialId) {
  ResultStore store = ResultStore::create(file());
  for (const char* id : {"b", "a", "B", "aa"}) {
    store.insert(synthetic::make_record(id), std::nullopt);
  }
  EXPECT_THAT(store.trial_ids(), ::testing::ElementsAre("B", "a", "aa", "b"));
  EXPECT_EQ(store.records().at(2).trial_id, "aa");
  EXPECT_TRUE(store.has("aa"));
  EXPECT_FALSE(store.has("A"));
}

TEST_F(Store, TakesTheSameTrialTwiceAndKeepsTheFirst) {
  ResultStore store = ResultStore::create(file());
  RunRecord record = synthetic::make_record("t1");
  EXPECT_TRUE(store.insert(record, std::nullopt));
  record.planning_time_us_mean = 99.0;
  EXPECT_FALSE(store.insert(record, std::nullopt));
  EXPECT_EQ(store.record("t1")->planning_time_us_mean, 41.5);
}

TEST_F(Store, NamesTheColumnInWhichASecondInsertDiffers) {
  ResultStore store = ResultStore::create(file());
  RunRecord record = synthetic::make_record("t1");
  store.insert(record, std::nullopt);
  record.replans = 18;
  const std::string error = error_of([&] { store.insert(record, std::nullopt); });
  EXPECT_EQ(error,
            file().string() + ": trial t1 is stored with another value of replans: '17', now '18'");
  record.replans = 17;
  record.end_x_m = 1.0;
  EXPECT_THAT(error_of([&] { store.insert(record, std::nullopt); }), HasSubstr("end_x_m: '', now"));
}

TEST_F(Store, KeepsTracesAndWorlds) {
  const auto run = synthetic::make_run();
  ResultStore store = ResultStore::create(file());
  const TraceWorld& world = run.worlds.front();
  const Trace& trace = run.traces.front();
  store.insert_world(world);
  store.insert_world(world);
  store.insert(run.records.front(), trace);
  ASSERT_EQ(store.worlds().size(), 1U);
  EXPECT_EQ(store.worlds().front().circles.size(), world.circles.size());
  ASSERT_TRUE(store.trace(trace.trial_id));
  EXPECT_EQ(store.trace(trace.trial_id)->frames.size(), trace.frames.size());
  EXPECT_TRUE(store.trace_blob(trace.trial_id));
}

TEST_F(Store, GivesFigurePanelsPerWorld) {
  const auto run = synthetic::make_run();
  ResultStore store = ResultStore::create(file());
  std::vector<std::string> ids;
  for (const Trace& trace : run.traces) {
    const auto record =
        std::find_if(run.records.begin(), run.records.end(),
                     [&](const RunRecord& r) { return r.trial_id == trace.trial_id; });
    store.insert(*record, trace);
    ids.push_back(trace.trial_id);
  }
  EXPECT_EQ(error_of([&] { figure_panels(store, ids); }),
            "trial " + ids.front() + ": no world is stored");
  for (const TraceWorld& world : run.worlds) {
    store.insert_world(world);
  }
  const auto panels = figure_panels(store, ids);
  ASSERT_EQ(panels.size(), run.worlds.size());
  EXPECT_EQ(panels.front().title, "paper-0");
  EXPECT_EQ(panels.front().tracks.size(), 3U);
  EXPECT_EQ(panels.front().tracks.at(1).label, "as_published");
  EXPECT_EQ(error_of([&] { figure_panels(store, {"nobody"}); }),
            "trial nobody: no such trial is stored");
  EXPECT_EQ(store.trace_sizes().at(ids.front()), store.trace_blob(ids.front())->size());
}

TEST_F(Store, KeepsMetaAndReplacesIt) {
  ResultStore store = ResultStore::create(file());
  EXPECT_FALSE(store.meta("suite"));
  store.set_meta({{"suite", "one"}});
  store.set_meta({{"suite", "two"}});
  EXPECT_EQ(store.meta("suite"), "two");
}

TEST_F(Store, IsMadeWithItsMetaOrNotAtAll) {
  std::ofstream(file()).close();  // its maker was killed
  EXPECT_EQ(ResultStore::create(file(), {{"suite", "one"}}).meta("suite"), "one");
  EXPECT_EQ(ResultStore::create(file(), {{"suite", "two"}}).meta("suite"), "one");
}

TEST_F(Store, KeepsCopiesOfFiles) {
  ResultStore store = ResultStore::create(file());
  EXPECT_TRUE(store.kept_files().empty());
  const ResultStore::Files files = {{"/a.yaml", "world: {}"}, {"/b.pgm", std::string("\0\1", 2)}};
  store.keep_files({{"/old.yaml", "x"}});
  store.keep_files(files);
  EXPECT_EQ(ResultStore::open(file()).kept_files(), files);
}

TEST_F(Store, RefusesAValueOfAnotherTypeWithRowAndColumn) {
  const auto refusal = [&](const std::string& assignment) {
    std::filesystem::remove(file());
    ResultStore store = ResultStore::create(file());
    for (const char* id : {"t1", "t2"}) store.insert(synthetic::make_record(id), std::nullopt);
    sqlite::Database(file(), sqlite::OpenMode::existing)
        .execute("UPDATE trials SET " + assignment + " WHERE trial_id = 't2'");
    EXPECT_TRUE(store.record("t1"));
    return error_of([&] { store.records(); });
  };
  const std::string row = file().string() + ": table trials, row with trial_id 't2', column ";
  EXPECT_EQ(refusal("duration_s = 'fast'"), row + "duration_s: expected a number, got 'fast'");
  EXPECT_EQ(refusal("replans = 'many'"), row + "replans: expected a whole number, got 'many'");
  EXPECT_EQ(refusal("replans = 1.5"), row + "replans: expected a whole number, got '1.5'");
  EXPECT_EQ(refusal("planner = x'41'"), row + "planner: expected text, got 'A'");
  EXPECT_EQ(refusal("duration_s = 3"), "no error");
}

TEST_F(Store, WritesItsFileAnewWhenSomebodyDeletesOrReplacesIt) {
  ResultStore store = ResultStore::create(file());
  store.insert(synthetic::make_record("t1"), std::nullopt);
  std::filesystem::remove(file());
  store.insert(synthetic::make_record("t2"), std::nullopt);
  EXPECT_EQ(ResultStore::open(file()).trial_ids(), (std::vector<std::string>{"t1", "t2"}));
  std::filesystem::rename(file(), file().string() + ".elsewhere");
  std::ofstream(file()) << "no database";
  store.restore_at_path();
  EXPECT_EQ(ResultStore::open(file()).trial_ids(), (std::vector<std::string>{"t1", "t2"}));
}

TEST_F(Store, ContinuesWhereAnotherProcessStopped) {
  {
    ResultStore store = ResultStore::create(file());
    store.insert(synthetic::make_record("t1"), std::nullopt);
  }
  ResultStore store = ResultStore::create(file());
  EXPECT_TRUE(store.has("t1"));
  EXPECT_TRUE(ResultStore::open(file()).has("t1"));
}

TEST_F(Store, SurvivesAKillAtAnyMomentWithWholeTrialsOnly) {
  ResultStore::create(file());
  for (int round = 0; round < 5; ++round) {
    const pid_t child = fork();
    if (child == 0) {
      ResultStore store = ResultStore::open(file());
      const TraceWorld world = synthetic::make_world("w", 3, 4);
      for (int i = 0;; ++i) {
        const std::string id = std::to_string(round) + "-" + std::to_string(i);
        store.insert(synthetic::make_record(id),
                     synthetic::make_trace(id, world, 1, Outcome::collision, 11));
      }
    }
    const auto stored = [&] { return ResultStore::open(file()).trial_ids().size(); };
    for (const std::size_t before = stored(); stored() == before;) usleep(1000);
    usleep(7'000 * round);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    ResultStore store = ResultStore::open(file());
    sqlite::Database database(file(), sqlite::OpenMode::existing);
    sqlite::Statement check(database, "PRAGMA integrity_check");
    ASSERT_TRUE(check.step());
    EXPECT_EQ(check.text(0), "ok");
    for (const std::string& id : store.trial_ids()) {
      EXPECT_TRUE(store.trace(id)) << id;
    }
  }
  EXPECT_GT(ResultStore::open(file()).trial_ids().size(), 0U);
}

TEST_F(Store, SaysThatAFileIsMissing) {
  EXPECT_EQ(error_of([&] { ResultStore::open(file()); }),
            file().string() + ": cannot open the result store: unable to open database file");
}

TEST_F(Store, SaysThatAFileIsNoDatabase) {
  std::ofstream(file()) << std::string(2000, 'x');
  EXPECT_THAT(error_of([&] { ResultStore::open(file()); }), HasSubstr("file is not a database"));
  EXPECT_THAT(error_of([&] { ResultStore::create(file()); }), HasSubstr("file is not a database"));
}

TEST_F(Store, SaysThatTheSchemaIsAnother) {
  ResultStore::create(file());
  sqlite::Database database(file(), sqlite::OpenMode::existing);
  database.execute("PRAGMA user_version = 7");
  EXPECT_EQ(error_of([&] { ResultStore::open(file()); }),
            file().string() + ": schema version 7, this program reads version 4");
  database.execute("PRAGMA user_version = 4");
  database.execute("ALTER TABLE trials DROP COLUMN spl");
  EXPECT_THAT(error_of([&] { ResultStore::create(file()); }),
              HasSubstr("path_ratio, clearance_smallest_m"));
}

TEST_F(Store, LeavesADatabaseOfSomebodyElseAlone) {
  sqlite::Database database(file(), sqlite::OpenMode::create);
  database.execute("CREATE TABLE recipes(name TEXT)");
  EXPECT_THAT(error_of([&] { ResultStore::create(file()); }), HasSubstr("schema version 0"));
  sqlite::Statement tables(database, "SELECT count(*) FROM sqlite_master");
  tables.step();
  EXPECT_EQ(tables.integer(0), 1);
}

}  // namespace
}  // namespace voronaut
