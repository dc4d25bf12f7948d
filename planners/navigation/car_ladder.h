#pragma once

#include "voronaut/planners/navigation/command_ladder.h"

namespace voronaut {

// For what cannot turn on the spot: scales of the arc that leads to the point wanted, as tight as
// the steering allows. Where that does not get it there, it backs up at full lock the other way,
// which turns it to the same side (a turn in three, five ... parts): when the point lies within a
// turning circle, or the way ahead is not free. It goes ahead again when the point lies ahead, when
// it has backed up by a turning radius, or when the way back is not free either.
class CarLadder : public CommandLadder {
 public:
  explicit CarLadder(const CarResponse& response) : response_(response) {}

  void set_up(const WantedMotion& wanted, const VehicleState& state) override;
  std::size_t top() const override;
  bool leads_on() const override { return true; }
  double speed_scale(std::size_t level) const override;
  MotionCommand command(std::size_t level) const override { return arc(level); }
  PredictedStop predict(std::size_t level, double hold_s, double sample_s, std::vector<Vec2>& track,
                        std::vector<Vec2>* headings = nullptr) const override;
  void give(std::size_t level) override;
  Vec2 p_world() const override { return now_.p_m; }
  double speed_m_s() const override;
  double stray_m(const VehicleState& state) const override;

 private:
  bool backs_up(const Vec2& way_m);
  ArcCommand back_up(const Vec2& way_m, double speed_m_s) const;
  ArcCommand arc(std::size_t level) const;

  CarResponse response_;
  CarMotion now_;
  ArcCommand full_;  // all that is wanted
  ArcCommand before_;
  bool held_back_ = false;  // by the governor, at the call before
  bool backing_ = false;
  Vec2 changed_at_ = Vec2::Constant(1e9);  // where it last changed between ahead and back
};

}  // namespace voronaut
