#include "voronaut/benchmarks/micro/callgrind_count.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>

#include <unistd.h>

namespace voronaut::micro {
namespace {

namespace fs = std::filesystem;

std::string output_of(const std::string& command) {
  FILE* const pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  std::string output;
  std::array<char, 4096> part;
  while (std::fgets(part.data(), part.size(), pipe) != nullptr) output += part.data();
  pclose(pipe);
  return output;
}

double number_after(const std::string& text, const std::string& words) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(words + " *([0-9]+)")) ? std::stod(match[1]) : 0;
}

// A folder of its own for the files that callgrind writes, one for each run.
class DumpFolder {
 public:
  DumpFolder()
      : path_(fs::temp_directory_path() / ("voronaut-callgrind-" + std::to_string(getpid()))) {
    fs::create_directories(path_);
  }
  DumpFolder(const DumpFolder&) = delete;
  DumpFolder& operator=(const DumpFolder&) = delete;
  ~DumpFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  std::string file() const { return (path_ / "dump").string(); }

  std::vector<double> totals() const {
    std::vector<double> totals;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
      std::ifstream dump(entry.path());
      for (std::string line; std::getline(dump, line);) {
        if (line.starts_with("totals:")) totals.push_back(number_after(line, "totals:"));
      }
    }
    // The dump at the end, after the last run, holds none.
    std::erase(totals, 0);
    std::sort(totals.begin(), totals.end());
    return totals;
  }

 private:
  fs::path path_;
};

}  // namespace

bool valgrind_is_there() { return std::system("valgrind --version > /dev/null 2>&1") == 0; }

std::optional<CallgrindCount> count_instructions(const std::string& self, const std::string& kernel,
                                                 bool each_run) {
  const DumpFolder dumps;
  const std::string output = output_of(
      "valgrind --tool=callgrind --toggle-collect=voronaut_counted --callgrind-out-file='" +
      (each_run ? dumps.file() + "' --dump-after=voronaut_counted '" : "/dev/null' '") + self +
      "' --kernel " + kernel + " 2>&1");
  CallgrindCount count;
  count.operations = number_after(output, "operations");
  count.instructions = number_after(output, "Collected :");
  if (each_run) count.runs = dumps.totals();
  if (count.operations == 0 || count.instructions == 0 || (each_run && count.runs.empty())) {
    std::fprintf(stderr, "voronaut-micro-check: %s was not counted:\n%s", kernel.c_str(),
                 output.c_str());
    return std::nullopt;
  }
  return count;
}

}  // namespace voronaut::micro
