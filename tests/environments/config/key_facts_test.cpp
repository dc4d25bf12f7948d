#include "voronaut/environments/config/key_facts.h"

#include <limits>

#include <gtest/gtest.h>

#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/renamed_keys.h"
#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

enum class Cut { plane, columns };
enum class Counts { checks, seconds };

struct InnerConfig {
  int rays = 91;

  template <class Visitor>
  void visit(Visitor& v) {
    v.count("rays", rays, 1, 1000, "Beams of a scan");
  }
};

struct OuterConfig {
  double heading_rad = std::numeric_limits<double>::quiet_NaN();
  bool clockwise = true;
  Cut cut = Cut::columns;
  InnerConfig inner = {};
  Counts counts = Counts::checks;
  int checks = 5;
  double wall_s = 0.5;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("heading_rad", heading_rad, -10, 10, "Where it looks");
    v.flag("clockwise", clockwise, "Which way it turns");
    v.choice("cut", cut, {{"plane", Cut::plane}, {"columns", Cut::columns}}, "What is taken");
    v.form("start", "[x, y]", "Where it starts");
    v.section("inner", inner, "What it sees by");
    v.alternatives(counts, {{Counts::checks, {"checks"}}, {Counts::seconds, {"wall_s"}}});
    if (v.all_groups() || counts == Counts::checks) v.count("checks", checks, 1, 100, "So many");
    if (v.all_groups() || counts == Counts::seconds) v.number("wall_s", wall_s, 0, 9, "So long");
  }
};

OuterConfig read(const std::string& yaml) {
  OuterConfig config;
  read_into(ConfigNode::parse(yaml, "outer.yaml"), config);
  return config;
}

std::string error_in(const std::string& yaml) {
  return error_of<ConfigError>([&] { read(yaml); });
}

struct HastyConfig {
  InnerConfig inner = {};
  double speed_m_s = 1;

  static HastyConfig hasty() {
    HastyConfig config;
    config.speed_m_s = 3;
    return config;
  }
  template <class Visitor>
  void visit(Visitor& v) {
    v.presets(*this, {{"calm", {}}, {"hasty", hasty()}}, "How fast in all");
    v.section("inner", inner, "What it sees by");
    v.number("speed_m_s", speed_m_s, 0, 9, "So fast");
  }
};

struct TravelConfig {
  HastyConfig travel = {};

  template <class Visitor>
  void visit(Visitor& v) {
    v.section("travel", travel, "How it goes");
  }
};

TEST(KeyFacts, ASectionWithPresetsMayBeTheNameOfOne) {
  const KeyFact travel = key_facts(TravelConfig{}).front();
  EXPECT_EQ(allowed_text(travel), "section, or one of calm, hasty");
  EXPECT_EQ(travel.keys.front().key, "preset");
  EXPECT_EQ(travel.keys.front().default_text, "calm");
  const auto speed_in = [](const std::string& yaml) {
    TravelConfig config;
    read_into(ConfigNode::parse(yaml, "travel.yaml"), config);
    return config.travel.speed_m_s;
  };
  EXPECT_EQ(speed_in("{}"), 1);
  EXPECT_EQ(speed_in("travel: hasty"), 3);
  EXPECT_EQ(speed_in("travel: {preset: hasty}"), 3);
  EXPECT_EQ(speed_in("travel: {speed_m_s: 2, preset: hasty}"), 2);
  EXPECT_EQ(error_of<ConfigError>([&] { speed_in("travel: {preset: hurried}"); }),
            "travel.yaml:1: key 'travel.preset': expected one of calm, hasty, got 'hurried'");
}

