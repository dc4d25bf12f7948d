#pragma once

#include <atomic>
#include <string_view>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/base/goals/GoalSampleableRegion.h>

#include "voronaut/planners/catalog/planner_insight.h"
#include "voronaut/planners/problem/known_geometry.h"
#include "voronaut/planners/voronoi/voronoi_router.h"

namespace voronaut {

struct VoronoiRoadmapConfig {
  Shortening shortening = Shortening::channel;
  // Without exact geometry the border of the valid states is sampled on a grid with this many cells
  // along the longer side of the bounds, refined by doubling up to the second number.
  int boundary_cells = 64;
  int boundary_cells_max = 512;
  int goals_max = 16;

  template <class Visitor>
  void visit(Visitor& v) {
    v.choice("shortening", shortening,
             {{"none", Shortening::none},
              {"shortcut", Shortening::shortcut},
              {"channel", Shortening::channel}},
             "How routes along the diagram are made short: not, by cutting corners, or in the dual "
             "triangulation");
    v.count("boundary_cells", boundary_cells, 4, 4096,
            "Without exact geometry: cells along the bounds' longer side, to sample the border of "
            "the valid states");
    v.count("boundary_cells_max", boundary_cells_max, 4, 4096,
            "Up to which boundary_cells is refined by doubling");
    v.count("goals_max", goals_max, 1, 1000,
            "Goals drawn from a goal region that has more than one");
  }
};

// Snapshot planner on the Voronoi diagram of the known points (voronoi_graph.h), its routes made
// short in the dual triangulation (channel_search.h). For the plane, or SE(2) with a round robot.
//
// With a validity checker that offers KnownGeometry it is complete at the checker's clearance: a
// solve without a path is a proof that there is none (proved_no_path(), with a reason), except when
// the start is so close to an obstacle that its clearance is relaxed and nothing can be said. The
// status is then what OMPL offers for it: INFEASIBLE where it knows that word (since 1.6), TIMEOUT
// in 1.5, INVALID_GOAL if no goal state is valid. With any other checker the border of the valid
// states is sampled through isValid(): complete for passages much wider than a cell only, and
// nothing is proved.
//
// The diagram is kept between solves and through clear(), as a cache: it depends on the points
// alone and is used again only for points that continue those it was made of, so no result depends
// on what was solved before. clear() forgets everything else.
class VoronoiRoadmap : public ompl::base::Planner, public PlannerInsight {
 public:
  explicit VoronoiRoadmap(const ompl::base::SpaceInformationPtr& si);
  ~VoronoiRoadmap() override;

  using Planner::solve;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
  void setup() override;  // throws ompl::Exception if the space has no position in the plane
  void clear() override;
  void clearQuery() override;
  // The whole roadmap, edges weighted by length in both directions, and the latest solution as a
  // chain of vertices with tag 1 from a start to a goal vertex.
  void getPlannerData(ompl::base::PlannerData& data) const override;

  bool proved_no_path() const override { return proved_no_path_; }
  // Why the latest solve found no path, in words; empty if it found one.
  std::string_view failure_reason() const { return failure_reason_; }

 private:
  // Any place within tolerance_m of the goal state will do if the state itself cannot be reached.
  struct Question {
    const ompl::base::State* start;
    const ompl::base::State* goal;
    double tolerance_m;
  };

  const KnownGeometry* geometry() const;
  void read_starts();
  // All goals of a problem, or as many as goals_max; false if there are more than were read.
  bool read_goals(const ompl::base::GoalSampleableRegion& goal,
                  const ompl::base::PlannerTerminationCondition& ptc, bool exact);
  double tolerance_m() const;
  ompl::base::PlannerStatus solve_exactly(const KnownGeometry& known, bool all_goals,
                                          const ompl::base::PlannerTerminationCondition& ptc);
  ompl::base::PlannerStatus solve_by_sampling(const ompl::base::PlannerTerminationCondition& ptc);
  Route ask(const Question& question, const Bounds& bounds, const MotionCheck& motion_is_clear,
            Shortening shortening);
  // The same without shortening where the validator refuses the short one.
  Route ask_twice(const Question& question, const Bounds& bounds,
                  const MotionCheck& motion_is_clear);
  ompl::base::PlannerStatus solve_on_border(std::vector<Vec2>& border, double clearance_m,
                                            const Bounds& bounds,
                                            const ompl::base::PlannerTerminationCondition& ptc);
  Route ask_and_repair(const Question& question, const Bounds& bounds, double clearance_m,
                       std::vector<Vec2>& points,
                       const ompl::base::PlannerTerminationCondition& ptc);
  static constexpr const char* kTimeout = "the termination condition was met first";
  ompl::base::PlannerStatus failure(std::string_view why, bool proved,
                                    ompl::base::PlannerStatus::StatusType otherwise);
  ompl::base::PlannerStatus report(const Question& question, const Route& route);
  Vec2 position(const ompl::base::State* state) const;
  std::vector<Vec2> starts_and_goals() const;
  bool any_valid_goal() const;
  bool is_valid_motion(const ompl::base::State* like, const Vec2& a, const Vec2& b) const;
  bool is_valid_path(const ompl::base::State* like, const std::vector<Vec2>& path) const;
  std::vector<Vec2> invalid_places(const ompl::base::State* like,
                                   const std::vector<Vec2>& path) const;
  void free_states(std::vector<ompl::base::State*>& states) const;
  void forget_query();

  VoronoiRoadmapConfig config_;
  mutable VoronoiRouter router_;  // getPlannerData() may have to bring its graph up to date
  std::vector<ompl::base::State*> starts_;
  std::vector<ompl::base::State*> goals_;
  std::vector<Vec2> solution_;
  mutable std::vector<ompl::base::State*> data_states_;
  bool proved_no_path_ = false;
  std::string_view failure_reason_;
  std::atomic<std::size_t> vertex_count_{0};
  std::atomic<std::size_t> edge_count_{0};
  std::atomic<double> best_cost_;
};

}  // namespace voronaut
