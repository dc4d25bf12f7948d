#pragma once

#include <memory>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>

#include "voronaut/planners/rollout/rollout.h"

namespace voronaut {

// The part of OMPL's contract that is the same for every planner that rolls out its motion: from
// each start to each goal, in the order in which they came, until one arrives. The solution is the
// path rolled out; where none arrives, an approximate solution. A further solve goes on where the
// last one was stopped, and takes new starts and goals in. Nothing is proved.
class RolloutPlanner : public ompl::base::Planner {
 public:
  RolloutPlanner(const ompl::base::SpaceInformationPtr& si, const std::string& name);
  ~RolloutPlanner() override;

  using Planner::solve;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
  void setup() override;  // throws ompl::Exception if the space has no position in the plane
  void clear() override;
  void getPlannerData(ompl::base::PlannerData& data) const override;

 protected:
  virtual std::unique_ptr<Rollout> make_rollout(const ompl::base::State* start,
                                                const ompl::base::State* goal) = 0;

  // Index of the state at which the path of a rollout that has not arrived ends: by default the one
  // closest to the goal. 0 is no path at all.
  virtual std::size_t end_of_approximation(const Rollout& rollout) const;

  // The one under way or the last that was, null before the first.
  const Rollout* latest() const {
    return attempts_.empty() ? nullptr : attempts_.back().rollout.get();
  }
  void forget_rollouts();

 private:
  struct Attempt {
    std::size_t start = 0;
    std::size_t goal = 0;
    std::unique_ptr<Rollout> rollout;
  };

  bool read_goals(const ompl::base::PlannerTerminationCondition& ptc);
  bool begin_attempt();
  ompl::base::PlannerStatus report() const;

  std::vector<ompl::base::State*> starts_;
  std::vector<ompl::base::State*> goals_;
  std::vector<Attempt> attempts_;
};

// Adds the states of a path as a chain that begins at a start. They must outlive the data.
void add_chain(const ompl::geometric::PathGeometric& path, ompl::base::PlannerData& data);

}  // namespace voronaut
