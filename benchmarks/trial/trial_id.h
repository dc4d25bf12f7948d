#pragma once

#include <string>

#include "voronaut/benchmarks/trial/trial.h"

// Names made of contents: equal ids, equal worlds and trials, on every machine and in every build.
namespace voronaut {

// Bounds, every shape, start and goal as text, numbers as the shortest decimal that reads back.
std::string canonical_world(const Scenario& scenario);
// SHA-256 of it. O(shapes).
std::string world_id(const Scenario& scenario);

// Everything that defines a trial and names its row, as text; not the limits of the process and the
// privileged references, which follow from the rest.
std::string canonical_trial(const TrialSpec& spec);
// SHA-256 of it.
std::string trial_id(const TrialSpec& spec);

}  // namespace voronaut
