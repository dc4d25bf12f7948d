#pragma once

#include <string>
#include <utility>
#include <vector>

namespace voronaut {

// What this program was built from and with; baked in when it was built.
struct BuildInfo {
  std::string version;
  std::string commit;  // "unknown" outside of a git checkout
  bool dirty = false;  // tracked files differed from the commit
  std::string compiler;
  std::string build_type;
  std::string flags;
  std::vector<std::pair<std::string, std::string>> libraries;  // name, version
};

BuildInfo build_info();

// "voronaut 0.1.0 (1a2b3c4d, changed)"
std::string version_line();

// SHA-256 of the build id that the linker made of all that is in the program: two programs that
// differ anywhere, a planner of the user's included, differ here. Where there is none, of the
// program's file. Empty where neither can be read.
std::string program_id();

// Where it runs: (name, value) of processor, cores, memory, system.
std::vector<std::pair<std::string, std::string>> machine_facts();

}  // namespace voronaut
