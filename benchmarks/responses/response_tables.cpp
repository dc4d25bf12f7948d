#include "voronaut/benchmarks/responses/response_tables.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include "voronaut/dynamics/step_response.h"
#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

constexpr double kPeriod_s = 0.01;
constexpr double kSpeed_m_s = 2.5;
constexpr double kDistance_m = 5;

using Inertia = QuadrotorConfig::InertiaSet;

std::string with_digits(double value, int digits) {
  if (std::isnan(value)) return "tips over";
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

struct DrivenVehicle {
  std::string inertia, regulator;
  VehicleSpec vehicle;
  RegulatorConfig config;
};

std::vector<DrivenVehicle> driven_quadrotors() {
  std::vector<DrivenVehicle> driven;
  for (const auto& [inertia, name] :
       {std::pair{Inertia::corrected, "corrected"}, std::pair{Inertia::printed, "printed"}}) {
    VehicleSpec vehicle = find_vehicle("quadrotor");
    std::get<QuadrotorConfig>(vehicle.model).inertia = inertia;
    for (const std::string& regulator : regulator_names()) {
      const RegulatorConfig config = find_regulator(regulator);
      try {
        make_regulator(config, vehicle, kPeriod_s);
      } catch (const std::invalid_argument&) {
        continue;  // drives another model
      }
      driven.push_back({name, regulator, vehicle, config});
    }
  }
  return driven;
}

TextTable table_of(const std::vector<std::string>& numbers) {
  using Align = TextTable::Align;
  TextTable table{{{"inertia", Align::left}, {"regulator", Align::left}}, {}};
  for (const std::string& heading : numbers) table.columns.push_back({heading, Align::right});
  return table;
}

TextTable steps(const std::vector<DrivenVehicle>& driven) {
  TextTable table = table_of({"to 90 % [s]", "within 2 % [s]", "overshoot [%]", "tilt [deg]",
                              "height [mm]", "within 5 cm [s]", "overshoot [cm]"});
  for (const DrivenVehicle& one : driven) {
    const VelocityStep speed = velocity_step(one.vehicle, one.config, kSpeed_m_s, kPeriod_s);
    const PositionStep place = position_step(one.vehicle, one.config, kDistance_m, kPeriod_s);
    table.rows.push_back(
        {one.inertia, one.regulator, with_digits(speed.rise_s, 2), with_digits(speed.settling_s, 2),
         with_digits(100 * speed.overshoot_m_s / kSpeed_m_s, 1),
         with_digits(speed.max_tilt_rad * 180 / std::numbers::pi, 1),
         with_digits(1000 * speed.height_error_m, 1), with_digits(place.settling_s, 2),
         with_digits(100 * place.overshoot_m, 1)});
  }
  return table;
}

TextTable stops(const std::vector<DrivenVehicle>& driven) {
  TextTable table = table_of({"k [1/s]", "a [m/s^2]", "from 1 m/s [m]", "by the law [m]",
                              "from 2.5 m/s [m]", "by the law [m]", "rest [mm]", "per speed [ms]"});
  for (const DrivenVehicle& one : driven) {
    const StoppingLaw law = stopping_law(one.config, one.vehicle);
    std::vector<std::string> row = {one.inertia, one.regulator, with_digits(law.k_1_s, 3),
                                    with_digits(law.a_m_s2, 2)};
    for (const double v : {1.0, kSpeed_m_s}) {
      row.push_back(with_digits(flown_stop_m(one.vehicle, one.config, v, kPeriod_s), 3));
      row.push_back(with_digits(stopping_distance_m(v, law.k_1_s, law.a_m_s2), 3));
    }
    try {
      const VelocityResponse response = velocity_response(one.config, one.vehicle, kPeriod_s);
      row.push_back(with_digits(1000 * response.error_at_rest_m, 0));
      row.push_back(with_digits(1000 * response.error_per_speed_s, 0));
    } catch (const std::invalid_argument&) {  // promises no stop
      row.insert(row.end(), {"none", "none"});
    }
    table.rows.push_back(row);
  }
  return table;
}

// Safe speeds against range and reaction time, the vehicle's own clearance kept.
TextTable safe_speeds(const std::vector<DrivenVehicle>& driven) {
  const double reactions_s[] = {0.06, 0.1, 0.2, 0.3};
  std::vector<std::string> headings;
  for (const char* range : {"2.5", "5"})
    for (const double reaction_s : reactions_s)
      headings.push_back(std::string(range) + " m, " + with_digits(reaction_s, 2) + " s");
  TextTable table = table_of(headings);
  for (const DrivenVehicle& one : driven) {
    const StoppingLaw law = stopping_law(one.config, one.vehicle);
    std::vector<std::string> row = {one.inertia, one.regulator};
    for (const double range_m : {2.5, 5.0})
      for (const double reaction_s : reactions_s)
        row.push_back(with_digits(safe_speed_m_s(range_m, one.vehicle.planning_clearance_m,
                                                 reaction_s, law.k_1_s, law.a_m_s2),
                                  2));
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace

std::string response_tables() {
  const std::vector<DrivenVehicle> driven = driven_quadrotors();
  return "Steps at a period of 10 ms: from rest to 2.5 m/s (first five columns), and to rest at a "
         "place 5 m ahead.\n\n" +
         steps(driven).markdown() +
         "\nStops: k and a of the stopping law, what was flown from steady flight beside what the "
         "law says, and the error that\nthe governor adds to a predicted stop: at rest, and per "
         "m/s "
         "of speed.\n\n" +
         stops(driven).markdown() +
         "\nSafe speed in m/s where something may stand at the end of the range, for reaction "
         "times of sensing and planning; its\nclearance of 0.4 m is kept.\n\n" +
         safe_speeds(driven).markdown();
}

}  // namespace voronaut
