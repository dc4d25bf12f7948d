#include <cstdlib>
#include <stdexcept>
#include <vector>

#include <ompl/base/Planner.h>
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
}
