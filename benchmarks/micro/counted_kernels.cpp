#include "voronaut/benchmarks/micro/counted_kernels.h"

#include <utility>

#include "voronaut/benchmarks/micro/governed_cycle.h"
#include "voronaut/benchmarks/micro/workload.h"
#include "voronaut/environments/random.h"
#include "voronaut/planners/mapping/obstacle_base.h"

extern "C" [[gnu::noinline]] std::size_t voronaut_counted(voronaut::micro::CountedWork& work) {
  return work.run();
}

namespace voronaut::micro {
namespace {

// One update per run, of the same 1000 scans whatever is known: scans of other ground before, and
// (`again`) these scans themselves.
class MappingWork : public CountedWork {
 public:
  MappingWork(std::size_t rays, std::size_t known_scans, bool again)
      : walk_({.rays = rays, .scans = kScans}) {
    ForestWalk elsewhere(
        {.rays = rays, .scans = known_scans, .seed = 2, .aside_m = kOtherGroundAsideM});
    for (std::size_t i = 0; i < known_scans; ++i) base_.update(elsewhere.next());
    if (!again) return;
    ForestWalk before({.rays = rays, .scans = kScans});
    for (std::size_t i = 0; i < kScans; ++i) base_.update(before.next());
  }
  bool prepare() override {
    if (done_++ == kScans) return false;
    scan_ = walk_.next();
    return true;
  }
  std::size_t run() override {
    base_.update(scan_);
    return 1;
  }

 private:
  static constexpr std::size_t kScans = 1000;
  static constexpr double kOtherGroundAsideM = 100;
  ForestWalk walk_;
  ObstacleBase base_{ObstacleBaseConfig{}};
  Scan scan_;
  std::size_t done_ = 0;
};

// Checks of a disc of 0.3 m at places in the corridor, or swept along 2 m from there.
class CheckWork : public CountedWork {
 public:
  CheckWork(std::size_t scans, bool motion) : motion_(motion) {
    ForestWalk walk({.scans = scans});
    for (std::size_t i = 0; i < scans; ++i) base_.update(walk.next());
    base_.snapshot().expect_checks(kRadiusM);
    Random random(5);
    const double length_m = 0.18 * static_cast<double>(scans);
    while (motions_.size() < kChecks) {
      const Vec2 a{random.uniform(0, length_m), random.uniform(-6, 6)};
      const Vec2 way{random.normal(), random.normal()};
      motions_.push_back({a, a + 2 * way / way.norm()});
    }
  }
  bool prepare() override { return !std::exchange(done_, true); }
  std::size_t run() override {
    const ObstacleSnapshot known = base_.snapshot();
    std::size_t clear = 0;
    if (motion_) {
      for (const Segment& m : motions_) clear += known.swept_disc_is_clear(m.a, m.b, kRadiusM);
    } else {
      for (const Segment& m : motions_) clear += known.disc_is_clear(m.a, kRadiusM);
    }
    clear_ = clear;
    return motions_.size();
  }

 private:
  static constexpr std::size_t kChecks = 20'000;
  static constexpr double kRadiusM = 0.3;
  bool motion_;
  bool done_ = false;
  ObstacleBase base_{ObstacleBaseConfig{}};
  std::vector<Segment> motions_;
  std::size_t clear_ = 0;
};

// What a planner's checker does with the points that are new since it last looked.
class ExpectingChecksWork : public CountedWork {
 public:
  bool prepare() override {
    if (done_++ == kScans) return false;
    do {
      base_.update(walk_.next());
    } while (base_.report().points_added == 0);
    return true;
  }
  std::size_t run() override {
    base_.snapshot().expect_checks(0.3);
    return base_.report().points_added;
  }

 private:
  static constexpr std::size_t kScans = 500;
  ForestWalk walk_{{.scans = 4 * kScans}};
  ObstacleBase base_{ObstacleBaseConfig{}};
  std::size_t done_ = 0;
};

class SensingWork : public CountedWork {
 public:
  explicit SensingWork(std::size_t rays) : rays_(rays), walk_({.rays = rays, .scans = kScans}) {}
  bool prepare() override { return done_++ < kScans; }
  std::size_t run() override {
    walk_.next();
    return rays_;
  }

 private:
  static constexpr std::size_t kScans = 1000;
  std::size_t rays_;
  ForestWalk walk_;
  std::size_t done_ = 0;
};

template <class Work, class... Arguments>
std::function<std::unique_ptr<CountedWork>()> making(Arguments... arguments) {
  return [=] { return std::make_unique<Work>(arguments...); };
}

}  // namespace

const std::vector<CountedKernel>& counted_kernels() {
  static const std::vector<CountedKernel> kernels{
      {"mapping_181", "scan of 181 rays", 8'700, 6'000, making<MappingWork>(181U, 0U, false)},
      {"mapping_720", "scan of 720 rays", 18'000, 18'000, making<MappingWork>(720U, 0U, false)},
      {"mapping_181_after_10k", "scan of 181 rays", 9'780, 6'000,
       making<MappingWork>(181U, 10'000U, false)},
      {"mapping_181_known", "scan of 181 rays", 6'500, 6'000, making<MappingWork>(181U, 0U, true)},
      {"mapping_181_after_100k", "scan of 181 rays", 8'900, 6'000,
       making<MappingWork>(181U, 100'000U, false), true},
      {"state_check", "disc of 0.3 m", 58, 60, making<CheckWork>(1'000U, false)},
      {"motion_check", "disc of 0.3 m swept 2 m", 260, 260, making<CheckWork>(1'000U, true)},
      {"motion_check_after_10k", "disc of 0.3 m swept 2 m", 248, 260,
       making<CheckWork>(10'000U, true)},
      {"checks_expected", "point that became known", 2'350, 2'000, making<ExpectingChecksWork>()},
      {"governed_cycle", "scan of 91 rays, navigation alone", 60'000, 60'000, make_governed_cycle},
      {"sensing_720", "ray, forest scan", 50, 50, making<SensingWork>(720U)},
  };
  return kernels;
}

}  // namespace voronaut::micro
