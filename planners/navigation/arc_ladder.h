#pragma once

#include <span>

#include "voronaut/planners/navigation/command_ladder.h"

namespace voronaut {

// Scales of the arc that leads to the point wanted (arc_steering.h), speed and yaw rate together so
// that its curvature stays. Level 1 is to brake and turn on the spot meanwhile: a disc that turns
// sweeps nothing; what is no disc has slower turns, too. What cannot be driven at a fair speed in a
// direction well off the heading is turned to first: so a vehicle in a narrow place leaves it along
// a straight line.
class ArcLadder : public CommandLadder {
 public:
  explicit ArcLadder(const DriveResponse& response, bool turns_in_steps = false);

  void set_up(const WantedMotion& wanted, const VehicleState& state) override;
  std::size_t top() const override;
  bool leads_on() const override { return full_.v_m_s != 0; }
  std::size_t turn_levels() const override { return turn_scales_.size(); }
  double speed_scale(std::size_t level) const override;
  MotionCommand command(std::size_t level) const override { return arc(level); }
  PredictedStop predict(std::size_t level, double hold_s, double sample_s, std::vector<Vec2>& track,
                        std::vector<Vec2>* headings = nullptr) const override;
  void give(std::size_t level) override { before_ = arc(level); }
  Vec2 p_world() const override { return now_.p_m; }
  double speed_m_s() const override;
  double stray_m(const VehicleState& state) const override;

 private:
  ArcCommand arc_ahead(const Vec2& way_m, double speed_m_s) const;
  ArcCommand arc(std::size_t level) const;

  DriveResponse response_;
  DriveMotion now_;
  ArcCommand full_;                      // all that is wanted
  ArcCommand turn_;                      // the part of it that is a turn on the spot
  std::span<const double> turn_scales_;  // of turn_, from level 1 on
  std::span<const double> scales_;       // of full_, after them
  ArcCommand before_;
};

}  // namespace voronaut
