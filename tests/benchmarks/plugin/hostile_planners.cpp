#include <array>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/Planner.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <signal.h>
#include <unistd.h>

#include "voronaut/planners/catalog/plugin.h"

// Planners that do what planners under development do.
namespace {

namespace ob = ompl::base;

using Deed = void (*)();

class Hostile : public ob::Planner {
 public:
  Hostile(const ob::SpaceInformationPtr& si, Deed deed) : Planner(si, "Hostile"), deed_(deed) {
    declareParam<unsigned>("fuse", this, &Hostile::light, &Hostile::fuse);
  }

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition&) override {
    deed_();
    return ob::PlannerStatus::TIMEOUT;
  }

 private:
  void light(unsigned fuse) {
    if (fuse > 0) std::abort();
  }
  unsigned fuse() const { return 0; }

  Deed deed_;
};

// Says that it has a path, and has none.
class Boastful : public ob::Planner {
 public:
  explicit Boastful(const ob::SpaceInformationPtr& si) : Planner(si, "Boastful") {}

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition&) override {
    return ob::PlannerStatus::EXACT_SOLUTION;
  }
};

// Says that its path reaches the goal, and stays where it starts.
class Homebody : public ob::Planner {
 public:
  explicit Homebody(const ob::SpaceInformationPtr& si) : Planner(si, "Homebody") {}

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition&) override {
    const auto path = std::make_shared<ompl::geometric::PathGeometric>(si_);
    path->append(pdef_->getStartState(0));
    path->append(pdef_->getStartState(0));
    pdef_->addSolutionPath(path);
    return ob::PlannerStatus::EXACT_SOLUTION;
  }
};

// Adds a path through these places and says that it is a solution; before, it does something to the
// problem that it was given.
class Forger : public ob::Planner {
 public:
  using Places = std::vector<std::array<double, 2>>;
  using Tamper = void (*)(ob::ProblemDefinition&);

  Forger(const ob::SpaceInformationPtr& si, Places places, Tamper tamper)
      : Planner(si, "Forger"), places_(std::move(places)), tamper_(tamper) {}

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition&) override {
    tamper_(*pdef_);
    const auto path = std::make_shared<ompl::geometric::PathGeometric>(si_);
    for (const auto& [x, y] : places_) {
      ob::ScopedState<ob::RealVectorStateSpace> state(si_);
      state[0] = x;
      state[1] = y;
      path->append(state.get());
    }
    pdef_->addSolutionPath(path);
    return ob::PlannerStatus::EXACT_SOLUTION;
  }
  // What a replay would show, and only where traces are kept.
  void getPlannerData(ob::PlannerData& data) const override {
    Planner::getPlannerData(data);
    throw std::runtime_error("looks bad in pictures");
  }

 private:
  Places places_;
  Tamper tamper_;
};

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

void leave_alone(ob::ProblemDefinition&) {}
void widen_goal(ob::ProblemDefinition& problem) {
  problem.getGoal()->as<ob::GoalState>()->setThreshold(1e9);
}
void move_goal_to_start(ob::ProblemDefinition& problem) {
  problem.getGoal()->as<ob::GoalState>()->setState(problem.getStartState(0));
}
void replace_goal(ob::ProblemDefinition& problem) {
  // A copy: setting states frees those that were there.
  const ob::ScopedState<> start(problem.getSpaceInformation()->getStateSpace(),
                                problem.getStartState(0));
  problem.setStartAndGoalStates(start, start, 1e9);
}
void move_start(ob::ProblemDefinition& problem) {
  auto* start = problem.getStartState(0)->as<ob::RealVectorStateSpace::StateType>();
  start->values[0] = 1.9;
  start->values[1] = 1;
}
// All is free and within bounds for who has such a checker.
void allow_everything(ob::ProblemDefinition& problem) {
  const auto si = problem.getSpaceInformation();
  si->setStateValidityChecker(std::make_shared<ob::AllValidStateValidityChecker>(si));
  si->setMotionValidator(std::make_shared<ob::DiscreteMotionValidator>(si));
}

void throw_up() { throw std::runtime_error("no idea how to go on"); }
void abort_all() { std::abort(); }
void loop() {
  static volatile bool for_ever = true;
  while (for_ever) {
  }
}
// Each block is touched, so that it counts.
void leak() {
  static std::vector<std::vector<char>> kept;
  while (true) kept.emplace_back(1 << 20, 'x');
}

// The accident: a number that it believes to be its own.
void write_to_three() {
  for (int fd = 3; fd < 20; ++fd) static_cast<void>(!write(fd, "planner: solving\n", 17));
}
void unlink_database() {
  unlink("attacked/results.db");
  unlink("results.db");
}
void kill_parent() { kill(getppid(), SIGKILL); }

template <class Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr& si) {
  return std::make_shared<Planner>(si);
}

void add(voronaut::PlannerCatalog& planners, const char* name, const Forger::Places& places,
         Forger::Tamper tamper = leave_alone) {
  planners.add({name, "forges", {}, [places, tamper](const ob::SpaceInformationPtr& si) {
                  return std::make_shared<Forger>(si, places, tamper);
                }});
}

// From (0, 0) to (2, 1) by way of what is no place, or into what is in the way, or not at all.
void add_forgers(voronaut::PlannerCatalog& planners) {
  add(planners, "NoNumberFirst", {{kNoNumber, kNoNumber}, {2, 1}});
  add(planners, "NoNumberOnTheWay", {{0, 0}, {kNoNumber, kNoNumber}, {2, 1}});
  add(planners, "NoNumberInOneAxis", {{0, 0}, {1, kNoNumber}, {2, 1}});
  add(planners, "NoNumberLast", {{0, 0}, {2, kNoNumber}});
  add(planners, "InfiniteOnTheWay", {{0, 0}, {kInfinite, 0}, {2, 1}});
  add(planners, "FarAway", {{0, 0}, {1e300, 0}, {2, 1}});
  add(planners, "OutOfBounds", {{0, 0}, {4e8, 0}, {2, 1}});
  add(planners, "Straight", {{0, 0}, {2, 1}});
  add(planners, "StraightIfAllowed", {{0, 0}, {2, 1}}, allow_everything);
  add(planners, "GoalIsEverywhere", {{0, 0}, {0, 0.1}}, widen_goal);
  add(planners, "GoalIsStart", {{0, 0}, {0, 0.1}}, move_goal_to_start);
  add(planners, "GoalIsAnother", {{0, 0}, {0, 0.1}}, replace_goal);
  add(planners, "StartIsGoal", {{1.9, 1}, {2, 1}}, move_start);
}

void add(voronaut::PlannerCatalog& planners, const char* name, Deed deed) {
  planners.add({name, "hostile", {}, [deed](const ob::SpaceInformationPtr& si) {
                  return std::make_shared<Hostile>(si, deed);
                }});
}

}  // namespace

VORONAUT_PLUGIN(planners) {
  add(planners, "Throws", throw_up);
  add(planners, "Aborts", abort_all);
  add(planners, "Loops", loop);
  add(planners, "Leaks", leak);
  add(planners, "WritesToThree", write_to_three);
  add(planners, "UnlinksDatabase", unlink_database);
  add(planners, "KillsParent", kill_parent);
  planners.add({"StillBorn", "aborts when made", {}, [](const ob::SpaceInformationPtr& si) {
                  abort_all();
                  return std::make_shared<Hostile>(si, loop);
                }});
  planners.add({"Boastful", "claims a path that it has not", {}, make<Boastful>});
  planners.add({"Homebody", "claims to be at the goal", {}, make<Homebody>});
  add_forgers(planners);
}
