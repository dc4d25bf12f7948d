#include "voronaut/dynamics/catalog.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace voronaut {
namespace {

// Of those without attitude.
constexpr double kNoTilt_rad = 0;

const std::vector<VehicleSpec>& vehicles() {
  static const std::vector<VehicleSpec> rows = {
      // F1TENTH's car of 0.58 x 0.31 m, at a walker's pace. The disc is about the middle of its
      // rear axle: 0.455 m to its front bumper, hypot(0.455, 0.155) = 0.48 m to the corners. Paths
      // that are pulled taut bend about known points at the clearance they keep: at 0.75 m, its
      // turning radius is 0.742 m, it can follow them.
      {.name = "car",
       .body_radius_m = 0.48,
       .planning_clearance_m = 0.75,
       .limits = {.max_acceleration_m_s2 = 3, .max_tilt_rad = kNoTilt_rad},
       .model = CarConfig{},
       .regulator = CarTrackerConfig::kName},
      // A cruise of 1.25 m/s makes the cart planner paper's mean of 1.19 m/s; the motors reach
      // 1.27. They could give 19 m/s^2; what the wheels' grip allows is ours to choose.
      {.name = "cart",
       .body_radius_m = 0.22,
       .planning_clearance_m = 0.26,
       .limits = {.max_speed_m_s = 1.25, .max_acceleration_m_s2 = 1, .max_tilt_rad = kNoTilt_rad},
       .model = CartConfig{},
       .regulator = PositionTrajectoryConfig::kName},
      {.name = "ideal",
       .planning_clearance_m = 0.29,
       .limits = {.max_acceleration_m_s2 = 3, .max_tilt_rad = kNoTilt_rad},
       .model = IdealConfig{},
       .regulator = IdealRegulatorConfig::kName},
      // Clearpath's Jackal as the BARN challenge simulates it (jackal/jackal: jackal_control's
      // control.yaml at 0aef021): 2 m/s, 20 m/s^2, 4 rad/s, 25 rad/s^2. Its controller takes the
      // track for 1.5 times its 0.37559 m because the wheels slip; here they do not, so that
      // cancels
      // out. The disc holds its hull of 0.458 x 0.416 m: 0.5 hypot(0.458, 0.416) = 0.309 m.
      {.name = "jackal",
       .body_radius_m = 0.31,
       .planning_clearance_m = 0.35,
       .limits = {.max_speed_m_s = 2,
                  .max_acceleration_m_s2 = 20,
                  .max_yaw_rate_rad_s = 4,
                  .max_tilt_rad = kNoTilt_rad},
       .model = UnicycleConfig{.max_speed_m_s = 2,
                               .max_acceleration_m_s2 = 20,
                               .max_yaw_rate_rad_s = 4,
                               .max_yaw_acceleration_rad_s2 = 25},
       .regulator = ArcTrackerConfig::kName},
      // Its rotors' hubs are at 0.24 m. Acceleration: g tan(20 deg).
      {.name = "quadrotor",
       .planning_clearance_m = 0.31,
       .limits = {.max_acceleration_m_s2 = 3.5706},
       .model = QuadrotorConfig{},
       .regulator = PdRateConfig::kName},
      // With propellers of 0.15 m radius.
      {.name = "quadrotor_props",
       .body_radius_m = 0.39,
       .planning_clearance_m = 0.5,
       .limits = {.max_acceleration_m_s2 = 3.5706},
       .model = QuadrotorConfig{},
       .regulator = PdRateConfig::kName},
      // As large and as fast as `ideal`: what is the wheels' doing.
      {.name = "unicycle",
       .planning_clearance_m = 0.29,
       .limits = {.max_acceleration_m_s2 = 3, .max_tilt_rad = kNoTilt_rad},
       .model = UnicycleConfig{},
       .regulator = ArcTrackerConfig::kName}};
  return rows;
}

// One config of every type, in the variant's order.
template <class... Configs>
std::vector<std::variant<Configs...>> defaults_of(std::variant<Configs...>*) {
  return {Configs{}...};
}

const std::vector<RegulatorConfig>& regulators() {
  static const auto rows = defaults_of(static_cast<RegulatorConfig*>(nullptr));
  return rows;
}

std::string name_of(const VehicleSpec& vehicle) { return vehicle.name; }

template <class... Configs>
std::string name_of(const std::variant<Configs...>& config) {
  return std::visit([](const auto& chosen) { return std::string(chosen.kName); }, config);
}

template <class Entry>
std::vector<std::string> names_of(const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  names.reserve(entries.size());
  for (const Entry& entry : entries) names.push_back(name_of(entry));
  std::sort(names.begin(), names.end());
  return names;
}

template <class Entry>
const Entry& found(const std::string& kind, const std::string& name,
                   const std::vector<Entry>& entries) {
  for (const Entry& entry : entries)
    if (name_of(entry) == name) return entry;
  std::string message = "unknown " + kind + " '" + name + "'; known:";
  for (const std::string& known : names_of(entries)) message += " " + known;
  throw std::invalid_argument(message);
}

template <class Config, class OfModel>
constexpr bool kDrives = std::is_constructible_v<typename Config::Law, const Config&,
                                                 const OfModel&, const MotionLimits&, double>;

template <class Config, class... OfModels>
std::string names_of_driven(const std::variant<OfModels...>&) {
  std::string names;
  ((kDrives<Config, OfModels> ? names += std::string(names.empty() ? "" : ", ") + OfModels::kName
                              : names),
   ...);
  return names;
}

// The bound on what a stop strays was flown up to there.
void require_known_period(const RegulatorConfig& config, double period_s) {
  if (period_s <= VelocityResponse::kLongestPeriod_s) return;
  throw std::invalid_argument("regulator '" + name_of(config) +
                              "' promises no stop at periods above 0.02 s");
}

}  // namespace

