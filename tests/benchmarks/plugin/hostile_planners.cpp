#include <cstdlib>
#include <stdexcept>
#include <vector>

#include <ompl/base/Planner.h>

#include "voronaut/planners/catalog/plugin.h"

// Planners that do what planners under development do.
namespace {

namespace ob = ompl::base;

using Deed = void (*)();

class Hostile : public ob::Planner {
 public:
  Hostile(const ob::SpaceInformationPtr& si, Deed deed) : Planner(si, "Hostile"), deed_(deed) {}

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition&) override {
    deed_();
    return ob::PlannerStatus::TIMEOUT;
  }

 private:
  Deed deed_;
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
  planners.add({"StillBorn", "aborts when made", {}, [](const ob::SpaceInformationPtr& si) {
                  abort_all();
                  return std::make_shared<Hostile>(si, loop);
                }});
}
