#include "voronaut/dynamics/catalog.h"

#include <cmath>
#include <initializer_list>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <gmock/gmock.h>

namespace voronaut::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kPeriod_s = 0.01;

std::string message_of(const auto& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Catalog, MakesEveryVehicleWithItsRegulator) {
  for (const std::string& name : vehicle_names()) {
    const VehicleSpec spec = find_vehicle(name);
    EXPECT_EQ(spec.name, name);
    EXPECT_GT(spec.planning_clearance_m, spec.body_radius_m);
    EXPECT_NE(make_model(spec.model), nullptr);
    EXPECT_NE(make_regulator(find_regulator(spec.regulator), spec, kPeriod_s), nullptr);
    EXPECT_GT(stopping_law(find_regulator(spec.regulator), spec).a_m_s2, 0);
  }
}

TEST(Catalog, KnowsTheBodies) {
  EXPECT_EQ(find_vehicle("quadrotor").body_radius_m, 0.25);
  EXPECT_EQ(find_vehicle("quadrotor").limits.max_speed_m_s, 2.5);
  EXPECT_EQ(find_vehicle("quadrotor_props").body_radius_m, 0.39);
  EXPECT_EQ(find_vehicle("quadrotor_props").planning_clearance_m, 0.5);
  EXPECT_EQ(find_vehicle("ideal").body_radius_m, 0.25);
  EXPECT_EQ(find_vehicle("cart").body_radius_m, 0.22);
  // Its hull of 0.458 x 0.416 m lies within the disc, and little else does.
  EXPECT_NEAR(find_vehicle("jackal").body_radius_m, 0.5 * std::hypot(0.458, 0.416), 1e-3);
  EXPECT_EQ(find_vehicle("jackal").limits.max_speed_m_s, 2);
  EXPECT_EQ(find_vehicle("cart").limits.max_speed_m_s, 1.25);
}

TEST(Catalog, PlansWithAHandsWidthBesideTheBody) {
  const auto beside_body_m = [](const char* name) {
    return find_vehicle(name).planning_clearance_m - find_vehicle(name).body_radius_m;
  };
  for (const char* name : {"ideal", "unicycle", "jackal", "cart"})
    EXPECT_NEAR(beside_body_m(name), 0.04, 1e-12) << name;
  EXPECT_NEAR(beside_body_m("quadrotor"), 0.06, 1e-12);
}

TEST(Catalog, TellsWhatWheelsCannotDo) {
  const std::set<std::string> wheeled{"car", "cart", "jackal", "unicycle"};
  for (const std::string& name : vehicle_names()) {
    const Mobility mobility = mobility_of(find_vehicle(name));
    EXPECT_EQ(mobility.flies, wheeled.count(name) == 0) << name;
    EXPECT_EQ(mobility.moves_sideways, wheeled.count(name) == 0) << name;
  }
}

TEST(Catalog, NamesEveryEntryOnceInAlphabeticalOrder) {
  EXPECT_THAT(vehicle_names(), ElementsAre("car", "cart", "ideal", "jackal", "quadrotor",
                                           "quadrotor_props", "unicycle"));
  EXPECT_THAT(regulator_names(),
              ElementsAre("arc_tracker", "car_tracker", "cascade_pid", "ideal", "lqr",
                          "paper_literal", "pd_rate", "position_trajectory", "se3"));
}

TEST(Catalog, ListsTheKnownNamesWhenOneIsUnknown) {
  EXPECT_THAT(message_of([] { find_vehicle("quadcopter"); }),
              AllOf(HasSubstr("unknown vehicle 'quadcopter'"), HasSubstr("quadrotor_props")));
  EXPECT_THAT(message_of([] { find_regulator("pid"); }),
              AllOf(HasSubstr("unknown regulator 'pid'"), HasSubstr("pd_rate")));
}

TEST(Catalog, RefusesARegulatorThatDrivesAnotherModel) {
  EXPECT_THAT(message_of([] {
                make_regulator(find_regulator("pd_rate"), find_vehicle("ideal"), kPeriod_s);
              }),
              AllOf(HasSubstr("'pd_rate'"), HasSubstr("'ideal'")));
  EXPECT_THAT(message_of([] {
                make_regulator(find_regulator("ideal"), find_vehicle("quadrotor"), kPeriod_s);
              }),
              AllOf(HasSubstr("'ideal'"), HasSubstr("'quadrotor'")));
  EXPECT_THROW(make_regulator(find_regulator("paper_literal"), find_vehicle("ideal"), kPeriod_s),
               std::invalid_argument);
  EXPECT_THAT(message_of([] {
                make_regulator(find_regulator("pd_rate"), find_vehicle("cart"), kPeriod_s);
              }),
              AllOf(HasSubstr("'pd_rate'"), HasSubstr("'cart'")));
  EXPECT_THAT(message_of([] {
                make_regulator(find_regulator("position_trajectory"), find_vehicle("ideal"),
                               kPeriod_s);
              }),
              AllOf(HasSubstr("'position_trajectory'"), HasSubstr("'ideal'")));
}

TEST(Catalog, GivesTheStoppingLawOfTheGainsAndTheTilt) {
  const StoppingLaw law = stopping_law(find_regulator("pd_rate"), find_vehicle("quadrotor"));
  EXPECT_NEAR(law.k_1_s, 1.786, 1e-3);
  EXPECT_NEAR(law.a_m_s2, 3.5706, 1e-4);
}

// Visits every key once and holds the default against the bounds.
struct DefaultsAreInBounds {
  std::set<std::string> keys;

  void fresh(const std::string& key, const std::string& sentence) {
    EXPECT_TRUE(keys.insert(key).second) << key;
    EXPECT_FALSE(sentence.empty()) << key;
  }
  void number(const char* key, double& value, double low, double high, const char* sentence) {
    fresh(key, sentence);
    EXPECT_GE(value, low) << key;
    EXPECT_LE(value, high) << key;
  }
  void count(const char* key, int& value, int low, int high, const char* sentence) {
    fresh(key, sentence);
    EXPECT_GE(value, low) << key;
    EXPECT_LE(value, high) << key;
  }
  void flag(const char* key, bool&, const char* sentence) { fresh(key, sentence); }
  template <class Enum>
  void choice(const char* key, Enum& value,
              std::initializer_list<std::pair<const char*, Enum>> choices, const char* sentence) {
    fresh(key, sentence);
    bool known = false;
    for (const auto& [name, choice] : choices) known = known || choice == value;
    EXPECT_TRUE(known) << key;
  }
};

TEST(Catalog, HasDefaultsWithinTheBoundsOfEveryConfig) {
  for (const std::string& name : vehicle_names()) {
    VehicleSpec spec = find_vehicle(name);
    DefaultsAreInBounds body;
    spec.visit(body);
    EXPECT_EQ(body.keys.count("max_speed_m_s"), 1);
    DefaultsAreInBounds model;
    std::visit([&](auto& config) { config.visit(model); }, spec.model);
    EXPECT_FALSE(model.keys.empty());
  }
  for (const std::string& name : regulator_names()) {
    RegulatorConfig any = find_regulator(name);
    DefaultsAreInBounds keys;
    std::visit([&](auto& config) { config.visit(keys); }, any);
    EXPECT_EQ(keys.keys.count("speed_profile"), 1);
  }
}

}  // namespace
}  // namespace voronaut::testing
