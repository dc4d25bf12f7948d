#include <string>

#include <gtest/gtest.h>

#include "voronaut/environments/config/config_node.h"

namespace voronaut {
namespace {

const ConfigNode& root() {
  static const ConfigNode node = ConfigNode::parse(
      "a: 1\nb: {c: [x, 'y z', \"2\", ~], d: true}\ne: 'it''s \"q\"'\n", "r.yaml");
  return node;
}

TEST(ConfigEdit, WritesYamlThatIsReadAsTheSame) {
  const std::string yaml = root().yaml();
  EXPECT_EQ(yaml, R"({a: 1, b: {c: [x, "y z", "2", ~], d: true}, e: "it's \"q\""})");
  EXPECT_EQ(ConfigNode::parse(yaml, "again.yaml").yaml(), yaml);
}

TEST(ConfigEdit, PutsInReplacesAndTakesOutWithoutTouchingTheOriginal) {
  const ConfigNode changed =
      root().with("a", root().child("b").child("d")).with("f", root().child("a"));
  EXPECT_TRUE(changed.child("a").flag());
  EXPECT_EQ(changed.child("f").number(), 1);
  EXPECT_EQ(root().child("a").number(), 1);
  EXPECT_FALSE(root().find("f"));
  EXPECT_FALSE(changed.without("a").find("a"));
  EXPECT_EQ(root().child("a").under("n").child("n").number(), 1);
}

TEST(ConfigEdit, AValueOfNoFileIsCalledAsItWasSaid) {
  const ConfigNode changed = root().with("a", root().value("{n: high}", "--set a"));
  try {
    changed.child("a").child("n").number();
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "--set a: key 'a.n': expected a number, got 'high'");
  }
  EXPECT_EQ(changed.child("a").file(), "r.yaml") << "its files are beside the one it changes";
  EXPECT_EQ(changed.child("b").place(), "r.yaml:2");
}

TEST(ConfigEdit, WhatIsPutIntoAnotherFileKeepsItsPlace) {
  const ConfigNode other = ConfigNode::parse("\n\nlist: [1, two]\n", "o.yaml");
  const ConfigNode list = root().child("b").child("c").with_items({other.child("list").items()[1]});
  const ConfigNode changed = root().with("b", root().child("b").with("c", list));
  const ConfigNode two = changed.child("b").child("c").items()[0];
  EXPECT_EQ(two.place(), "o.yaml:3");
  EXPECT_EQ(two.path(), "b.c[0]");
  EXPECT_EQ(changed.child("b").child("d").place(), "r.yaml:2");
}

}  // namespace
}  // namespace voronaut
