#pragma once

#include <string>
#include <vector>

namespace voronaut {

// What the help of a command shows of it, one command line each. In the order of the commands in
// the help of the program they work one after another in an empty folder, where TRIAL_ID is one of
// voronaut-results/first (tests/help_examples).
std::vector<std::string> command_examples(const std::string& command);

}  // namespace voronaut
