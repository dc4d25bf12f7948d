#include "voronaut/benchmarks/micro/count_page.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "voronaut/reports/summary/estimate.h"

namespace voronaut::micro {
namespace {

constexpr double kTolerance = 0.01;
constexpr const char* kEnd = "<!-- end of counts -->";

std::string marker(const std::string& name) { return "<!-- counts: " + name + " -->"; }

// 16 875, or 56.4 of what is small.
std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value < 100 ? "%.1f" : "%.0f", value);
  std::string grouped = text;
  for (std::size_t end = grouped.find('.') == std::string::npos ? grouped.size() : 0; end > 3;) {
    end -= 3;
    grouped.insert(end, " ");
  }
  return grouped;
}

std::string kernel_row(const KernelCount& row) {
  const CountedKernel& kernel = *row.kernel;
  const std::string goal =
      kernel.goal_instructions > 0 ? number(kernel.goal_instructions) + " " : "";
  return "| `" + kernel.name + "`: " + kernel.what + " | " + number(row.count.per_operation()) +
         " | " + number(kernel.limit_instructions) + " | " + goal + "| " + kernel.operation +
         " |\n";
}

std::string kernel_table(const std::vector<KernelCount>& counts) {
  std::string text = "| kernel | instructions | limit | goal | per |\n|---|---:|---:|---:|---|\n";
  for (const KernelCount& row : counts)
    if (row.kernel->known_scans == 0) text += kernel_row(row);
  return text;
}

std::string growth_table(const std::vector<KernelCount>& counts) {
  std::string text =
      "| kernel | known scans | mean | median | 99 % | largest |\n|---|---:|---:|---:|---:|---:|\n";
  for (const KernelCount& row : counts) {
    if (row.kernel->known_scans == 0) continue;
    text += "| `" + row.kernel->name + "` | " + number(row.kernel->known_scans);
    for (const double value : {row.count.per_operation(), quantile_of_sorted(row.count.runs, 0.5),
                               quantile_of_sorted(row.count.runs, 0.99), row.count.runs.back()})
      text += " | " + number(value);
    text += " |\n";
  }
  return text;
}

// Where the text between a marker and the end begins, and how long it is.
std::pair<std::size_t, std::size_t> place_of(const std::string& page, const std::string& name) {
  const std::size_t at = page.find(marker(name));
  const std::size_t end = at == std::string::npos ? at : page.find(kEnd, at);
  if (end == std::string::npos)
    throw std::runtime_error("the page has no place for counts between '" + marker(name) +
                             "' and '" + kEnd + "'");
  const std::size_t begin = at + marker(name).size();
  return {begin, end - begin};
}

// The first number of the row in which the kernel's name stands and that is its mean; none if there
// is no such row.
double stated(const std::string& page, const CountedKernel& kernel) {
  const std::size_t row = page.find("\n| `" + kernel.name + "`");
  if (row == std::string::npos) return std::nan("");
  std::size_t cell = page.find(" | ", row);
  if (kernel.known_scans > 0) cell = page.find(" | ", cell + 3);
  std::string digits;
  for (std::size_t i = cell + 3; i < page.size() && page[i] != '|'; ++i)
    if (page[i] != ' ') digits += page[i];
  return std::strtod(digits.c_str(), nullptr);
}

}  // namespace

std::string counted_build() {
#ifdef __clang__
  std::string build = "clang " __clang_version__;
#else
  std::string build = "gcc " __VERSION__;
#endif
#ifdef EIGEN_INITIALIZE_MATRICES_BY_NAN
  build += ", Eigen objects start as NaN";
#endif
  return build;
}

std::string with_counts(std::string page, const std::vector<KernelCount>& counts) {
  const std::pair<const char*, std::string> parts[] = {{"build", counted_build() + ".\n"},
                                                       {"kernels", kernel_table(counts)},
                                                       {"growth", growth_table(counts)}};
  for (const auto& [name, text] : parts) {
    const auto [begin, length] = place_of(page, name);
    page.replace(begin, length, "\n" + text);
  }
  return page;
}

std::vector<std::string> differences(const std::string& page,
                                     const std::vector<KernelCount>& counts) {
  const auto [begin, length] = place_of(page, "build");
  if (page.substr(begin, length) != "\n" + counted_build() + ".\n")
    return {"the page was counted with another build: not compared"};
  std::vector<std::string> lines;
  for (const KernelCount& row : counts) {
    const double page_says = stated(page, *row.kernel);
    const double counted = row.count.per_operation();
    if (std::abs(page_says - counted) <= kTolerance * counted) continue;
    lines.push_back(row.kernel->name + ": the page says " + number(page_says) + ", counted are " +
                    number(counted));
  }
  return lines;
}

}  // namespace voronaut::micro
