#include "voronaut/benchmarks/results/merge.h"

#include <algorithm>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/benchmarks/results/digest.h"
#include "voronaut/reports/store/sqlite.h"
#include "voronaut/tests/benchmarks/small_suite.h"
#include "voronaut/tests/support/temporary_folder.h"

// Rows that were flown apart become one folder, and only such as belong together.
namespace voronaut {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

RunReport fly_shard(const SuiteConfig& suite, const fs::path& folder, Shard shard, std::size_t jobs,
                    std::set<std::string> elsewhere = {}) {
  fs::create_directories(folder);
  ResultStore store = ResultStore::create(
      folder / "results.db",
      {{"suite_identity", "one"}, {"builds", "1 first\n"}, {"repetitions", "3"}});
  std::ostringstream silent;
  Progress progress(silent, false, 0, {});
  ShortestReferences references = made_up_references();
  return run_suite(suite, [](const TrialSpec& spec, bool) { return made_up_flight(spec); }, jobs,
                   references, store, progress, {shard, std::move(elsewhere)});
}

std::string digest_of(const fs::path& folder) {
  return digest(ResultStore::open(folder / "results.db").records());
}

void execute(const fs::path& folder, const std::string& sql) {
  sqlite::Database(folder / "results.db", sqlite::OpenMode::existing).execute(sql);
}

std::string refusal(const MergeOrder& order) {
  try {
    merge_folders(order);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "none";
}

class Merging : public ::testing::Test {
 protected:
  fs::path path(const std::string& name) const { return folder_.path() / name; }
  SuiteConfig suite_ = small_suite("spread", {"a", "b", "c"}, 3);

 private:
  TemporaryFolder folder_;
};

TEST_F(Merging, GivesTheSerialDigestForAnySplitJobsOrderAndRestart) {
  fly_shard(suite_, path("serial"), {}, 1);
  const std::string serial = digest_of(path("serial"));
  std::mt19937 random(7);
  for (int round = 0; round < 6; ++round) {
    const fs::path run = path("run" + std::to_string(round));
    const std::size_t count = 1 + random() % 6;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 1; i <= count; ++i) numbers.push_back(i);
    std::shuffle(numbers.begin(), numbers.end(), random);
    for (const std::size_t number : numbers) {
      const Shard shard{number, count};
      const fs::path folder = shards_in(run) / shard.folder_name();
      if (random() % 2 == 0) {  // a part of it before
        std::set<std::string> not_yet;
        for (const RunRecord& record : ResultStore::open(path("serial") / "results.db").records())
          if (random() % 2 == 0) not_yet.insert(record.trial_id);
        fly_shard(suite_, folder, shard, 1, not_yet);
      }
      fly_shard(suite_, folder, shard, 1 + random() % 3);
    }
    std::vector<fs::path> folders = folders_with_results(run);
    ASSERT_EQ(folders.size(), count);
    std::shuffle(folders.begin(), folders.end(), random);
    merge_folders({folders, run});
    EXPECT_EQ(digest_of(run), serial) << count << " shards";
    merge_folders({{run}, run});
    EXPECT_EQ(digest_of(run), serial) << "merged again";
    EXPECT_EQ(OutputFolder::open(run).store().worlds().size(), 4U);
  }
}

TEST_F(Merging, RefusesRowsThatContradictAndNamesColumnAndBothValues) {
  fly_shard(suite_, path("a"), {}, 1);
  fs::copy(path("a"), path("b"), fs::copy_options::recursive);
  execute(path("b"), "UPDATE trials SET cpu_time_s = 1e3");  // measured: may differ
  merge_folders({{path("a"), path("b")}, path("fine")});
  execute(path("b"), "UPDATE trials SET replans = 7 WHERE planner = 'b' AND scenario = 'open'");
  EXPECT_THAT(refusal({{path("a"), path("b")}, path("m")}),
              AllOf(HasSubstr("has another value of replans"), HasSubstr("'7' here, '")));
  EXPECT_FALSE(fs::exists(path("m"))) << "nothing is half-written";
}

TEST_F(Merging, TakesOtherBuildsWhenToldAndSaysSo) {
  fly_shard(suite_, path("a"), {1, 2}, 1);
  fly_shard(suite_, path("b"), {2, 2}, 1);
  execute(path("b"), "UPDATE meta SET value = '2 second' || char(10) WHERE key = 'builds'");
  EXPECT_THAT(refusal({{path("a"), path("b")}, path("m")}),
              AllOf(HasSubstr("holds rows of another build than"), HasSubstr("--mixed-builds")));
  EXPECT_FALSE(fs::exists(path("m")));
  const OutputFolder merged = merge_folders({{path("b"), path("a")}, path("m"), true});
  EXPECT_THAT(merged.note_on_builds(), HasSubstr("rows of 2 builds are in one table: first with"));
  std::ostringstream page;
  page << std::ifstream(path("m") / "report.html").rdbuf();
  EXPECT_THAT(page.str(), HasSubstr("\"mixed_builds\":\"2\""));
  EXPECT_THAT(refusal({{path("m")}, path("again")}), HasSubstr("--mixed-builds"));
}

TEST_F(Merging, RefusesAnotherSuiteAndFoldersWithoutResults) {
  fly_shard(suite_, path("a"), {}, 1);
  fly_shard(suite_, path("b"), {}, 1);
  execute(path("b"), "UPDATE meta SET value = 'two' WHERE key = 'suite_identity'");
  EXPECT_THAT(refusal({{path("a"), path("b")}, path("m")}), HasSubstr("results of another suite"));
  fs::create_directories(path("empty"));
  EXPECT_THAT(refusal({{path("a"), path("empty")}, path("m")}), HasSubstr("no results here"));
  EXPECT_FALSE(fs::exists(path("m")));
}

TEST_F(Merging, BringsTracesAndKeptFilesAlong) {
  for (const char* name : {"a", "b"}) {
    fly_shard(suite_, path(name), {name[0] == 'a' ? 1U : 2U, 2}, 1);
    ResultStore store = ResultStore::open(path(name) / "results.db");
    store.keep_files({{std::string("/f/") + name, "bytes"}});
    execute(path(name), "INSERT INTO traces SELECT trial_id, x'00' FROM trials LIMIT 2");
  }
  const OutputFolder merged = merge_folders({{path("a"), path("b")}, path("m")});
  EXPECT_EQ(merged.store().kept_files().size(), 2U);
  EXPECT_EQ(merged.store().trace_sizes().size(), 4U);
}

}  // namespace
}  // namespace voronaut
