#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "voronaut/benchmarks/micro/callgrind_count.h"
#include "voronaut/benchmarks/micro/count_page.h"
#include "voronaut/benchmarks/micro/counted_kernels.h"
#include "voronaut/reports/summary/estimate.h"

// Counts the instructions of every kernel with callgrind and fails where one takes more than its
// limit, where single scans take too many times the median, where scans cost more the more is
// known, or where the page of counts says something else (--page; --write-page makes its tables
// anew). Exit codes: 0 all within, 1 some above, 2 wrong use or valgrind failed, 77 no valgrind.
namespace voronaut::micro {
namespace {

constexpr int kSkipped = 77;
constexpr double kLargestTailRatio = 8;          // 99th percentile of single runs to their median
constexpr double kLargestGrowthExponent = 0.05;  // of the median with what is known

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

// Of what grows: cost at size, fitted by least squares in logarithms.
class Growth {
 public:
  void add(double size, double cost) {
    log_size_.push_back(std::log(size));
    log_cost_.push_back(std::log(cost));
  }
  std::size_t sizes() const { return log_size_.size(); }
  double exponent() const {
    const auto n = static_cast<double>(sizes());
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < sizes(); ++i) {
      x += log_size_[i];
      y += log_cost_[i];
      xx += log_size_[i] * log_size_[i];
      xy += log_size_[i] * log_cost_[i];
    }
    return (n * xy - x * y) / (n * xx - x * x);
  }

 private:
  std::vector<double> log_size_;
  std::vector<double> log_cost_;
};

bool report(const CountedKernel& kernel, const CallgrindCount& count) {
  const double each = count.per_operation();
  bool within = each <= kernel.limit_instructions;
  std::printf("%-24s %12.1f %8.0f %8.0f   %s%s\n", kernel.name.c_str(), each,
              kernel.limit_instructions, kernel.goal_instructions, kernel.operation.c_str(),
              within ? "" : "   ABOVE");
  if (!count.runs.empty()) {
    const double tail_ratio =
        quantile_of_sorted(count.runs, 0.99) / quantile_of_sorted(count.runs, 0.5);
    const bool tail_within = tail_ratio <= kLargestTailRatio;
    std::printf("%-24s single runs: median %.0f, p99 %.0f, largest %.0f; p99 / median %.1f%s\n", "",
                quantile_of_sorted(count.runs, 0.5), quantile_of_sorted(count.runs, 0.99),
                count.runs.back(), tail_ratio, tail_within ? "" : "   ABOVE");
    within = within && tail_within;
  }
  std::fflush(stdout);
  return within;
}

std::string read(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return text.str();
}

// True if the page agrees.
bool hold_page(const std::string& path, const std::vector<KernelCount>& counts, bool write) {
  const std::string page = read(path);
  if (write) {
    std::ofstream(path) << with_counts(page, counts);
    return true;
  }
  bool agrees = true;
  for (const std::string& line : differences(page, counts)) {
    std::printf("%s: %s\n", path.c_str(), line.c_str());
    agrees = agrees && line.ends_with("not compared");
  }
  return agrees;
}

struct Options {
  bool all = false;
  std::string page;
  bool write = false;
};

int check(const std::string& self, const Options& options) {
  if (!valgrind_is_there()) {
    std::puts("skipped: valgrind not found, no instructions counted");
    return kSkipped;
  }
  bool within = true;
  Growth growth;
  std::vector<KernelCount> counts;
  std::printf("%-24s %12s %8s %8s   per\n", "kernel", "instructions", "limit", "goal");
  for (const CountedKernel& kernel : counted_kernels()) {
    if (kernel.takes_minutes && !options.all) continue;
    const auto count = count_instructions(self, kernel.name, kernel.each_run);
    if (!count) return 2;
    within = report(kernel, *count) && within;
    if (kernel.known_scans > 0)
      growth.add(kernel.known_scans, quantile_of_sorted(count->runs, 0.5));
    counts.push_back({&kernel, *count});
  }
  const bool flat = growth.exponent() <= kLargestGrowthExponent;
  std::printf(
      "median scan over %zu amounts of known scans: grows with exponent %.3f (limit %.2f)%s\n",
      growth.sizes(), growth.exponent(), kLargestGrowthExponent, flat ? "" : "   ABOVE");
  const bool agrees = options.page.empty() || hold_page(options.page, counts, options.write);
  return within && flat && agrees ? 0 : 1;
}

}  // namespace
}  // namespace voronaut::micro

int main(int argc, char** argv) {
  using namespace voronaut::micro;
  const std::vector<std::string> args(argv + 1, argv + argc);
  Options options;
  bool known = true;
  try {
    if (args.size() == 2 && args[0] == "--kernel") return run_kernel(args[1]);
    for (std::size_t i = 0; i < args.size() && known; ++i) {
      const bool page = args[i] == "--page" || args[i] == "--write-page";
      known = args[i] == "--all" || (page && i + 1 < args.size());
      options.write = options.write || args[i] == "--write-page";
      if (page && known) options.page = args[++i];
    }
    options.all = options.write || std::count(args.begin(), args.end(), "--all") > 0;
    if (known) return check(argv[0], options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "voronaut-micro-check: %s\n", error.what());
    return 2;
  }
  std::fprintf(stderr,
               "usage: voronaut-micro-check [--all] [--page FILE | --write-page FILE]\n"
               "       voronaut-micro-check --kernel NAME\n");
  return 2;
}
