#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "voronaut/benchmarks/micro/counted_work.h"

namespace voronaut::micro {

struct CountedKernel {
  std::string name;
  std::string what;           // is counted
  std::string operation;      // what one operation is
  double limit_instructions;  // per operation, on the average: more is a regression
  double goal_instructions;   // what is aimed at, 0: nothing; the limit follows as it is approached
  std::function<CountedWorkPtr()> make;
  bool takes_minutes = false;  // counted on demand only
  bool each_run = false;       // single runs are counted, and their tail is limited
  double known_scans = 0;      // before the counted ones, if it is a kernel of growth
};

const std::vector<CountedKernel>& counted_kernels();

}  // namespace voronaut::micro

extern "C" std::size_t voronaut_counted(voronaut::micro::CountedWork& work);
