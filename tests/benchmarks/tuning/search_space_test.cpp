#include "voronaut/benchmarks/tuning/search_space.h"

#include <set>
#include <stdexcept>

#include <gmock/gmock.h>

#include "voronaut/environments/config/config_node.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;

KeyFact declared(const std::string& key, KeyFact::Kind kind, double lo, double hi) {
  KeyFact fact;
  fact.key = key;
  fact.kind = kind;
  fact.lo = lo;
  fact.hi = hi;
  return fact;
}

const std::vector<KeyFact> kDeclared = {declared("range", KeyFact::Kind::number, 0, 100),
                                        declared("samples", KeyFact::Kind::whole_number, 1, 50),
                                        declared("lazy", KeyFact::Kind::flag, 0, 0)};

TEST(SearchSpace, EveryKeyHasOneValueInEachStratum) {
  const std::vector<SearchKey> keys = {search_key("range=1:9", kDeclared),
                                       search_key("samples=1:8", kDeclared)};
  const auto points = points_in(keys, 8, 7);
  std::set<int> strata;
  std::set<std::string> samples;
  for (const auto& point : points) {
    const double range = parse_number(point[0]).value();
    EXPECT_GE(range, 1);
    EXPECT_LE(range, 9);
    strata.insert(static_cast<int>(range - 1 - 1e-3));
    EXPECT_TRUE(parse_whole(point[1])) << point[1];
    samples.insert(point[1]);
  }
  EXPECT_EQ(strata.size(), 8U);
  EXPECT_GE(samples.size(), 6U);
}

TEST(SearchSpace, LogarithmicStrataAreEquallyLikelyInTheirRatios) {
  int below_one = 0;
  for (const auto& point : points_in({search_key("range=0.01:100:log", kDeclared)}, 100, 7))
    below_one += parse_number(point[0]).value() < 1 ? 1 : 0;
  EXPECT_EQ(below_one, 50);
}

TEST(SearchSpace, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const std::vector<SearchKey> keys = {search_key("range=1:9", kDeclared)};
  EXPECT_EQ(points_in(keys, 8, 7), points_in(keys, 8, 7));
  EXPECT_NE(points_in(keys, 8, 7), points_in(keys, 8, 8));
}

TEST(SearchSpace, RefusesWhatThePlannerDoesNotTake) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"rnge=1:2",
       "--over: 'rnge=1:2': no number 'rnge' of this planner (allowed: range, samples; "
       "did you mean 'range'?)"},
      {"lazy=0:1", "no number 'lazy'"},
      {"range=1", "expected key=LOW:HIGH"},
      {"range", "expected key=LOW:HIGH"},
      {"range=a:2", "expected key=LOW:HIGH"},
      {"range=2:1", "expected LOW below HIGH"},
      {"range=0:1:log", "log needs LOW above 0"},
      {"range=-1:1", "expected bounds within 0:100"},
      {"samples=1:51", "expected bounds within 1:50"},
  };
  for (const auto& [text, message] : cases) {
    try {
      search_key(text, kDeclared);
      ADD_FAILURE() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  }
}

}  // namespace
}  // namespace voronaut
