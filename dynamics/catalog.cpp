#include "voronaut/dynamics/catalog.h"

#include <algorithm>
#include <stdexcept>

#include <sleef.h>

namespace voronaut {
namespace {

// Bounds of VelocityResponse::error_m that tests/dynamics/velocity_response_test.cpp holds.
constexpr double kStopErrorAtRest_m = 0.006;
constexpr double kTiltedStopErrorAtRest_m = 0.014;  // of what must tilt to brake
constexpr double kIdealStopError_s = 0.001;
constexpr double kAgileStopError_s = 0.008;    // pd_rate on the corrected inertia
constexpr double kSluggishStopError_s = 0.08;  // on the printed one its rotors saturate

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;  // clang before 17 does not deduce it by itself

[[noreturn]] void throw_unknown(const std::string& kind, const std::string& name,
                                const std::vector<std::string>& known) {
  std::string message = "unknown " + kind + " '" + name + "'; known:";
  for (const std::string& one : known) message += " " + one;
  throw std::invalid_argument(message);
}

template <class Wanted>
const Wanted& model_for(const char* regulator_name, const char* model_name,
                        const VehicleSpec& vehicle) {
  const auto* model = std::get_if<Wanted>(&vehicle.model);
  if (model == nullptr) {
    throw std::invalid_argument("regulator '" + std::string(regulator_name) +
                                "' drives the model " + model_name + ", which vehicle '" +
                                vehicle.name + "' is not");
  }
  return *model;
}

double tilt_acceleration_m_s2(const QuadrotorConfig& model, const MotionLimits& limits) {
  return std::min(limits.max_acceleration_m_s2,
                  model.gravity_m_s2 * Sleef_cinz_tand1_u10purec(limits.max_tilt_rad));
}

const QuadrotorConfig& quadrotor_for(const char* regulator_name, const VehicleSpec& vehicle) {
  return model_for<QuadrotorConfig>(regulator_name, "quadrotor", vehicle);
}

const CartConfig& cart_for(const VehicleSpec& vehicle) {
  return model_for<CartConfig>("position_trajectory", "cart", vehicle);
}

const IdealConfig& ideal_for(const VehicleSpec& vehicle) {
  return model_for<IdealConfig>("ideal", "ideal", vehicle);
}

}  // namespace

bool is_wheeled(const VehicleSpec& vehicle) {
  return std::holds_alternative<CartConfig>(vehicle.model);
}

std::vector<std::string> vehicle_names() {
  return {"cart", "ideal", "quadrotor", "quadrotor_props"};
}

std::vector<std::string> regulator_names() {
  return {"ideal", "paper_literal", "pd_rate", "position_trajectory"};
}

VehicleSpec vehicle(const std::string& name) {
  // Rotor hubs at 0.24 m; with propellers of 0.15 m radius 0.39 m. Acceleration: g tan(20 deg).
  VehicleSpec quadrotor{.name = name,
                        .limits = {.max_acceleration_m_s2 = 3.5706},
                        .model = QuadrotorConfig{},
                        .regulator = "pd_rate"};
  if (name == "quadrotor") return quadrotor;
  if (name == "quadrotor_props") {
    quadrotor.body_radius_m = 0.39;
    quadrotor.planning_clearance_m = 0.5;
    return quadrotor;
  }
  if (name == "cart") {
    // A cruise of 1.25 m/s makes the cart planner paper's mean of 1.19 m/s; the motors reach 1.27.
    // They could give 19 m/s^2; what the wheels' grip allows is ours to choose.
    return {.name = name,
            .body_radius_m = 0.22,
            .planning_clearance_m = 0.37,
            .limits = {.max_speed_m_s = 1.25, .max_acceleration_m_s2 = 1, .max_tilt_rad = 0},
            .model = CartConfig{},
            .regulator = "position_trajectory"};
  }
  if (name == "ideal") {
    return {.name = name,
            .limits = {.max_acceleration_m_s2 = 3, .max_tilt_rad = 0},
            .model = IdealConfig{},
            .regulator = "ideal"};
  }
  throw_unknown("vehicle", name, vehicle_names());
}

RegulatorConfig regulator(const std::string& name) {
  if (name == "pd_rate") return PdRateConfig{};
  if (name == "paper_literal") return PaperLiteralConfig{};
  if (name == "position_trajectory") return PositionTrajectoryConfig{};
  if (name == "ideal") return IdealRegulatorConfig{};
  throw_unknown("regulator", name, regulator_names());
}

std::unique_ptr<Model> make_model(const ModelConfig& config) {
  return std::visit(
      Overloaded{
          [](const IdealConfig& c) -> std::unique_ptr<Model> { return std::make_unique<Ideal>(c); },
          [](const QuadrotorConfig& c) -> std::unique_ptr<Model> {
            return std::make_unique<Quadrotor>(c);
          },
          [](const CartConfig& c) -> std::unique_ptr<Model> { return std::make_unique<Cart>(c); }},
      config);
}

std::unique_ptr<Regulator> make_regulator(const RegulatorConfig& config, const VehicleSpec& vehicle,
                                          double period_s) {
  using Made = std::unique_ptr<Regulator>;
  return std::visit(
      Overloaded{[&](const IdealRegulatorConfig& c) -> Made {
                   ideal_for(vehicle);
                   return std::make_unique<IdealRegulator>(c, vehicle.limits);
                 },
                 [&](const PdRateConfig& c) -> Made {
                   return std::make_unique<PdRate>(c, quadrotor_for("pd_rate", vehicle),
                                                   vehicle.limits, period_s);
                 },
                 [&](const PaperLiteralConfig& c) -> Made {
                   return std::make_unique<PaperLiteral>(c, quadrotor_for("paper_literal", vehicle),
                                                         vehicle.limits, period_s);
                 },
                 [&](const PositionTrajectoryConfig& c) -> Made {
                   return std::make_unique<PositionTrajectory>(c, cart_for(vehicle), vehicle.limits,
                                                               period_s);
                 }},
      config);
}

StoppingLaw stopping_law(const RegulatorConfig& config, const VehicleSpec& vehicle) {
  return std::visit(
      Overloaded{[&](const IdealRegulatorConfig& c) -> StoppingLaw {
                   return {c.velocity_gain_1_s, std::min(vehicle.limits.max_acceleration_m_s2,
                                                         ideal_for(vehicle).max_acceleration_m_s2)};
                 },
                 [&](const PdRateConfig& c) -> StoppingLaw {
                   const QuadrotorConfig& model = quadrotor_for("pd_rate", vehicle);
                   return {place_poles(c, model).velocity_gain_1_s(),
                           tilt_acceleration_m_s2(model, vehicle.limits)};
                 },
                 [&](const PaperLiteralConfig& c) -> StoppingLaw {
                   return {c.horizontal_kp / c.horizontal_kd,
                           tilt_acceleration_m_s2(quadrotor_for("paper_literal", vehicle),
                                                  vehicle.limits)};
                 },
                 [&](const PositionTrajectoryConfig& c) -> StoppingLaw {
                   cart_for(vehicle);
                   return {c.point_gain_1_s, vehicle.limits.max_acceleration_m_s2};
                 }},
      config);
}

VelocityResponse velocity_response(const RegulatorConfig& config, const VehicleSpec& vehicle,
                                   double period_s) {
  const StoppingLaw law = stopping_law(config, vehicle);
  VelocityResponse response;
  response.period_s = period_s;
  response.k_1_s = law.k_1_s;
  response.a_max_m_s2 = law.a_m_s2;
  if (std::holds_alternative<PaperLiteralConfig>(config)) {
    throw std::invalid_argument("regulator 'paper_literal' is unstable: no stop can be promised");
  }
  if (is_wheeled(vehicle)) {
    throw std::invalid_argument("vehicle '" + vehicle.name +
                                "' cannot move sideways: no stop can be promised for its courses");
  }
  response.error_at_rest_m = kStopErrorAtRest_m;
  if (std::holds_alternative<IdealRegulatorConfig>(config)) {
    response.error_per_speed_s = kIdealStopError_s;
    return response;
  }
  response.error_at_rest_m = kTiltedStopErrorAtRest_m;
  const QuadrotorConfig& model = quadrotor_for("pd_rate", vehicle);
  const PdRateGains gains = place_poles(std::get<PdRateConfig>(config), model);
  const double hover_rad_s = model.hover_rotor_speed_rad_s();
  const double kappa =
      2 * model.thrust_factor_N_s2 * model.arm_m * hover_rad_s / model.inertia_kg_m2().x();
  const double room_rad_s = std::min(model.max_rotor_speed_rad_s - hover_rad_s,
                                     hover_rad_s - model.min_rotor_speed_rad_s);
  response.gravity_m_s2 = model.gravity_m_s2;
  response.gain_1_s2 = model.gravity_m_s2 * kappa * gains.kd;
  response.damping_1_s = kappa * gains.kq;
  response.push_max_m_s4 = model.gravity_m_s2 * kappa * 2 * room_rad_s;
  response.error_per_speed_s = model.inertia == QuadrotorConfig::InertiaSet::corrected
                                   ? kAgileStopError_s
                                   : kSluggishStopError_s;
  return response;
}

}  // namespace voronaut
