#pragma once

#include <string>

#include "voronaut/reports/store/store.h"

namespace voronaut {

// Every stored trace as an MCAP file for Foxglove and other viewers; JSON messages with Foxglove's
// schemas (https://docs.foxglove.dev/docs/visualization/message-schemas). Topics of a trial are
// "/<scenario>/<planner>/<first 8 of trial id>/" and then
//   world  foxglove.SceneUpdate   once: the true world, circles as cylinders, the rest as lines
//   pose   foxglove.PoseInFrame   at every scan
//   scan   foxglove.LaserScan     at every scan that was stored; 0: no return
// in the frame "world"; times are simulated from 0, so that trials play side by side.
std::string mcap_log(const ResultStore& store);

}  // namespace voronaut
