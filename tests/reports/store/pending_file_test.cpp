#include "voronaut/reports/store/pending_file.h"

#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "voronaut/reports/store/store.h"
#include "voronaut/tests/reports/synthetic_run.h"
#include "voronaut/tests/support/temporary_folder.h"

namespace voronaut {
namespace {

namespace fs = std::filesystem;
using Kind = PendingFile::Kind;

class Pending : public ::testing::Test {
 protected:
  fs::path file() const { return folder_.path() / "results.db"; }
  fs::path pending() const { return file().string() + "-pending"; }

 private:
  TemporaryFolder folder_;
};

TEST_F(Pending, GivesBackWholeFramesUpToTheFirstDamagedOne) {
  PendingFile out(pending());
  out.append(Kind::trial, std::string("a\0b", 3));
  out.append(Kind::world, "");
  out.append(Kind::trial, std::string(100'000, 'x'));
  const auto whole = PendingFile::read(pending());
  ASSERT_EQ(whole.size(), 3U);
  EXPECT_EQ(whole[0].payload, std::string("a\0b", 3));
  EXPECT_EQ(whole[1].kind, Kind::world);
  fs::resize_file(pending(), fs::file_size(pending()) - 1);
  EXPECT_EQ(PendingFile::read(pending()).size(), 2U);
  std::fstream(pending(), std::ios::in | std::ios::out).seekp(14) << 'Z';
  EXPECT_TRUE(PendingFile::read(pending()).empty());
  out.clear();
  EXPECT_FALSE(fs::exists(pending()));
}

TEST_F(Pending, RowsAreTakenInByWhoOpensWhatAKilledWriterLeft) {
  ResultStore::create(file());
  {
    ResultStore killed = ResultStore::open(file());
    killed.keep_world(synthetic::make_world("w0", 3, 4));
    killed.keep(synthetic::make_record("t1"), "trace");
    killed.keep(synthetic::make_record("t2"), "");
  }
  ASSERT_TRUE(fs::exists(pending()));
  const ResultStore reader = ResultStore::open(file());
  EXPECT_EQ(reader.trial_ids(), (std::vector<std::string>{"t1", "t2"}));
  EXPECT_EQ(reader.trace_blob("t1"), "trace");
  EXPECT_EQ(reader.worlds().size(), 1U);
  EXPECT_TRUE(fs::exists(pending())) << "it may belong to a runner that is at work";
  ResultStore::create(file());
  EXPECT_FALSE(fs::exists(pending()));
}

TEST_F(Pending, RowsAreStoredTogetherWhenTheyAreMany) {
  ResultStore store = ResultStore::create(file());
  for (int i = 0; i < 300; ++i) store.keep(synthetic::make_record(std::to_string(i)), "");
  EXPECT_EQ(store.trial_ids().size(), 256U);
  store.flush();
  EXPECT_EQ(store.trial_ids().size(), 300U);
  EXPECT_FALSE(fs::exists(pending()));
}

TEST_F(Pending, RowsOutliveADatabaseThatWasDeletedMeanwhile) {
  ResultStore store = ResultStore::create(file());
  store.keep(synthetic::make_record("t1"), "");
  fs::remove(file());
  store.keep(synthetic::make_record("t2"), "");
  store.flush();
  EXPECT_EQ(ResultStore::open(file()).trial_ids(), (std::vector<std::string>{"t1", "t2"}));
}

}  // namespace
}  // namespace voronaut
