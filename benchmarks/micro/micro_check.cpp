#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <regex>
#include <string>

#include "voronaut/benchmarks/micro/counted_kernels.h"

// Counts the instructions of every kernel with callgrind and fails where one takes more than its
// limit. Exit codes: 0 all within, 1 some above, 2 wrong use or valgrind failed, 77 no valgrind.
namespace voronaut::micro {
namespace {

constexpr int kSkipped = 77;

int run_kernel(const std::string& name) {
  for (const CountedKernel& kernel : counted_kernels()) {
    if (kernel.name != name) continue;
    const std::unique_ptr<CountedWork> work = kernel.make();
    std::size_t operations = 0;
    while (work->prepare()) operations += voronaut_counted(*work);
    std::printf("operations %zu\n", operations);
    return 0;
  }
  std::fprintf(stderr, "voronaut-micro-check: no kernel '%s'\n", name.c_str());
  return 2;
}

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

int check(const std::string& self, bool all) {
  if (std::system("valgrind --version > /dev/null 2>&1") != 0) {
    std::puts("skipped: valgrind not found, no instructions counted");
    return kSkipped;
  }
  int above = 0;
  std::printf("%-24s %12s %8s %8s   per\n", "kernel", "instructions", "limit", "goal");
  for (const CountedKernel& kernel : counted_kernels()) {
    if (kernel.takes_minutes && !all) continue;
    const std::string output = output_of(
        "valgrind --tool=callgrind --callgrind-out-file=/dev/null "
        "--toggle-collect=voronaut_counted '" +
        self + "' --kernel " + kernel.name + " 2>&1");
    const double operations = number_after(output, "operations");
    const double collected = number_after(output, "Collected :");
    if (operations == 0 || collected == 0) {
      std::fprintf(stderr, "voronaut-micro-check: %s was not counted:\n%s", kernel.name.c_str(),
                   output.c_str());
      return 2;
    }
    const double each = collected / operations;
    const bool within = each <= kernel.limit_instructions;
    above += within ? 0 : 1;
    std::printf("%-24s %12.1f %8.0f %8.0f   %s%s\n", kernel.name.c_str(), each,
                kernel.limit_instructions, kernel.goal_instructions, kernel.operation.c_str(),
                within ? "" : "   ABOVE");
    std::fflush(stdout);
  }
  return above > 0 ? 1 : 0;
}

}  // namespace
}  // namespace voronaut::micro

int main(int argc, char** argv) {
  const bool all = argc == 2 && std::string(argv[1]) == "--all";
  if (argc == 1 || all) return voronaut::micro::check(argv[0], all);
  if (argc == 3 && std::string(argv[1]) == "--kernel") return voronaut::micro::run_kernel(argv[2]);
  std::fprintf(stderr, "usage: voronaut-micro-check [--all | --kernel NAME]\n");
  return 2;
}
