#include "voronaut/environments/config/renamed_keys.h"

#include <algorithm>
#include <array>

namespace voronaut {
namespace {

constexpr std::array kRenamings{
    // Of a vehicle.
    Renaming{"clearance_min_m", "planning_clearance_m"},
    // Of `navigation`.
    Renaming{"gaze", "yaw_policy"},
    // Of a suite: `kind` and its criteria.
    Renaming{"known", "static"},
    Renaming{"claims", "acceptance"},
    Renaming{"outcome_share_min", "goal_reached_share_min"},
    Renaming{"clearance_min_m", "clearance_smallest_m_min"},
};

}  // namespace

std::span<const Renaming> renamings() { return kRenamings; }

std::string renamed_text(std::string_view written, const std::vector<std::string>& allowed) {
  for (const auto& [old, now] : kRenamings)
    if (old == written && std::find(allowed.begin(), allowed.end(), now) != allowed.end())
      return std::string("'").append(old).append("' is now '").append(now).append("'");
  return "";
}

}  // namespace voronaut
