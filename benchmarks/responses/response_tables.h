#pragma once

#include <string>

namespace voronaut {

// How each vehicle of the model quadrotor answers under each regulator that drives it, as Markdown:
// what `voronaut list responses` prints and docs/vehicles.md holds. Flown anew at every call, in
// about half a second.
std::string response_tables();

}  // namespace voronaut
