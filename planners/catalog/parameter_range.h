#pragma once

#include <limits>
#include <string>
#include <vector>

#include <ompl/base/GenericParam.h>

namespace voronaut {

// Which texts a planner's parameter takes, by its type and its declared range ("lowest:highest",
// "lowest:step:highest" or "a,b,c"). OMPL's setters rarely look at either: 1e3 becomes 1 where a
// whole number is wanted, -5 becomes 4294967291. The declared range is a suggestion for tools that
// try values out; here it is a bound, wider where a value beyond it makes sense (see the source).
struct ParameterRange {
  enum class Kind { whole_number, number, flag, text };

  explicit ParameterRange(const ompl::base::GenericParam& param);

  bool allows(const std::string& value) const;
  // "whole numbers from 1 to 1000", "0 to 1", "as_published,repaired"; empty if anything goes.
  std::string allowed() const;

  Kind kind = Kind::text;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  std::vector<std::string> options;  // empty: not a choice
};

}  // namespace voronaut
