#include "voronaut/benchmarks/cli/plugin.h"

#include <exception>
#include <filesystem>
#include <stdexcept>

#include <dlfcn.h>

#include "voronaut/benchmarks/isolation/child_process.h"
#include "voronaut/planners/catalog/plugin.h"

namespace voronaut {

namespace {

std::invalid_argument refused(const std::string& file, const std::string& why) {
  return std::invalid_argument("plugin " + file + ": " + why);
}

template <class Function>
Function* function_of(void* library, const char* name) {
  return reinterpret_cast<Function*>(dlsym(library, name));
}

void load(const std::string& file, PlannerCatalog& planners) {
  // Absolute: a bare name would be looked for in the system's folders.
  void* library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw refused(file, dlerror());
  const auto version = function_of<int()>(library, "voronaut_plugin_version");
  const auto add = function_of<void(PlannerCatalog&)>(library, "voronaut_add_planners");
  if (version == nullptr || add == nullptr)
    throw refused(file, "no VORONAUT_PLUGIN in it (see planners/catalog/plugin.h)");
  if (version() != kPluginVersion)
    throw refused(file, "built for plugin version " + std::to_string(version()) +
                            ", this program has " + std::to_string(kPluginVersion));
  try {
    add(planners);
  } catch (const std::exception& error) {
    throw refused(file, error.what());
  }
}

// In a process of its own, which a library may end or hold up.
void require_loadable(const std::string& file, PlannerCatalog planners) {
  const ProcessLimits limits{.memory_mb = 4096, .cpu_s = 10, .wall_s = 10};
  const ChildReport report = run_in_child(
      [&]() -> std::string {
        load(file, planners);
        return {};
      },
      limits);
  // What it throws is said by load() itself.
  if (report.end != ChildReport::End::finished && report.end != ChildReport::End::exception)
    throw refused(file, "cannot be loaded: " + end_in_words(report, limits));
}

}  // namespace

void load_plugin(const std::string& file, PlannerCatalog& planners) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) throw refused(file, "no such file");
  require_loadable(file, planners);
  load(file, planners);
}

}  // namespace voronaut
