#include "voronaut/benchmarks/micro/counted_kernels.h"

#include "voronaut/benchmarks/micro/governed_cycle.h"

extern "C" [[gnu::noinline]] std::size_t voronaut_counted(voronaut::micro::CountedWork& work) {
  return work.run();
}

namespace voronaut::micro {
namespace {

CountedKernel mapping_after(const std::string& scans, double known_scans, double limit) {
  const auto known = static_cast<std::size_t>(known_scans);
  return {"mapping_181_after_" + scans,
          "new ground",
          "scan of 181 rays",
          limit,
          6'000,
          [known] { return mapping_work(181, known, false); },
          false,
          true,
          known_scans};
}

CountedKernel check(const std::string& name, double limit, double goal, Checker checker, Check what,
                    std::size_t scans) {
  const std::string asked = what == Check::motion ? "disc of 0.3 m swept 2 m" : "disc of 0.3 m";
  const std::string who = checker == Checker::snapshot   ? ", asked of the map"
                          : checker == Checker::ompl_own ? ", asked through OMPL, bounds included"
                                                         : ", asked of FCL";
  return {name,  asked + who, "check",
          limit, goal,        [=] { return check_work(checker, what, scans); }};
}

}  // namespace

const std::vector<CountedKernel>& counted_kernels() {
  static const std::vector<CountedKernel> kernels{
      {"mapping_181", "new ground", "scan of 181 rays", 5'800, 6'000,
       [] { return mapping_work(181, 0, false); }, false, true},
      {"mapping_720", "new ground", "scan of 720 rays", 11'830, 18'000,
       [] { return mapping_work(720, 0, false); }, false, true},
      {"mapping_181_known", "nothing new, no allocation", "scan of 181 rays", 4'350, 6'000,
       [] { return mapping_work(181, 0, true); }},
      mapping_after("1k", 1'000, 5'890),
      mapping_after("3k", 3'000, 5'750),
      mapping_after("10k", 10'000, 6'250),
      mapping_after("100k", 100'000, 5'820),
      check("state_check", 58, 60, Checker::snapshot, Check::state, 1'000),
      check("motion_check", 260, 260, Checker::snapshot, Check::motion, 1'000),
      check("motion_check_after_10k", 248, 260, Checker::snapshot, Check::motion, 10'000),
      check("state_check_ompl", 185, 0, Checker::ompl_own, Check::state, 1'000),
      check("motion_check_ompl", 464, 0, Checker::ompl_own, Check::motion, 1'000),
      check("state_check_fcl", 2'300, 0, Checker::ompl_fcl, Check::state, 1'000),
      check("motion_check_fcl", 5'350, 0, Checker::ompl_fcl, Check::motion, 1'000),
      {"checks_expected", "what a checker does to be that fast", "new point", 2'350, 2'000,
       expecting_checks_work},
      {"governed_cycle", "map, belief, policies, tracker, governor", "scan of 91 rays", 25'500,
       60'000, make_governed_cycle},
      {"known_free", "known-free space brought up to date in flight", "scan of 91 rays", 5'760,
       10'000, make_known_free},
      {"governed_trial", "point mass in a forest, everything of a trial", "step", 13'250, 13'000,
       [] { return make_governed_trial(0); }},
      {"governed_trial_2km", "the same forests in bounds 2 km wide", "step", 13'850, 0,
       [] { return make_governed_trial(1'000); }},
      {"governed_trial_19km", "the same forests in bounds 19 km wide", "step", 13'850, 0,
       [] { return make_governed_trial(9'500); }},
      {"sensing_720", "exact fan on circles, walk included", "ray", 14.2, 50,
       [] { return sensing_work(720, false); }},
      {"sensing_720_walls", "exact fan on segments, walk included", "ray", 15.8, 50,
       [] { return sensing_work(720, true); }},
      {"vehicle_step", "quadrotor, Runge-Kutta", "step", 900, 900, vehicle_step_work},
      {"regulate", "pd_rate", "command", 390, 0, regulate_work},
      {"closed_loop", "scan of 181 rays, map, reactive plan, regulator, model", "step", 19'200,
       30'000, [] { return closed_loop_work(0, 3'000); }},
      {"closed_loop_after_97k", "the same flight, its last 3 000 steps", "step", 30'000, 30'000,
       [] { return closed_loop_work(97'000, 3'000); }, true},
      {"voronoi_build_1000", "diagram and roadmap of 1000 random points", "point", 6'870, 0,
       [] { return voronoi_build_work(1'000); }},
      {"voronoi_insert_1000", "one more point worked into the diagram", "point", 33'000, 0,
       [] { return voronoi_insert_work(1'000); }},
  };
  return kernels;
}

}  // namespace voronaut::micro
