#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>

namespace voronaut {

// Whether the same seed and the same counted budget give the same path, bit for bit.
enum class Reproducible {
  unknown,  // nobody has said so
  no,       // threads, clocks, or it was seen to differ
  everywhere,
};

// What the executive must know of a planner beside its OMPL interface.
struct PlannerTraits {
  // Reactive planners are asked once per scan, keep their memory between solves (no clear()) and
  // answer with the next leg only. All others plan when the path they gave no longer holds.
  bool plans_on_every_scan = false;
  Reproducible reproducible = Reproducible::unknown;
};

struct PlannerEntry {
  std::string name;     // OMPL's own name where the planner is OMPL's
  std::string summary;  // one line for `voronaut list planners`
  PlannerTraits traits;
  std::function<ompl::base::PlannerPtr(const ompl::base::SpaceInformationPtr&)> make;
};

// name -> factory, an explicit list. Parameters are the planner's own (ompl::base::ParamSet), set
// by their declared names.
class PlannerCatalog {
 public:
  static PlannerCatalog built_in();  // defined in planners/built_in

  void add(PlannerEntry entry);                             // throws if the name is taken
  const PlannerEntry* find(const std::string& name) const;  // null if unknown
  std::vector<const PlannerEntry*> entries() const;         // sorted by name

 private:
  std::map<std::string, PlannerEntry> entries_;
};

// Sets a planner's parameters by their declared names, as text. "preset" is applied first, so that
// the others refine it, whatever their order. `catalogue_name` is the planner's name in errors
// (OMPL's RRTsharp calls itself RRT#).
// Throws std::invalid_argument: for an unknown name with the known ones and the nearest, for a
// value that the parameter refuses, would alter or ignore, or that lies outside its declared range
// (parameter_range.h), with what is allowed. Parameters set before that stay set.
void set_parameters(ompl::base::Planner& planner, const std::string& catalogue_name,
                    const std::map<std::string, std::string>& values);

}  // namespace voronaut