double VehicleSpec::planned_radius_m() const {
  return footprint.planned_radius_m > 0 ? footprint.planned_radius_m : body_radius_m;
}

double VehicleSpec::inscribed_radius_m() const {
  return footprint.is_disc() ? body_radius_m : voronaut::inscribed_radius_m(footprint.corners_body);
}

std::vector<std::string> vehicle_names() { return names_of(vehicles()); }

std::vector<std::string> regulator_names() { return names_of(regulators()); }

VehicleSpec find_vehicle(const std::string& name) { return found("vehicle", name, vehicles()); }

RegulatorConfig find_regulator(const std::string& name) {
  return found("regulator", name, regulators());
}

std::unique_ptr<Model> make_model(const ModelConfig& config) {
  return std::visit(
      [](const auto& chosen) -> std::unique_ptr<Model> {
        return std::make_unique<typename std::decay_t<decltype(chosen)>::Body>(chosen);
      },
      config);
}

Mobility mobility_of(const VehicleSpec& vehicle) { return make_model(vehicle.model)->mobility(); }

std::unique_ptr<Regulator> make_regulator(const RegulatorConfig& config, const VehicleSpec& vehicle,
                                          double period_s) {
  const auto made = [&]<class Config, class OfModel>(
                        const Config& law, const OfModel& model) -> std::unique_ptr<Regulator> {
    if constexpr (kDrives<Config, OfModel>) {
      return std::make_unique<typename Config::Law>(law, model, vehicle.limits, period_s);
    } else {
      throw std::invalid_argument("regulator '" + std::string(Config::kName) +
                                  "' drives the model " + names_of_driven<Config>(vehicle.model) +
                                  ", which vehicle '" + vehicle.name + "' is not");
    }
  };
  return std::visit(made, config, vehicle.model);
}

StoppingLaw stopping_law(const RegulatorConfig& config, const VehicleSpec& vehicle) {
  constexpr double kAnyPeriod_s = 0.01;  // no law of stopping depends on it
  return make_regulator(config, vehicle, kAnyPeriod_s)->stopping_law();
}

MotionResponse motion_response(const RegulatorConfig& config, const VehicleSpec& vehicle,
                               double period_s) {
  MotionResponse response = make_regulator(config, vehicle, period_s)->motion_response();
  if (std::holds_alternative<VelocityResponse>(response)) require_known_period(config, period_s);
  return response;
}

VelocityResponse velocity_response(const RegulatorConfig& config, const VehicleSpec& vehicle,
                                   double period_s) {
  const VelocityResponse response = make_regulator(config, vehicle, period_s)->velocity_response();
  require_known_period(config, period_s);
  return response;
}

}  // namespace voronaut
