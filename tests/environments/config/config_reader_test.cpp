#include "voronaut/environments/config/config_reader.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

enum class Profile { sqrt, paper };

struct SampleConfig {
  double max_range_m = 2.5;
  int rays = 91;
  bool clockwise = false;
  std::string label = "none";
  Profile profile = Profile::paper;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("max_range_m", max_range_m, 0.1, 100.0, "How far a beam sees");
    v.count("rays", rays, 1, 100'000, "Beams of a scan");
    v.flag("clockwise", clockwise, "Which way they turn");
    v.text("label", label, "What reports call it");
    v.choice("profile", profile, {{"sqrt", Profile::sqrt}, {"paper", Profile::paper}},
             "How it slows down");
  }
};

std::string error_in(const std::string& yaml) {
  return error_of<ConfigError>([&] {
    SampleConfig config;
    read_into(ConfigNode::parse(yaml, "sample.yaml"), config);
  });
}

TEST(ConfigReader, ReadsEveryKindOfMember) {
  SampleConfig config;
  read_into(ConfigNode::parse("max_range_m: 5e-1\nrays: +7\nclockwise: true\n"
                              "label: \"12\"\nprofile: sqrt\n",
                              "sample.yaml"),
            config);
  EXPECT_EQ(config.max_range_m, 0.5);
  EXPECT_EQ(config.rays, 7);
  EXPECT_TRUE(config.clockwise);
  EXPECT_EQ(config.label, "12");
  EXPECT_EQ(config.profile, Profile::sqrt);
}

TEST(ConfigReader, KeepsTheDefaultsOfWhatIsNotThere) {
  SampleConfig config;
  read_into(ConfigNode::parse("rays: 3", "sample.yaml"), config);
  EXPECT_EQ(config.rays, 3);
  EXPECT_EQ(config.max_range_m, 2.5);
  EXPECT_EQ(config.profile, Profile::paper);
}

TEST(ConfigReader, SaysInOneLineWhatIsWrong) {
  const std::string allowed = "max_range_m, rays, clockwise, label, profile";
  const std::string range = "expected a number from 0.1 to 100, got ";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"rays: 3\nmax_rnage_m: 2", "sample.yaml:2: key 'max_rnage_m': unknown key (allowed: " +
                                      allowed + "; did you mean 'max_range_m'?)"},
      {"zzz: 1", "sample.yaml:1: key 'zzz': unknown key (allowed: " + allowed + ")"},
      {"rays: many",
       "sample.yaml:1: key 'rays': expected a whole number from 1 to 100000, got "
       "'many'"},
      {"rays: 10.0",
       "sample.yaml:1: key 'rays': expected a whole number from 1 to 100000, got "
       "'10.0'"},
      {"rays: 99999999999999999999",
       "sample.yaml:1: key 'rays': expected a whole number from 1 to 100000, got "
       "'99999999999999999999'"},
      {"max_range_m: .nan", "sample.yaml:1: key 'max_range_m': " + range + "'.nan'"},
      {"max_range_m: nan", "sample.yaml:1: key 'max_range_m': " + range + "'nan'"},
      {"max_range_m: inf", "sample.yaml:1: key 'max_range_m': " + range + "'inf'"},
      {"max_range_m: 1e999", "sample.yaml:1: key 'max_range_m': " + range + "'1e999'"},
      {"max_range_m: 2.5m", "sample.yaml:1: key 'max_range_m': " + range + "'2.5m'"},
      {"max_range_m: '2.5'", "sample.yaml:1: key 'max_range_m': " + range + "the text '2.5'"},
      {"max_range_m: 0.09", "sample.yaml:1: key 'max_range_m': " + range + "'0.09'"},
      {"max_range_m:", "sample.yaml:1: key 'max_range_m': " + range + "nothing"},
      {"max_range_m: [1, 2]", "sample.yaml:1: key 'max_range_m': " + range + "a list of 2"},
      {"clockwise: yes", "sample.yaml:1: key 'clockwise': expected true or false, got 'yes'"},
      {"label: {a: 1}", "sample.yaml:1: key 'label': expected text, got a map"},
      {"profile: sqr",
       "sample.yaml:1: key 'profile': expected one of sqrt, paper, got 'sqr' (did "
       "you mean 'sqrt'?)"},
      {"profile: \"a\\nb\"",
       "sample.yaml:1: key 'profile': expected one of sqrt, paper, got the text 'a\\nb'"},
      {"rays: 1\n# again\nrays: 2", "sample.yaml:3: key 'rays': given twice (first in line 1)"},
      {"", "sample.yaml:1: the file is empty"},
      {"# only a comment\n", "sample.yaml:1: the file is empty"},
      {"- 1\n- 2", "sample.yaml:1: expected a map of keys, got a list of 2"},
      {"just text", "sample.yaml:1: expected a map of keys, got 'just text'"},
      {"rays: [1, 2", "sample.yaml:1: not valid YAML: end of sequence flow not found"},
      {"rays: 3\n\tlabel: x",
       "sample.yaml:2: not valid YAML: illegal tab when looking for indentation"},
      {"[1, 2]: 3", "sample.yaml:1: a key must be text"},
      {"rays: 3\n---\nrays: 4", "sample.yaml:3: a second document; expected one"},
      {std::string("rays: 3\n\x00\x01", 10), "sample.yaml:2: not a text file (byte 8)"},
      {"label: \xff\xfe", "sample.yaml:1: not a text file (byte 7)"},
      {"label: &a [*a]", "sample.yaml:1: an anchor holds itself"},
      {"label: *nowhere", "sample.yaml:1: not valid YAML: the referenced anchor is not defined"},
  };
  for (const auto& [yaml, message] : cases) {
    const std::string error = error_in(yaml);
    EXPECT_EQ(error, message) << yaml;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST(ConfigReader, CutsALongValueInTheMessage) {
  EXPECT_EQ(error_in("rays: " + std::string(1000, 'x')),
            "sample.yaml:1: key 'rays': expected a whole number from 1 to 100000, got '" +
                std::string(60, 'x') + "...'");
}

TEST(ConfigReader, NamesThePathOfANestedKey) {
  const ConfigNode root =
      ConfigNode::parse("list:\n  - rays: 3\n  - rays: no\nempty: []", "sample.yaml");
  const auto items = root.child("list").items();
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].child("rays").whole_number(0, 9), 3);
  EXPECT_EQ(items[1].child("rays").path(), "list[1].rays");
  EXPECT_EQ(items[1].child("rays").line(), 3);
  try {
    items[1].child("label");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "sample.yaml:3: key 'list[1].label': missing");
  }
}

