#include "voronaut/planners/catalog/catalog.h"

#include <stdexcept>
#include <utility>

namespace voronaut {

void PlannerCatalog::add(PlannerEntry entry) {
  if (find(entry.name))
    throw std::invalid_argument("planner '" + entry.name + "' is in the catalogue already");
  const std::string name = entry.name;
  entries_.emplace(name, std::move(entry));
}

const PlannerEntry* PlannerCatalog::find(const std::string& name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second;
}

std::vector<const PlannerEntry*> PlannerCatalog::entries() const {
  std::vector<const PlannerEntry*> all;
  for (const auto& [name, entry] : entries_) all.push_back(&entry);
  return all;
}

}  // namespace voronaut
