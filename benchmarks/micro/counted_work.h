#pragma once

#include <cstddef>
#include <memory>

// What the kernels of counted_kernels.h do.
namespace voronaut::micro {

// Something whose instructions are counted. Only run() is counted: the driver calls it through
// voronaut_counted, the function that callgrind is told to collect in.
class CountedWork {
 public:
  virtual ~CountedWork() = default;
  // Prepares the next run, uncounted; false at the end.
  virtual bool prepare() = 0;
  // Returns how many operations it did.
  virtual std::size_t run() = 0;
};

using CountedWorkPtr = std::unique_ptr<CountedWork>;

// One update per run, of the same 1000 scans whatever is known: scans of other ground before, and
// (`again`) these scans themselves.
CountedWorkPtr mapping_work(std::size_t rays, std::size_t known_scans, bool again);

// A scan of the forest per run, of circles or of walls.
CountedWorkPtr sensing_work(std::size_t rays, bool walls);

// Checks of a disc of 0.3 m at places in the corridor of `scans` scans, or swept along 2 m.
enum class Checker {
  snapshot,  // of the map itself
  ompl_own,  // behind StateValidityChecker and MotionValidator: bounds, OMPL's states and counts
  ompl_fcl,  // the same with FCL
};
enum class Check { state, motion };
CountedWorkPtr check_work(Checker checker, Check what, std::size_t scans);
// What a checker does with the points that are new since it last looked.
CountedWorkPtr expecting_checks_work();

// Steps of the quadrotor that were flown before under its regulator, or the regulator's part.
CountedWorkPtr vehicle_step_work();
CountedWorkPtr regulate_work();
// A scan of 181 rays, a map update and a reactive plan in every vehicle step, without referee and
// log; the steps before `skipped` are not counted.
CountedWorkPtr closed_loop_work(std::size_t skipped, std::size_t steps);

// Random points, 0.1 per square metre: their diagram and the roadmap of it, all at once; or one
// more point worked into the diagram.
CountedWorkPtr voronoi_build_work(std::size_t sites);
CountedWorkPtr voronoi_insert_work(std::size_t sites);

}  // namespace voronaut::micro
