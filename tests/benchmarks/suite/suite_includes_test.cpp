#include "voronaut/benchmarks/suite/suite_includes.h"

#include <fstream>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/results/manifest.h"
#include "voronaut/tests/support/temporary_folder.h"

namespace voronaut {
namespace {

class SuiteIncludes : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    const auto file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file.string();
  }
  ConfigNode read(const std::string& file) const {
    return with_includes(ConfigNode::read_file((folder_.path() / file).string()));
  }
  std::string error_of(const std::string& file) const {
    try {
      read(file);
    } catch (const ConfigError& error) {
      const std::string text = error.what();
      return text.substr(folder_.path().string().size() + 1);
    }
    return "no error";
  }

  TemporaryFolder folder_;
};

TEST_F(SuiteIncludes, WhatAFileSaysItselfWinsKeyByKey) {
  write("base.yaml", "suite: base\nloop: {goal_hold_s: 2, time_limit_s: 9}\nplanners: [A, B]\n");
  write("later.yaml", "loop: {time_limit_s: 7}\nseed: 4\n");
  write("own.yaml", "include: [base.yaml, later.yaml]\nsuite: own\nplanners: [C]\n");
  const ConfigNode root = read("own.yaml");
  EXPECT_EQ(root.child("suite").text(), "own");
  EXPECT_EQ(root.child("loop").child("goal_hold_s").number(), 2) << "maps are joined";
  EXPECT_EQ(root.child("loop").child("time_limit_s").number(), 7) << "a later file wins";
  EXPECT_EQ(root.child("planners").texts(), std::vector<std::string>{"C"}) << "lists are replaced";
  EXPECT_EQ(root.child("seed").whole_number(0, 9), 4);
  EXPECT_FALSE(root.find("include"));
}

TEST_F(SuiteIncludes, APresetReplacesTheSectionBelowAndSingleKeysHoldOverOne) {
  write("keys.yaml", "navigation: {governor: false, off_path_m: 2}\n");
  write("paper.yaml", "navigation: paper\n");
  write("a.yaml", "include: keys.yaml\nnavigation: paper\n");
  write("b.yaml", "include: keys.yaml\nnavigation: {preset: paper}\n");
  write("c.yaml", "include: paper.yaml\nnavigation: {off_path_m: 3}\n");
  EXPECT_EQ(read("a.yaml").child("navigation").yaml(), "paper");
  EXPECT_EQ(read("b.yaml").child("navigation").yaml(), "{preset: paper}");
  EXPECT_EQ(read("c.yaml").child("navigation").yaml(), "{off_path_m: 3, preset: paper}");
}

TEST_F(SuiteIncludes, EachValueKeepsItsFileItsLineAndItsFolder) {
  write("sub/base.yaml", "suite: base\nloop:\n  goal_hold_s: 2\nscenarios: [{file: a.yaml}]\n");
  write("own.yaml", "include: sub/base.yaml\nloop: {rate: 3}\n");
  const ConfigNode root = read("own.yaml");
  const ConfigNode hold = root.child("loop").child("goal_hold_s");
  EXPECT_EQ(hold.place(), (folder_.path() / "sub/base.yaml:3").string());
  EXPECT_EQ(root.child("loop").child("rate").place(), (folder_.path() / "own.yaml:2").string());
  EXPECT_EQ(root.child("scenarios").items()[0].child("file").beside("a.yaml"),
            (folder_.path() / "sub/a.yaml").string());
  try {
    root.child("loop").allow_only({"rate"});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()), hold.place() +
                                             ": key 'loop.goal_hold_s': unknown key (allowed: "
                                             "rate)");
  }
}

TEST_F(SuiteIncludes, ThatIncludeEachOtherAreRefusedWithTheChain) {
  write("a.yaml", "include: b.yaml\n");
  write("b.yaml", "seed: 3\ninclude: sub/c.yaml\n");
  write("sub/c.yaml", "include: [../a.yaml]\n");
  EXPECT_EQ(error_of("a.yaml"),
            "sub/c.yaml:1: key 'include[0]': files include each other: a.yaml -> b.yaml -> c.yaml "
            "-> a.yaml");
  write("self.yaml", "include: ./self.yaml\n");
  EXPECT_EQ(error_of("self.yaml"),
            "self.yaml:1: key 'include': files include each other: self.yaml -> self.yaml");
}

TEST_F(SuiteIncludes, OneFileMayBeIncludedOnTwoWays) {
  write("base.yaml", "seed: 3\n");
  write("a.yaml", "include: base.yaml\n");
  write("own.yaml", "include: [a.yaml, base.yaml]\n");
  EXPECT_EQ(read("own.yaml").child("seed").whole_number(0, 9), 3);
}

TEST_F(SuiteIncludes, MissingFilesAreErrorsAtTheKey) {
  write("a.yaml", "seed: 3\ninclude: none.yaml\n");
  EXPECT_EQ(error_of("a.yaml").substr(0, 31), "a.yaml:2: key 'include': no fil");
}

TEST_F(SuiteIncludes, ASuiteIsReadAgainFromTheCopiesThatWereKept) {
  const std::string base =
      write("base.yaml",
            "scenarios: [{name: a, world: {}, bounds: [[-1, -1], [6, 6]], start: [0, 0], goal: "
            "[5, 5]}]\nvehicles: [ideal]\nplanners: [RRTConnect]\n");
  const std::string own = write("own.yaml", "include: base.yaml\nsuite: own\n");
  SuiteSource source{own, read_text_file(own), "", "", "", {}, {"planners.RRTConnect.range=2"}};
  const PlannerCatalog planners = PlannerCatalog::built_in();
  const std::string identity = suite_identity(source.read(planners));
  ASSERT_TRUE(source.files.contains(base));
  std::filesystem::remove(base);
  EXPECT_EQ(suite_identity(source.read(planners)), identity);
  source.set = {"planners.RRTConnect.range=3"};
  EXPECT_NE(suite_identity(source.read(planners)), identity) << "other settings, another suite";
}

}  // namespace
}  // namespace voronaut
