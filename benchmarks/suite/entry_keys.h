#pragma once

#include "voronaut/benchmarks/trial/flight_config.h"

// The keys of the entries of a suite's lists, which are read by hand (suite_entries.cpp).
namespace voronaut {

// Of a vehicle, instead of the disc of its params: see footprint_entry.h.
struct FootprintKeys {
  double disc = 0;  // none
  double planned_radius_m = 0;
  bool of_scenario = false;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("disc", disc, 0.001, 10, "Radius in metres of a disc: as body_radius_m");
    v.form("polygon", "[[x, y], ...]",
           "Corners of a convex polygon in metres, in the body's frame: x forward, y left, the "
           "origin where its track runs");
    v.flag("of_scenario", of_scenario, "Disc or polygon as the scenario's file tells its robot's");
    v.number("planned_radius_m", planned_radius_m, 0.001, 10,
             "Disc that a polygon is planned as, if not the one that holds it: the polygon is then "
             "checked along paths; none: the one that holds it");
  }
};

struct VehicleEntryKeys {
  FlightConfig flight;
  FootprintKeys footprint;

  template <class Visitor>
  void visit(Visitor& v) {
    v.form("name", "text", "Of the vehicle");
    v.form("label", "text", "What reports call it; none: the name");
    v.form("params", "section", "Its size and limits");
    v.section("footprint", footprint, "Its body seen from above, instead of the disc of `params`");
    v.form("model", "section", "Parameters of its model");
    v.form("regulator", "text", "By its name, or {name, params}; none: the vehicle's own");
    flight.visit(v);  // instead of the suite's, key by key
  }
};

struct RegulatorEntryKeys {
  template <class Visitor>
  void visit(Visitor& v) {
    v.form("name", "text", "Of the regulator");
    v.form("params", "section", "Its parameters");
  }
};

struct PlannerEntryKeys {
  template <class Visitor>
  void visit(Visitor& v) {
    v.form("name", "text", "Of the planner, in the catalogue");
    v.form("label", "text", "What reports call it; none: the name");
    v.form("params", "section", "Its parameters, by its own names");
    v.form("navigation", "section", "Instead of the suite's, key by key");
  }
};

}  // namespace voronaut
