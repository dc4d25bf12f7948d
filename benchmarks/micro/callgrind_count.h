#pragma once

#include <optional>
#include <string>
#include <vector>

namespace voronaut::micro {

// What callgrind counted in voronaut_counted() during one run of this program with --kernel NAME.
struct CallgrindCount {
  double operations = 0;
  double instructions = 0;
  std::vector<double> runs;  // the instructions of each single run, ascending; if asked for

  double per_operation() const { return instructions / operations; }
};

bool valgrind_is_there();

// Empty, with valgrind's words on stderr, if there is nothing to count.
std::optional<CallgrindCount> count_instructions(const std::string& self, const std::string& kernel,
                                                 bool each_run);

}  // namespace voronaut::micro
