#pragma once

#include <cstdint>
#include <string>

// What may be read as input: every file that a user names is opened by read_bytes (config_node.h),
// which refuses what is none and never waits for one.
namespace voronaut {

// The largest file that is read. A map of the most cells that we take (formats/blocked_cells.h),
// written as plain numbers, has 80 MB.
inline constexpr std::int64_t kLargestInputFile_bytes = 128 << 20;

// Why the path cannot be read as an input file, in a few words: "is a folder", "is a pipe".
// Empty where it can, as far as can be told without reading it.
std::string input_file_problem(const std::string& path);

}  // namespace voronaut
