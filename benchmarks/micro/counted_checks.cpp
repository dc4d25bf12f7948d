#include <utility>
#include <vector>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "voronaut/benchmarks/micro/counted_work.h"
#include "voronaut/benchmarks/micro/workload.h"
#include "voronaut/environments/random.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/problem/belief_validity_checker.h"
#include "voronaut/planners/problem/fcl_validity_checker.h"
#include "voronaut/planners/problem/planar_state.h"
#include "voronaut/planners/problem/swept_disc_motion_validator.h"

namespace voronaut::micro {
namespace {

namespace ob = ompl::base;

constexpr double kRadiusM = 0.3;
constexpr double kHalfCorridorM = 6;
constexpr double kMotionM = 2;

ObstacleBase known_forest(std::size_t scans) {
  ObstacleBase base{ObstacleBaseConfig{}};
  ForestWalk walk({.scans = scans});
  for (std::size_t i = 0; i < scans; ++i) base.update(walk.next());
  return base;
}

std::vector<Segment> random_motions(std::size_t scans, std::size_t count) {
  Random random(5);
  const double length_m = 0.18 * static_cast<double>(scans);
  std::vector<Segment> motions;
  while (motions.size() < count) {
    const Vec2 a{random.uniform(0, length_m), random.uniform(-kHalfCorridorM, kHalfCorridorM)};
    const Vec2 way{random.normal(), random.normal()};
    motions.push_back({a, a + kMotionM * way / way.norm()});
  }
  return motions;
}

class SnapshotCheckWork : public CountedWork {
 public:
  SnapshotCheckWork(Check what, std::size_t scans)
      : what_(what), base_(known_forest(scans)), motions_(random_motions(scans, kChecks)) {
    base_.snapshot().expect_checks(kRadiusM);
  }
  bool prepare() override { return !std::exchange(done_, true); }
  std::size_t run() override {
    const ObstacleSnapshot known = base_.snapshot();
    std::size_t clear = 0;
    if (what_ == Check::motion) {
      for (const Segment& m : motions_) clear += known.swept_disc_is_clear(m.a, m.b, kRadiusM);
    } else {
      for (const Segment& m : motions_) clear += known.disc_is_clear(m.a, kRadiusM);
    }
    clear_ = clear;
    return motions_.size();
  }

 private:
  static constexpr std::size_t kChecks = 20'000;
  Check what_;
  bool done_ = false;
  ObstacleBase base_;
  std::vector<Segment> motions_;
  std::size_t clear_ = 0;
};

template <class OmplChecker>
class OmplCheckWork : public CountedWork {
 public:
  OmplCheckWork(Check what, std::size_t scans, std::size_t checks)
      : what_(what), base_(known_forest(scans)), si_(space_information()) {
    const auto checker = std::make_shared<OmplChecker>(si_, kRadiusM);
    checker->look_at(base_.snapshot(), Vec2(-50, 0));  // far from everything: nothing is relaxed
    si_->setStateValidityChecker(checker);
    si_->setMotionValidator(std::make_shared<SweptDiscMotionValidator>(si_, *checker));
    si_->setup();
    for (const Segment& motion : random_motions(scans, checks)) {
      for (const Vec2& p : {motion.a, motion.b}) {
        states_.push_back(si_->allocState());
        set_position(*si_->getStateSpace(), states_.back(), p);
      }
    }
  }
  OmplCheckWork(const OmplCheckWork&) = delete;
  OmplCheckWork& operator=(const OmplCheckWork&) = delete;
  ~OmplCheckWork() override { si_->freeStates(states_); }

  bool prepare() override { return !std::exchange(done_, true); }
  std::size_t run() override {
    for (std::size_t i = 0; i < states_.size(); i += 2) {
      clear_ += what_ == Check::motion ? si_->checkMotion(states_[i], states_[i + 1])
                                       : si_->isValid(states_[i]);
    }
    return states_.size() / 2;
  }

 private:
  static ob::SpaceInformationPtr space_information() {
    auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
    plane->setBounds(-1e4, 1e4);
    return std::make_shared<ob::SpaceInformation>(plane);
  }

  Check what_;
  bool done_ = false;
  ObstacleBase base_;
  ob::SpaceInformationPtr si_;
  std::vector<ob::State*> states_;
  std::size_t clear_ = 0;
};

class ExpectingChecksWork : public CountedWork {
 public:
  bool prepare() override {
    if (done_++ == kUpdates) return false;
    do {
      base_.update(walk_.next());
    } while (base_.report().points_added == 0);
    return true;
  }
  std::size_t run() override {
    base_.snapshot().expect_checks(kRadiusM);
    return base_.report().points_added;
  }

 private:
  static constexpr std::size_t kUpdates = 500;
  ForestWalk walk_{{.scans = 4 * kUpdates}};
  ObstacleBase base_{ObstacleBaseConfig{}};
  std::size_t done_ = 0;
};

}  // namespace

CountedWorkPtr check_work(Checker checker, Check what, std::size_t scans) {
  switch (checker) {
    case Checker::ompl_own:
      return std::make_unique<OmplCheckWork<BeliefValidityChecker>>(what, scans, 20'000);
    case Checker::ompl_fcl:
      return std::make_unique<OmplCheckWork<FclValidityChecker>>(what, scans, 2'000);
    case Checker::snapshot:
      break;
  }
  return std::make_unique<SnapshotCheckWork>(what, scans);
}

CountedWorkPtr expecting_checks_work() { return std::make_unique<ExpectingChecksWork>(); }

}  // namespace voronaut::micro
