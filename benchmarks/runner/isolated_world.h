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

// Each length computed in a child, once for a world and a radius. add_to() throws
// std::runtime_error that says how the child ended, where it brought no length.
ShortestReferences isolated_references(
    ShortestReferences::Length length = ShortestReferences::exact_length_m);

// Makes a world in a child that is thrown away: a world that ends its process does so there.
SuiteTrials::Rehearse rehearse_in_child();

}  // namespace voronaut
