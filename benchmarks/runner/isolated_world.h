#pragma once

#include "voronaut/benchmarks/suite/shortest_references.h"
#include "voronaut/benchmarks/suite/suite_trials.h"

// What a scenario makes the program compute before anything flies, done in a child first: whatever
// that does to its process becomes rows of the trials concerned, and a run goes on. What somebody
// killed is done once more.
namespace voronaut {

// `length` in a child; std::runtime_error says how that ended, where it brought no length.
ShortestReferences::Length isolated_length(
    ShortestReferences::Length length = ShortestReferences::exact_length_m);

// The same of a world's difficulty; null for null.
ShortestReferences::Difficulty isolated_difficulty(
    ShortestReferences::Difficulty difficulty = ShortestReferences::exact_difficulty);

// Each of both computed in a child, once for a world. add_to() throws std::runtime_error that says
// how the child ended, where it brought nothing.
ShortestReferences isolated_references(
    ShortestReferences::Length length = ShortestReferences::exact_length_m,
    ShortestReferences::Difficulty difficulty = ShortestReferences::exact_difficulty);

// Makes a world in a child that is thrown away: a world that ends its process does so there.
SuiteTrials::Rehearse rehearse_in_child();

}  // namespace voronaut
