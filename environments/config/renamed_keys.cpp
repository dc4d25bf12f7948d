#include "voronaut/environments/config/renamed_keys.h"

#include <algorithm>
#include <array>
#include <utility>

namespace voronaut {
namespace {

struct Renaming {
  std::string_view old;
  std::string_view now;
};

// Every name that a released file may still have.
constexpr std::array kRenamings{
    Renaming{"clearance_min_m", "planning_clearance_m"},  // of a vehicle
};

}  // namespace

std::optional<std::string> renamed(std::string_view written,
                                   const std::vector<std::string>& allowed) {
  for (const Renaming& renaming : kRenamings)
    if (renaming.old == written &&
        std::find(allowed.begin(), allowed.end(), renaming.now) != allowed.end())
      return std::string(renaming.now);
  return std::nullopt;
}

std::string renamed_text(std::string_view written, const std::vector<std::string>& allowed) {
  const auto now = renamed(written, allowed);
  return now ? "'" + std::string(written) + "' is now '" + *now + "'" : "";
}

}  // namespace voronaut
