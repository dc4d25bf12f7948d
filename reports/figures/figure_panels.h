#pragma once

#include <string>
#include <vector>

#include "voronaut/reports/figures/svg_figure.h"
#include "voronaut/reports/store/store.h"

namespace voronaut {

// Panels for svg_figure from stored trials: one per true world in the order of first mention,
// titled with the scenario, a track per trial labelled with its planner. Throws StoreError for a
// trial that is not stored, has no trace, or whose world is missing.
std::vector<FigurePanel> figure_panels(const ResultStore& store,
                                       const std::vector<std::string>& trial_ids);

}  // namespace voronaut