TEST(KeyFacts, SayWhatEachKeyMayBe) {
  const std::vector<KeyFact> facts = key_facts(OuterConfig{});
  ASSERT_EQ(facts.size(), 7U);
  EXPECT_EQ(allowed_text(facts[0]), "number from -10 to 10");
  EXPECT_EQ(facts[0].default_text, "") << "out of bounds: none";
  EXPECT_EQ(allowed_text(facts[1]), "true or false");
  EXPECT_EQ(facts[1].default_text, "true");
  EXPECT_EQ(allowed_text(facts[2]), "one of plane, columns");
  EXPECT_EQ(facts[2].default_text, "columns");
  EXPECT_EQ(facts[2].sentence, "What is taken");
  EXPECT_EQ(allowed_text(facts[3]), "[x, y]");
  ASSERT_EQ(facts[4].keys.size(), 1U);
  EXPECT_EQ(allowed_text(facts[4].keys[0]), "whole number from 1 to 1000");
  EXPECT_EQ(facts[4].keys[0].default_text, "91");
  EXPECT_EQ(facts[5].default_text, "5");
  EXPECT_EQ(facts[6].default_text, "") << "not counted unless it is given";
}

TEST(KeyFacts, ReadTheUnitFromTheName) {
  EXPECT_EQ(unit_of_key("max_range_m"), "m");
  EXPECT_EQ(unit_of_key("max_acceleration_m_s2"), "m/s^2");
  EXPECT_EQ(unit_of_key("max_yaw_rate_rad_s"), "rad/s");
  EXPECT_EQ(unit_of_key("yaw_gain_1_s"), "1/s");
  EXPECT_EQ(unit_of_key("density_per_m2"), "1/m^2");
  EXPECT_EQ(unit_of_key("time_limit_s_per_m"), "s/m");
  EXPECT_EQ(unit_of_key("lookahead_per_speed_s"), "s");
  EXPECT_EQ(unit_of_key("motor_friction_N_m_s"), "N m s");
  EXPECT_EQ(unit_of_key("drag_factor_N_m_s2"), "N m s^2");
  EXPECT_EQ(unit_of_key("rays"), "");
  EXPECT_EQ(unit_of_key("walls"), "");
}

TEST(ConfigSections, AreReadAndWrittenUnderTheirKey) {
  EXPECT_EQ(read("inner: {rays: 7}").inner.rays, 7);
  EXPECT_EQ(error_in("inner: {rais: 7}"),
            "outer.yaml:1: key 'inner.rais': unknown key (allowed: rays; did you mean 'rays'?)");
  EXPECT_EQ(canonical_text(OuterConfig{.heading_rad = 1}),
            "heading_rad=1;clockwise=true;cut=columns;inner.rays=91;checks=5;");
}

TEST(ConfigAlternatives, AreChosenByTheKeyThatIsGiven) {
  EXPECT_EQ(read("clockwise: false").counts, Counts::checks);
  const OuterConfig timed = read("wall_s: 2");
  EXPECT_EQ(timed.counts, Counts::seconds);
  EXPECT_EQ(timed.wall_s, 2);
  EXPECT_EQ(error_in("checks: 2\nwall_s: 2"),
            "outer.yaml:2: key 'wall_s': cannot stand beside checks (allowed: checks, or wall_s)");
}

TEST(RenamedKeys, AreNamedWithTheirNewName) {
  ASSERT_FALSE(renamings().empty());
  const Renaming one = renamings().front();
  const std::string old(one.old), now(one.now);
  const ConfigNode root = ConfigNode::parse(old + ": 1", "old.yaml");
  const auto problem = [&](const std::vector<std::string>& allowed) -> std::string {
    try {
      root.allow_only(allowed);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(problem({"a", now}),
            "old.yaml:1: key '" + old + "': '" + old + "' is now '" + now + "'");
  EXPECT_EQ(problem({"a"}), "old.yaml:1: key '" + old + "': unknown key (allowed: a)")
      << "the new name means nothing here";
  EXPECT_EQ(problem({old, now}), "no error") << "an old word may be right elsewhere";
}

TEST(RenamedKeys, AreNamedInChoicesToo) {
  const Renaming one = renamings().front();
  const ConfigNode root = ConfigNode::parse("kind: " + std::string(one.old), "old.yaml");
  try {
    root.child("kind").choice({"a", std::string(one.now)});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()), "old.yaml:1: key 'kind': '" + std::string(one.old) +
                                             "' is now '" + std::string(one.now) + "'");
  }
}

}  // namespace
}  // namespace voronaut
