#include "voronaut/environments/config/renamed_keys.h"

#include <algorithm>
#include <array>

namespace voronaut {
namespace {

constexpr std::array kRenamings{
    Renaming{"clearance_min_m", "planning_clearance_m"},  // of a vehicle
    Renaming{"claims", "acceptance"},
    Renaming{"gaze", "yaw_policy"},
    Renaming{"known", "static"},  // the kind of a suite
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
