#pragma once

#include <vector>

#include "voronaut/planners/catalog/catalog.h"

namespace voronaut {

// OMPL's geometric planners, untouched, that run in one thread: the same seed and the same counted
// budget give the same path. Left out are those with threads inside (PRM, PRMstar, SPARS,
// SPARStwo, CForest, pRRT, pSBL, AnytimePathShortening).
std::vector<PlannerEntry> ompl_planners();

}  // namespace voronaut
