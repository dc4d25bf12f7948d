#pragma once

#include <filesystem>
#include <optional>
#include <string>

// Headless Chromium as a program: what a reader's browser makes of a report.
namespace voronaut::browser {

// Empty if there is none on this machine.
std::optional<std::filesystem::path> find_chromium();

struct Page {
  std::string dom;      // serialised after the scripts have run
  std::string console;  // messages, errors and refused requests, as Chromium logs them
};

// Loads a file and lets `budget_ms` of the page's own time pass. `fragment` with its '#', or empty.
Page load(const std::filesystem::path& file, const std::string& fragment, int budget_ms);

void screenshot(const std::filesystem::path& file, const std::string& fragment,
                const std::filesystem::path& png, int width, int height, bool dark, int budget_ms);

}  // namespace voronaut::browser
