#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "voronaut/reports/page/html_report.h"
#include "voronaut/tests/reports/page/browser.h"
#include "voronaut/tests/reports/synthetic_run.h"

namespace voronaut {

// Rendered reports and their pictures stay in this folder of the build, to be looked at.
std::filesystem::path pages_folder();

// A report of made-up records with everything a page can show of them.
ReportInput report_input_of(const synthetic::Run& run, const std::string& title);
std::filesystem::path write_page(const std::string& name, const ReportInput& input);

std::string decimal(double value, int decimals);

// Opens reports in a headless Chromium; skipped where there is none.
class ReportInBrowser : public ::testing::Test {
 protected:
  // Drawings far below the window wait until they are scrolled to.
  static constexpr browser::View kTall{1280, 9000};

  void SetUp() override;

  // Loads a report and waits until it is drawn; nothing was complained about or asked for.
  void open(const std::filesystem::path& file, const std::string& fragment = {},
            const browser::View& view = kTall);
  void expect_quiet();
  void go_to(const std::string& page);

  // Of CSS selectors.
  std::string text(const std::string& selector);
  std::string count(const std::string& selector);
  // The rows of a page's tables, cells separated by " | ", a row per line.
  std::string rows(const std::string& page);
  // The page as it is, under this name in pages_folder(); no wider than the window.
  void picture(const std::string& name);

  std::optional<browser::Session> session_;
};

}  // namespace voronaut
