#pragma once

#include <string>
#include <string_view>

#include "voronaut/reports/trace/trace.h"

// Traces as compact JSON, small enough to keep one per trial and readable by a browser as it is.
//
// Resolutions: time 1 ms, lengths and velocities 1 mm (1 mm/s), headings 1e-4, tilt 1e-4 rad,
// actuators 0.01, planning time 0.1 us, ranges and the ends of searched edges 1 cm, shares 1e-3. A
// number of a frame that is not finite becomes null and reads back as NaN; a range without a return
// reads back as max_range_m.
//
// Layout (version 4):
//   {"version":4, "trial_id":..., "body_radius_m":..., ["footprint":[dx,dy,...],]
//    "clearance_min_m":...,
//    "field_of_view_rad":..., "max_range_m":..., "modes":[...], "replan_reasons":[...],
//    "solve_ends":[...], "plans":[[dx,dy,...],...], "known_points":[dx,dy,...], "cluster_of":[...],
//    "merges":[frame,from,into,...], "hulls":[[dx,dy,...],...], "searches":n, "kept_searches":n,
//    "static":false, "improvements":[[checks,...],[us,...],[um,...]],
//    "edges":{"ends_cm":[dx,dy,...], "first":[...], "on":[searches more,...]},
//    "frames":{"t_ms":[...], "x_mm":[...], ..., "range_cm":[[...],...], "tube_mm":[[...],...]}}
// Polylines, improvements and the columns of frames hold differences from the previous entry, the
// first one from 0, of a tube from the vehicle. A scan is coded along its rays, -1 standing for no
// return before the differences are taken.
namespace voronaut {

std::string trace_to_json(const Trace& trace);
// Throws std::invalid_argument for anything that trace_to_json does not write.
Trace trace_from_json(std::string_view json);

// The JSON above as raw deflate.
std::string compress_trace(const Trace& trace);
Trace decompress_trace(std::string_view blob);

// Metres, rounded to 0.1 mm: {"world_id", "bounds":[x0,y0,x1,y1], "circles":[[x,y,r],...],
// "polygons":[[x,y,...],...], "segments":[[x0,y0,x1,y1],...], "start":[x,y], "goal":[x,y]}.
std::string world_to_json(const TraceWorld& world);
TraceWorld world_from_json(std::string_view json);

}  // namespace voronaut
