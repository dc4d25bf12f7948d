#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>
#include <sys/types.h>

// Headless Chromium, driven over the pipe of its DevTools protocol: what a reader's browser makes
// of a report. One page at a time.
namespace voronaut::browser {

// Empty if there is none on this machine.
std::optional<std::filesystem::path> find_chromium();

struct View {
  int width_px = 1280;
  int height_px = 1600;
  bool dark = false;
  bool print = false;  // as the style sheet sets it for paper
};

class Session {
 public:
  Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  // Loads a file and waits for its load event. `fragment` with its '#', or empty.
  void open(const std::filesystem::path& file, const std::string& fragment = {},
            const View& view = {});

  // The value of a JavaScript expression as text; a promise is awaited.
  std::string evaluate(const std::string& expression);
  // Waits until an expression is true; false after ten seconds.
  bool wait_for(const std::string& expression);
  // Presses a key as a user does: "ArrowRight", "End", " ".
  void press(const std::string& key);
  // The whole page.
  void screenshot(const std::filesystem::path& png);

  // Since open(): errors, warnings and refused loads; addresses asked for besides the page itself.
  const std::vector<std::string>& complaints() const { return complaints_; }
  const std::vector<std::string>& requests() const { return requests_; }

 private:
  nlohmann::json call(const std::string& method, const nlohmann::json& params);
  nlohmann::json receive();
  void note(const nlohmann::json& event);

  std::filesystem::path profile_;
  pid_t process_ = -1;
  int to_browser_ = -1;
  int from_browser_ = -1;
  std::string buffer_;
  std::string session_;
  int last_id_ = 0;
  bool loaded_ = false;
  std::vector<std::string> complaints_;
  std::vector<std::string> requests_;
};

}  // namespace voronaut::browser
