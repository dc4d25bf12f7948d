#include <memory>

#include <ompl/geometric/planners/experience/LightningRetrieveRepair.h>
#include <ompl/geometric/planners/experience/ThunderRetrieveRepair.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/tools/lightning/LightningDB.h>
#include <ompl/tools/thunder/SPARSdb.h>
#include <ompl/tools/thunder/ThunderDB.h>

#include "voronaut/planners/ompl/ompl_planners.h"

namespace voronaut {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

// OMPL's experience planners answer from a database of earlier paths, and who fills it is another's
// business: ompl::tools::Lightning and Thunder fill it from a second planner in a second thread.
// Here one thread recalls first, and what cannot be recalled is planned from scratch and
// remembered. A planner begins with an empty memory and keeps it over clear(): a flight recalls its
// own plans.
template <class Recall, class Memory>
class FromExperience : public Recall {
 public:
  explicit FromExperience(const ob::SpaceInformationPtr& si)
      : Recall(si, nullptr), memory_(si), scratch_(std::make_shared<og::RRTConnect>(si)) {
    memory_.serve(*this);
    this->params_.include(scratch_->params());
  }

  void clear() override {
    Recall::clear();
    scratch_->clear();
  }

  // What the last solve looked at.
  void getPlannerData(ob::PlannerData& data) const override {
    if (recalled_)
      memory_.tell(*this, data);
    else
      scratch_->getPlannerData(data);
  }

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition& condition) override {
    memory_.prepare(this->pdef_);
    recalled_ = has_start_and_goal();
    if (recalled_) {
      const ob::PlannerStatus recalled = Recall::solve(condition);
      if (Memory::kKeepsRecalled) remember(recalled);
      if (recalled == ob::PlannerStatus::EXACT_SOLUTION || condition) return recalled;
    }
    recalled_ = false;
    scratch_->clear();
    scratch_->setProblemDefinition(this->pdef_);
    const ob::PlannerStatus planned = scratch_->solve(condition);
    remember(planned);
    return planned;
  }

 private:
  // Recall takes them for granted.
  bool has_start_and_goal() {
    this->pis_.restart();
    return this->pis_.nextStart() != nullptr && this->pis_.nextGoal() != nullptr;
  }

  void remember(const ob::PlannerStatus& solved) const {
    if (solved != ob::PlannerStatus::EXACT_SOLUTION) return;
    double seconds = 0;
    memory_.database().addPath(*this->pdef_->getSolutionPath()->template as<og::PathGeometric>(),
                               seconds);
  }

  Memory memory_;
  ob::PlannerPtr scratch_;
  bool recalled_ = false;
};

// Whole paths, repaired ones too: the path whose ends are nearest is most often the last one.
class Paths {
 public:
  static constexpr bool kKeepsRecalled = true;

  explicit Paths(const ob::SpaceInformationPtr& si)
      : paths_(std::make_shared<ompl::tools::LightningDB>(si->getStateSpace())) {}

  void serve(og::LightningRetrieveRepair& planner) const { planner.setLightningDB(paths_); }
  void prepare(const ob::ProblemDefinitionPtr&) const {}
  void tell(const og::LightningRetrieveRepair& planner, ob::PlannerData& data) const {
    planner.LightningRetrieveRepair::getPlannerData(data);
  }
  ompl::tools::LightningDB& database() const { return *paths_; }

 private:
  ompl::tools::LightningDBPtr paths_;
};

// A sparse roadmap of all paths, in which SPARSdb orders new states by std::random_device; what is
// recalled is in it already. Spanner and visibility as ompl::tools::Thunder sets them.
class SparseRoadmap {
 public:
  static constexpr bool kKeepsRecalled = false;

  explicit SparseRoadmap(const ob::SpaceInformationPtr& si)
      : roadmap_(std::make_shared<og::SPARSdb>(si)),
        paths_(std::make_shared<ompl::tools::ThunderDB>(si->getStateSpace())) {
    roadmap_->setStretchFactor(1.2);
    roadmap_->setSparseDeltaFraction(0.05);
    paths_->setSPARSdb(roadmap_);
  }

  void serve(og::ThunderRetrieveRepair& planner) const {
    planner.setExperienceDB(paths_);
    planner.setName("ThunderRetrieveRepair");  // its class; OMPL writes Thunder_Retrieve_Repair
  }
  // What was free may be blocked now, and SPARSdb remembers what it checked until it is told.
  void prepare(const ob::ProblemDefinitionPtr& problem) const {
    roadmap_->setProblemDefinition(problem);
    if (!roadmap_->isSetup()) roadmap_->setup();
    roadmap_->clearEdgeCollisionStates();
  }
  // ThunderRetrieveRepair itself tells of states that it has freed by then.
  void tell(const og::ThunderRetrieveRepair&, ob::PlannerData& data) const {
    roadmap_->getPlannerData(data);
  }
  ompl::tools::ThunderDB& database() const { return *paths_; }

 private:
  ompl::tools::SPARSdbPtr roadmap_;
  ompl::tools::ThunderDBPtr paths_;
};

}  // namespace

std::vector<PlannerEntry> experience_planners() {
  return {
      ompl_entry<FromExperience<og::LightningRetrieveRepair, Paths>>(
          "LightningRetrieveRepair", "repairs a path it found before, else RRTConnect"),
      ompl_entry<FromExperience<og::ThunderRetrieveRepair, SparseRoadmap>>(
          "ThunderRetrieveRepair", "searches a roadmap of its earlier paths, else RRTConnect",
          Reproducible::no),
  };
}

}  // namespace voronaut
