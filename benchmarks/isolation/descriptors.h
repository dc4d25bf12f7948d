#pragma once

#include <initializer_list>

namespace voronaut {

// Closes every descriptor but 0, 1, 2 and those in `kept`; negative ones are none.
void close_all_but(std::initializer_list<int> kept);

// A duplicate with a number so high that no program believes it to be its own; closes the original.
// -1 if there is none.
int move_out_of_reach(int fd);

}  // namespace voronaut