TEST(ConfigReader, ResolvesAliases) {
  const ConfigNode root = ConfigNode::parse("a: &x {rays: 5}\nb: *x", "sample.yaml");
  EXPECT_EQ(root.child("b").child("rays").whole_number(0, 9), 5);
}

TEST(ConfigReader, SurvivesDeepNesting) {
  EXPECT_NE(error_in("label: " + std::string(100'000, '[')), "no error");
}

TEST(ConfigReader, SaysWhyAFileCannotBeRead) {
  const auto error_of_file = [](const std::string& path) {
    try {
      ConfigNode::read_file(path);
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error_of_file("/nowhere/suite.yaml"),
            "/nowhere/suite.yaml: cannot be read (No such file or directory)");
  EXPECT_EQ(error_of_file("/"), "/: cannot be read (is a folder)");
}

TEST(ConfigReader, FindsFilesBesideTheOneThatNamesThem) {
  const ConfigNode root = ConfigNode::parse("a: 1", "suites/paper/x.yaml");
  EXPECT_EQ(root.beside("../worlds/y.yaml"), "suites/worlds/y.yaml");
  EXPECT_EQ(root.beside("/abs/y.yaml"), "/abs/y.yaml");
}

TEST(ConfigText, ReadsBackToTheSameConfig) {
  SampleConfig config;
  config.max_range_m = 0.1 + 0.2;
  config.label = "a=b;c\\";
  EXPECT_EQ(canonical_text(config),
            "max_range_m=0.30000000000000004;rays=91;clockwise=false;label=a\\=b\\;c\\\\;"
            "profile=paper;");
  std::string yaml;
  for (const auto& [key, value] : config_entries(config)) yaml += key + ": " + value + "\n";
  SampleConfig again;
  read_into(ConfigNode::parse(yaml, "again.yaml"), again);
  EXPECT_EQ(canonical_text(again), canonical_text(config));
}

TEST(ConfigText, WritesTheShortestDecimal) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(100.0), "100");
  EXPECT_EQ(number_text(std::numeric_limits<double>::denorm_min()), "5e-324");
}

}  // namespace
}  // namespace voronaut
