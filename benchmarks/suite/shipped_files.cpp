#include "voronaut/benchmarks/suite/shipped_files.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {

namespace fs = std::filesystem;

namespace {

std::string first_comment(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  if (!line.starts_with("#")) return "";
  const std::size_t begin = line.find_first_not_of("# ");
  return begin == std::string::npos ? "" : line.substr(begin);
}

}  // namespace

fs::path shipped_folder() {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path installed = program.parent_path().parent_path() / "share" / "voronaut";
  for (const fs::path& folder : {installed, fs::path(VORONAUT_SHIPPED_FOLDER)})
    if (fs::is_directory(folder / "suites", ignored)) return folder;
  return {};
}

std::vector<ShippedFile> shipped_files(const std::string& kind) {
  std::vector<ShippedFile> files;
  const fs::path folder = shipped_folder() / kind;
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    const fs::path name = entry.path().lexically_relative(folder).replace_extension();
    files.push_back({name.string(), first_comment(entry.path()), entry.path()});
  }
  std::sort(files.begin(), files.end(),
            [](const ShippedFile& a, const ShippedFile& b) { return a.name < b.name; });
  return files;
}

fs::path find_suite(const std::string& argument) {
  std::error_code ignored;
  if (fs::exists(argument, ignored)) return argument;
  std::vector<std::string> names;
  for (const ShippedFile& file : shipped_files("suites")) {
    if (file.name == argument) return file.file;
    names.push_back(file.name);
  }
  const bool is_name = !argument.ends_with(".yaml");
  throw std::invalid_argument(is_name ? "no suite " + in_quotes(argument) +
                                            allowed_names(argument, names)
                                      : argument + ": no such file");
}

}  // namespace voronaut
