#include <algorithm>
#include <cmath>

#include "voronaut/planners/problem/planar_state.h"
#include "voronaut/planners/voronoi/boundary_sampling.h"
#include "voronaut/planners/voronoi/voronoi_roadmap.h"

// VoronoiRoadmap where nothing but a validity check is given.
namespace voronaut {

namespace ob = ompl::base;

namespace {

constexpr int kMaxRepairs = 64;
constexpr const char* kNotSampled = "no path was found on the sampled border of the valid states";

}  // namespace

ob::PlannerStatus VoronoiRoadmap::solve_by_sampling(const ob::PlannerTerminationCondition& ptc) {
  const Bounds bounds = position_bounds(*si_->getStateSpace());
  ob::State* probe = si_->cloneState(starts_.front());
  const auto is_valid = [&](const Vec2& p) {
    set_position(*si_->getStateSpace(), probe, p);
    return si_->isValid(probe);
  };
  ob::PlannerStatus status = ob::PlannerStatus::UNKNOWN;
  for (int cells = config_.boundary_cells; status == ob::PlannerStatus::UNKNOWN; cells *= 2) {
    BoundarySamples border = sample_boundary(is_valid, bounds, cells, [&ptc] { return ptc(); });
    status = solve_on_border(border.points, border.clearance_m, bounds, ptc);
    if (status) break;
    if (ptc())
      status = failure(kTimeout, false, ob::PlannerStatus::TIMEOUT);
    else if (2 * cells > config_.boundary_cells_max)
      status = failure(kNotSampled, false, ob::PlannerStatus::TIMEOUT);
  }
  si_->freeState(probe);
  return status;
}

ob::PlannerStatus VoronoiRoadmap::solve_on_border(std::vector<Vec2>& border, double clearance_m,
                                                  const Bounds& bounds,
                                                  const ob::PlannerTerminationCondition& ptc) {
  for (const ob::State* start : starts_) {
    for (const ob::State* goal : goals_) {
      if (ptc()) return ob::PlannerStatus::UNKNOWN;
      const Question question{start, goal, 0};
      const Route route = ask_and_repair(question, bounds, clearance_m, border, ptc);
      if (!route.points.empty()) return report(question, route);
    }
  }
  return ob::PlannerStatus::UNKNOWN;
}

// Where the validity check refuses a route, it has found an obstacle that the grid has missed: the
// place becomes a point, and the route is asked for again.
Route VoronoiRoadmap::ask_and_repair(const Question& question, const Bounds& bounds,
                                     double clearance_m, std::vector<Vec2>& points,
                                     const ob::PlannerTerminationCondition& ptc) {
  const MotionCheck motion_is_clear = [&](const Vec2& a, const Vec2& b) {
    return is_valid_motion(question.start, a, b);
  };
  const std::vector<Vec2> places{position(question.start), position(question.goal)};
  for (int repair = 0; repair < kMaxRepairs && !ptc(); ++repair) {
    router_.observe(points, bounds, clearance_m, places);
    Route route = ask(question, bounds, motion_is_clear, config_.shortening);
    if (route.verdict != Route::Verdict::found) return {};
    const std::vector<Vec2> refused = invalid_places(question.start, route.points);
    if (refused.empty()) return route;
    points.insert(points.end(), refused.begin(), refused.end());
  }
  return {};
}

// The first place of each piece that is not valid.
std::vector<Vec2> VoronoiRoadmap::invalid_places(const ob::State* like,
                                                 const std::vector<Vec2>& path) const {
  const double step = si_->getStateSpace()->getLongestValidSegmentLength();
  ob::State* probe = si_->cloneState(like);
  std::vector<Vec2> places;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (is_valid_motion(like, path[i - 1], path[i])) continue;
    const Vec2 along = path[i] - path[i - 1];
    const int steps = std::max(1, static_cast<int>(std::ceil(along.norm() / step)));
    Vec2 place = 0.5 * (path[i - 1] + path[i]);
    for (int k = 0; k <= steps; ++k) {
      const Vec2 p = path[i - 1] + along * k / steps;
      set_position(*si_->getStateSpace(), probe, p);
      if (si_->isValid(probe)) continue;
      place = p;
      break;
    }
    places.push_back(place);
  }
  si_->freeState(probe);
  return places;
}

}  // namespace voronaut
