#pragma once

#include <filesystem>
#include <string>
#include <vector>

// Suites and scenarios that come with the program.
namespace voronaut {

// Folder that holds suites/ and scenarios/: share/voronaut beside the program's bin/ if it is
// installed, else the source tree it was built from. Empty if there is neither.
std::filesystem::path shipped_folder();

struct ShippedFile {
  std::string name;     // path within the folder, without .yaml
  std::string summary;  // the comment in the file's first line
  std::filesystem::path file;
};

// The YAML files below a folder within it ("suites", "scenarios"), by name.
std::vector<ShippedFile> shipped_files(const std::string& kind);

// A path as it is, or else the name of a suite that ships. Throws std::invalid_argument that lists
// the names if it is neither.
std::filesystem::path find_suite(const std::string& argument);

}  // namespace voronaut
