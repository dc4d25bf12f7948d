#include "browser.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace voronaut::browser {

namespace {

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return out + "'";
}

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// A profile of its own: two tests may run at once.
class Scratch {
 public:
  Scratch() {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "voronaut-browser-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error("cannot make " + pattern);
    }
    folder_ = pattern;
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

void run(const Scratch& scratch, const std::filesystem::path& file, const std::string& fragment,
         const std::string& options, int budget_ms) {
  const std::string command =
      "timeout 180 " + quoted(find_chromium().value().string()) +
      " --headless --no-sandbox --disable-gpu --disable-background-networking --no-first-run"
      " --disable-component-update --disable-sync --enable-logging=stderr --v=0"
      " --user-data-dir=" +
      quoted((scratch / "profile").string()) +
      " --virtual-time-budget=" + std::to_string(budget_ms) + " " + options + " " +
      quoted("file://" + file.string() + fragment) + " > " + quoted((scratch / "out").string()) +
      " 2> " + quoted((scratch / "err").string());
  if (const int code = std::system(command.c_str()); code != 0) {
    throw std::runtime_error("the browser ended with " + std::to_string(code) + ": " +
                             read_file(scratch / "err"));
  }
}

// Chromium's own complaints about a machine without a desktop are not the page's.
std::string console_lines(const std::string& log) {
  std::istringstream lines(log);
  std::string line;
  std::string out;
  while (std::getline(lines, line)) {
    if (line.find("CONSOLE") != std::string::npos) {
      out += line + "\n";
    }
  }
  return out;
}

}  // namespace

std::optional<std::filesystem::path> find_chromium() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  std::string folder;
  while (std::getline(folders, folder, ':')) {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
      const std::filesystem::path candidate = std::filesystem::path(folder) / name;
      if (std::filesystem::exists(candidate)) {
        return candidate;
      }
    }
  }
  return std::nullopt;
}

Page load(const std::filesystem::path& file, const std::string& fragment, int budget_ms) {
  const Scratch scratch;
  run(scratch, file, fragment, "--window-size=1280,8000 --dump-dom", budget_ms);
  return {read_file(scratch / "out"), console_lines(read_file(scratch / "err"))};
}

void screenshot(const std::filesystem::path& file, const std::string& fragment,
                const std::filesystem::path& png, int width, int height, bool dark, int budget_ms) {
  const Scratch scratch;
  run(scratch, file, fragment,
      std::string(dark ? "--blink-settings=preferredColorScheme=0 " : "") +
          "--hide-scrollbars --window-size=" + std::to_string(width) + "," +
          std::to_string(height) + " --screenshot=" + quoted(png.string()),
      budget_ms);
}

}  // namespace voronaut::browser
