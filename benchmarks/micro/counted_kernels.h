#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

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

struct CountedKernel {
  std::string name;
  std::string operation;      // what one operation is
  double limit_instructions;  // per operation, on the average: more is a regression
  double goal_instructions;   // what is aimed at; the limit follows as it is approached
  std::function<std::unique_ptr<CountedWork>()> make;
  bool takes_minutes = false;  // counted on demand only
};

const std::vector<CountedKernel>& counted_kernels();

}  // namespace voronaut::micro

extern "C" std::size_t voronaut_counted(voronaut::micro::CountedWork& work);
