#pragma once

#include <string>
#include <vector>

#include "voronaut/benchmarks/micro/callgrind_count.h"
#include "voronaut/benchmarks/micro/counted_kernels.h"

// The tables of counts in docs/performance.md, made by the command that counts and held against it.
namespace voronaut::micro {

struct KernelCount {
  const CountedKernel* kernel;
  CallgrindCount count;
};

// Compiler and kind of build: counts of another one are other counts.
std::string counted_build();

// The page with its tables made anew: what stands between `<!-- counts: NAME -->` and
// `<!-- end of counts -->` for the names build, kernels, growth. Throws std::runtime_error where
// one of them is missing.
std::string with_counts(std::string page, const std::vector<KernelCount>& counts);

// What the page says of these kernels and is not so, one line each, empty if all agrees within 1 %:
// the C library's own variants for a processor differ by less. One line alone if the page is of
// another build.
std::vector<std::string> differences(const std::string& page,
                                     const std::vector<KernelCount>& counts);

}  // namespace voronaut::micro
