#pragma once

#include "voronaut/planners/navigation/command_ladder.h"

namespace voronaut {

// Scales of the velocity wanted.
class VelocityLadder : public CommandLadder {
 public:
  // What is commanded lies beyond the velocity wanted, v + kVelocityGain (wanted - v), so that the
  // vehicle gets there with a velocity loop kVelocityGain times as fast as its regulator's.
  static constexpr double kVelocityGain = 1.6;

  explicit VelocityLadder(const VelocityResponse& response) : response_(response) {}

  void set_up(const WantedMotion& wanted, const VehicleState& state) override;
  std::size_t top() const override;
  bool turns_aside() const override { return true; }
  void turn_aside(const Vec2& rotation) override;
  bool leads_on() const override { return true; }
  double speed_scale(std::size_t level) const override;
  MotionCommand command(std::size_t level) const override;
  PredictedStop predict(std::size_t level, double hold_s, double sample_s, std::vector<Vec2>& track,
                        std::vector<Vec2>* headings = nullptr) const override;
  void give(std::size_t level) override { v_before_ = v_command(level); }
  Vec2 p_world() const override { return now_.p_m; }
  double speed_m_s() const override { return now_.v_m_s.norm(); }
  double stray_m(const VehicleState& state) const override;

 private:
  Vec2 v_command(std::size_t level) const;

  VelocityResponse response_;
  Vec2 v_set_up_ = Vec2::Zero();
  Vec2 v_wanted_ = Vec2::Zero();  // turned aside
  PlanarMotion now_;
  Vec2 v_before_ = Vec2::Zero();
};

}  // namespace voronaut
