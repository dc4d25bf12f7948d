#pragma once

#include <deque>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/PathGeometric.h>

#include "voronaut/planners/known_geometry.h"
#include "voronaut/planners/planner_insight.h"
#include "voronaut/planners/reactive_voronoi/mission.h"
#include "voronaut/planners/reactive_voronoi/reactive_voronoi_config.h"

namespace voronaut {

// The planner of the papers (Finaev et al.; Soloviev et al.) as an OMPL planner for the plane.
//
// With a live belief behind the validity checker (KnownGeometry::belief()) a solve is one
// reactive_step: the path of two states is the next leg, an approximate solution unless it leads to
// the goal over known-clear ground. What it remembers is kept between solves; clear() forgets it.
//
// On a static problem a solve flies missions from each start to each goal until one arrives; the
// path is the way flown, longer than a planner's that sees everything. Stuck: an approximate
// solution up to the point closest to the goal. A further solve goes on where the last one was
// stopped. It is not complete and proves nothing.
//
// Parameters: "preset" (as_published, repaired) sets all fields of ReactiveVoronoiConfig; these and
// the fields of MissionConfig are parameters by their own names.
class ReactiveVoronoi : public ompl::base::Planner, public PlannerInsight {
 public:
  explicit ReactiveVoronoi(const ompl::base::SpaceInformationPtr& si);
  ~ReactiveVoronoi() override;

  using Planner::solve;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
  void setup() override;
  void clear() override;
  void getPlannerData(ompl::base::PlannerData& data) const override;

  std::string_view mode() const override { return to_string(mode_); }

  const ReactiveVoronoiConfig& config() const { return config_; }
  void set_config(const ReactiveVoronoiConfig& config) { config_ = config; }
  void set_preset(const std::string& name);  // throws std::invalid_argument
  std::string preset() const;                // empty if a field differs from both

 private:
  struct Attempt {
    std::size_t start = 0;
    std::size_t goal = 0;
    Mission mission;
  };

  ompl::base::PlannerStatus next_leg(const KnownGeometry& geometry,
                                     ompl::base::GoalSampleableRegion& goal);
  ompl::base::PlannerStatus fly_missions(const ompl::base::PlannerTerminationCondition& ptc);
  bool read_goals(const ompl::base::PlannerTerminationCondition& ptc);
  bool begin_attempt();
  ompl::base::PlannerStatus report(const Attempt& attempt);
  void free_states();

  ReactiveVoronoiConfig config_;
  MissionConfig mission_config_;
  ReactiveMemory memory_;
  ReactiveMode mode_ = ReactiveMode::none;
  std::vector<ompl::base::State*> starts_;
  std::vector<ompl::base::State*> goals_;
  std::deque<Attempt> attempts_;
  std::shared_ptr<ompl::geometric::PathGeometric> leg_;
};

}  // namespace voronaut
