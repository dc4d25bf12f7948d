#pragma once

#include <cstddef>
#include <memory>
#include <variant>
#include <vector>

#include "voronaut/dynamics/motion_response.h"
#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// What navigation wants of the vehicle until the next scan.
struct WantedMotion {
  Vec2 v_world = Vec2::Zero();  // [m/s]; zero: stay
  // The rest is for what drives along its heading.
  Vec2 heading_world = Vec2::UnitX();  // look there while staying (unit vector)
  double yaw_rate_rad_s = 0;           // feedforward for that
  double lookahead_m = 1;              // how far away the point is that v_world leads to
  bool may_reverse = false;            // backwards if that point lies behind
};

// What is predicted of one command: it is held until the next scan, then braked to rest.
struct PredictedStop {
  Vec2 v_command_world = Vec2::Zero();  // of the centre [m/s]
  double fastest_m_s = 0;               // now or commanded
  double stray_m = 0;                   // how far the stop may stray from its track
};

using MotionCommand = std::variant<VelocityCommand, ArcCommand>;

// One wish as commands of several speeds, from braking (level 0) to all that is wanted (the top
// level): what the safety governor picks from. A slower command sweeps less. Velocities for what
// moves in every direction, arcs for what drives along its heading.
class CommandLadder {
 public:
  virtual ~CommandLadder() = default;

  // From here on all is about this wish in this state.
  virtual void set_up(const WantedMotion& wanted, const VehicleState& state) = 0;
  virtual std::size_t top() const = 0;  // level; 0: nothing is wanted but to brake
  // Whether there is a course that can be turned. If so: from here on all is about the wish with
  // its course turned from what was set up, by an angle of which this is the cosine and the sine.
  virtual bool turns_aside() const { return false; }
  virtual void turn_aside(const Vec2& /*rotation*/) {}
  // False if all that is wanted is a turn on the spot before it leads anywhere.
  virtual bool leads_on() const = 0;
  // Of the levels after braking, so many turn on the spot. A body that is no disc may lack the room
  // for them where it has room for faster ones.
  virtual std::size_t turn_levels() const { return 0; }
  virtual double speed_scale(std::size_t level) const = 0;  // of the speed wanted
  virtual MotionCommand command(std::size_t level) const = 0;
  // Positions from now until rest into `track`, as motion_response.h predicts them for the level's
  // command after the one that was given before. `headings`, where the response predicts them: the
  // body's x axis at each.
  virtual PredictedStop predict(std::size_t level, double hold_s, double sample_s,
                                std::vector<Vec2>& track,
                                std::vector<Vec2>* headings = nullptr) const = 0;
  // This level's command is given.
  virtual void give(std::size_t level) = 0;

  virtual Vec2 p_world() const = 0;  // where the vehicle is
  virtual double speed_m_s() const = 0;
  // How far a stop from this state, at the speed it has, may stray from its track.
  virtual double stray_m(const VehicleState& state) const = 0;
};

// `turns_in_steps`: turns on the spot come slower as well, for a body that sweeps by turning.
std::unique_ptr<CommandLadder> ladder_of(const MotionResponse& response, bool turns_in_steps);

}  // namespace voronaut
