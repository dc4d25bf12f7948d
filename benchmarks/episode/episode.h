#pragma once

#include "voronaut/benchmarks/episode/flight.h"

namespace voronaut {

// Flies from the start until the referee has a verdict.
EpisodeLog fly(Flight& flight);

}  // namespace voronaut
