#pragma once

#include "voronaut/benchmarks/trial/flight_config.h"

// The keys of the entries of a suite's lists, which are read by hand (suite_entries.cpp).
namespace voronaut {

struct VehicleEntryKeys {
  FlightConfig flight;

  template <class Visitor>
  void visit(Visitor& v) {
    v.form("name", "text", "Of the vehicle");
    v.form("label", "text", "What reports call it; none: the name");
    v.form("params", "section", "Its size and limits");
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
