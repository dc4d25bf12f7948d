#include "voronaut/benchmarks/results/build_info.h"

#include <fstream>
#include <sstream>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <fcl/config.h>
#include <link.h>
#include <ompl/config.h>
#include <sleef.h>
#include <sqlite3.h>
#include <sys/utsname.h>
#include <unistd.h>

#include "voronaut/benchmarks/results/source_state.h"
#include "voronaut/benchmarks/trial/sha256.h"

namespace voronaut {

namespace {

std::string dotted(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

std::string compiler() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

// The value of the first line "key : value" of a file of /proc.
std::string proc_value(const std::string& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t begin = line.find_first_not_of(" \t", line.find(':') + 1);
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return "unknown";
}

}  // namespace

BuildInfo build_info() {
  const SourceState state = source_state();
  return {
      state.version,
      state.commit,
      state.dirty,
      compiler(),
      state.build_type,
      state.flags,
      {{"ompl", dotted(OMPL_MAJOR_VERSION, OMPL_MINOR_VERSION, OMPL_PATCH_VERSION)},
       {"fcl", FCL_VERSION},
       {"eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
       {"boost", dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
       {"sqlite", sqlite3_libversion()},
       {"sleef", dotted(SLEEF_VERSION_MAJOR, SLEEF_VERSION_MINOR, SLEEF_VERSION_PATCHLEVEL)}}};
}

std::string version_line() {
  const BuildInfo info = build_info();
  return "voronaut " + info.version + " (" + info.commit.substr(0, 12) +
         (info.dirty ? ", changed" : "") + ")";
}

namespace {

// The note NT_GNU_BUILD_ID of a loaded object.
std::string_view build_id_of(const dl_phdr_info& object) {
  for (int i = 0; i < object.dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object.dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader gives addresses as numbers
    const auto* at = reinterpret_cast<const char*>(object.dlpi_addr + segment.p_vaddr);
    const char* const end = at + segment.p_memsz;
    while (end - at >= static_cast<std::ptrdiff_t>(sizeof(ElfW(Nhdr)))) {
      const auto& note = *reinterpret_cast<const ElfW(Nhdr)*>(at);
      const char* const value = at + sizeof note + padded(note.n_namesz);
      if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4) return {value, note.n_descsz};
      at = value + padded(note.n_descsz);
    }
  }
  return {};
}

// Of the program itself, which comes first.
std::string_view build_id_of_program() {
  std::string_view id;
  dl_iterate_phdr(
      [](dl_phdr_info* object, std::size_t, void* found) {
        *static_cast<std::string_view*>(found) = build_id_of(*object);
        return 1;
      },
      &id);
  return id;
}

std::string bytes_of_program() {
  std::ifstream in("/proc/self/exe", std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

}  // namespace

std::string program_id() {
  static const std::string id = [] {
    const std::string_view built = build_id_of_program();
    if (!built.empty()) return sha256_hex(built);
    const std::string bytes = bytes_of_program();  // a linker that leaves none
    return bytes.empty() ? std::string() : sha256_hex(bytes);
  }();
  return id;
}

std::vector<std::pair<std::string, std::string>> machine_facts() {
  utsname system{};
  uname(&system);
  return {{"host", system.nodename},
          {"system", std::string(system.sysname) + " " + system.release + " " + system.machine},
          {"processor", proc_value("/proc/cpuinfo", "model name")},
          {"cores", std::to_string(sysconf(_SC_NPROCESSORS_ONLN))},
          {"memory", proc_value("/proc/meminfo", "MemTotal")}};
}

}  // namespace voronaut
