#include "voronaut/tests/reports/page/report_in_browser.h"

#include <cstdio>

#include <gmock/gmock.h>

#include "voronaut/reports/trace/trace_json.h"

namespace voronaut {

using ::testing::IsEmpty;

namespace {

constexpr const char* kDrawn = "document.documentElement.dataset.ready === 'yes'";

std::string quoted(const std::string& selector) {
  std::string text = "'";
  for (const char c : selector) text += c == '\'' ? std::string("\\'") : std::string(1, c);
  return text + "'";
}

}  // namespace

std::filesystem::path pages_folder() {
  const auto path = std::filesystem::path(VORONAUT_BINARY_DIR) / "report-pages";
  std::filesystem::create_directories(path);
  return path;
}

ReportInput report_input_of(const synthetic::Run& run, const std::string& title) {
  ReportInput input;
  input.title = title;
  input.manifest_json =
      R"({"program":{"version":"0.1.0","commit":"0123abcd","compiler":"GNU 12.2.0"},)"
      R"("machine":{"cpu":"made up"},"command":["voronaut","run","a b.yaml","--seed","1"],)"
      R"("configuration":{"seed":1,"planners":[{"label":"repaired"}]},)"
      R"("suite_text":"scenarios:\n  - paper\n  - forest\n"})";
  input.records = run.records;
  input.summary = summarise(run.records);
  input.worlds = run.worlds;
  for (const Trace& trace : run.traces) {
    input.trace_blobs[trace.trial_id] = compress_trace(trace);
  }
  return input;
}

std::filesystem::path write_page(const std::string& name, const ReportInput& input) {
  const auto file = pages_folder() / name;
  write_html_report(input, file);
  return file;
}

std::string decimal(double value, int decimals) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  return buffer;
}

void ReportInBrowser::SetUp() {
  if (!browser::find_chromium()) {
    GTEST_SKIP() << "chromium is not installed: the report was not opened in a browser";
  }
  session_.emplace();
}

void ReportInBrowser::open(const std::filesystem::path& file, const std::string& fragment,
                           const browser::View& view) {
  session_->open(file, fragment, view);
  ASSERT_TRUE(session_->wait_for(kDrawn));
  ASSERT_TRUE(session_->wait_for("document.querySelectorAll('.waiting').length === 0"));
  expect_quiet();
}

void ReportInBrowser::expect_quiet() {
  EXPECT_THAT(session_->complaints(), IsEmpty());
  EXPECT_THAT(session_->requests(), IsEmpty());
}

void ReportInBrowser::go_to(const std::string& page) {
  session_->evaluate("location.hash = '#" + page + "'");
  ASSERT_TRUE(session_->wait_for("!document.querySelector('#page-" + page + "').hidden"));
  // What is in the window is drawn; the rest waits until it is scrolled to.
  ASSERT_TRUE(session_->wait_for(
      "[...document.querySelectorAll('section:not([hidden]) .waiting')].every(e => "
      "e.getBoundingClientRect().top > window.innerHeight)"));
  if (page == "replay") {
    ASSERT_TRUE(session_->wait_for("document.querySelector('.panels figure') !== null"));
  }
}

std::string ReportInBrowser::text(const std::string& selector) {
  return session_->evaluate("document.querySelector(" + quoted(selector) + ").textContent");
}

std::string ReportInBrowser::count(const std::string& selector) {
  return session_->evaluate("document.querySelectorAll(" + quoted(selector) + ").length");
}

std::string ReportInBrowser::rows(const std::string& page) {
  return session_->evaluate("[...document.querySelectorAll('#page-" + page +
                            " tr')].map(r => "
                            "[...r.cells].map(c => c.textContent.trim()).join(' | ')).join('\\n')");
}

void ReportInBrowser::picture(const std::string& name) {
  ASSERT_TRUE(session_->wait_for(
      "document.querySelectorAll('section:not([hidden]) :is(.waiting, .thumbnail:empty)').length "
      "=== 0"));
  const auto png = pages_folder() / name;
  session_->screenshot(png);
  EXPECT_GT(std::filesystem::file_size(png), 10'000U) << png;
  EXPECT_EQ(session_->evaluate("document.documentElement.scrollWidth <= window.innerWidth"), "true")
      << png;
}

}  // namespace voronaut
