#include "voronaut/tests/reports/page/browser.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace voronaut::browser {

namespace {

using nlohmann::json;

constexpr int kPatienceMs = 90'000;  // a loaded machine may take long to start a browser
constexpr int kToBrowserFd = 3;      // where --remote-debugging-pipe reads ...
constexpr int kFromBrowserFd = 4;    // ... and writes

// In the child: only what is safe between fork and exec.
[[noreturn]] void become_browser(const char* program, const char* profile_option, int in, int out) {
  setpgid(0, 0);
  const int in_high = fcntl(in, F_DUPFD, 10);
  const int out_high = fcntl(out, F_DUPFD, 10);
  dup2(in_high, kToBrowserFd);
  dup2(out_high, kFromBrowserFd);
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  execl(program, program, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
        "--no-first-run", "--disable-background-networking", "--disable-component-update",
        "--disable-sync", "--remote-debugging-pipe", profile_option, "about:blank",
        static_cast<char*>(nullptr));
  _exit(127);
}

std::string decode_base64(const std::string& text) {
  std::string out;
  unsigned group = 0;
  int bits = 0;
  for (const char c : text) {
    const std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto digit = digits.find(c);
    if (digit == std::string_view::npos) {
      break;  // padding
    }
    group = group << 6U | static_cast<unsigned>(digit);
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      out += static_cast<char>(group >> static_cast<unsigned>(bits) & 0xFFU);
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

Session::Session() {
  std::string pattern =
      (std::filesystem::temp_directory_path() / "voronaut-browser-XXXXXX").string();
  std::array<int, 2> to{};
  std::array<int, 2> from{};
  if (mkdtemp(pattern.data()) == nullptr || pipe2(to.data(), O_CLOEXEC) != 0 ||
      pipe2(from.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error("no room for a browser");
  }
  profile_ = pattern;
  const std::string program = find_chromium().value().string();
  const std::string profile_option = "--user-data-dir=" + pattern;
  process_ = fork();
  if (process_ == 0) {
    become_browser(program.c_str(), profile_option.c_str(), to[0], from[1]);
  }
  close(to[0]);
  close(from[1]);
  to_browser_ = to[1];
  from_browser_ = from[0];
  const json target = call("Target.createTarget", {{"url", "about:blank"}});
  const json attached =
      call("Target.attachToTarget", {{"targetId", target.at("targetId")}, {"flatten", true}});
  session_ = attached.at("sessionId").get<std::string>();
  for (const char* domain : {"Page", "Runtime", "Log", "Network"}) {
    call(std::string(domain) + ".enable", json::object());
  }
}

Session::~Session() {
  close(to_browser_);
  close(from_browser_);
  kill(-process_, SIGKILL);  // its own process group: the browser and its helpers
  waitpid(process_, nullptr, 0);
  std::error_code ignored;
  std::filesystem::remove_all(profile_, ignored);
}

json Session::receive() {
  while (true) {
    if (const auto end = buffer_.find('\0'); end != std::string::npos) {
      json message = json::parse(buffer_.substr(0, end));
      buffer_.erase(0, end + 1);
      return message;
    }
    pollfd waiting{from_browser_, POLLIN, 0};
    std::array<char, 65536> chunk{};
    const ssize_t size =
        poll(&waiting, 1, kPatienceMs) == 1 ? read(from_browser_, chunk.data(), chunk.size()) : 0;
    if (size <= 0) {
      throw std::runtime_error("the browser does not answer");
    }
    buffer_.append(chunk.data(), static_cast<std::size_t>(size));
  }
}

void Session::note(const json& event) {
  const std::string method = event.value("method", "");
  if (method == "Page.loadEventFired") {
    loaded_ = true;
  } else if (method == "Network.requestWillBeSent") {
    requests_.push_back(event["params"]["request"]["url"].get<std::string>());
  } else if (method == "Runtime.exceptionThrown" || method == "Log.entryAdded" ||
             method == "Runtime.consoleAPICalled") {
    complaints_.push_back(event["params"].dump());
  }
}

json Session::call(const std::string& method, const json& params) {
  json message{{"id", ++last_id_}, {"method", method}, {"params", params}};
  if (!session_.empty()) {
    message["sessionId"] = session_;
  }
  const std::string text = message.dump() + '\0';
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t size = write(to_browser_, text.data() + sent, text.size() - sent);
    if (size <= 0) {
      throw std::runtime_error("the browser does not listen");
    }
    sent += static_cast<std::size_t>(size);
  }
  while (true) {
    json answer = receive();
    if (answer.value("id", 0) != last_id_) {
      note(answer);
    } else if (answer.contains("error")) {
      throw std::runtime_error(method + ": " + answer["error"].dump());
    } else {
      return answer["result"];
    }
  }
}

void Session::open(const std::filesystem::path& file, const std::string& fragment,
                   const View& view) {
  call("Page.navigate", {{"url", "about:blank"}});  // a change of fragment alone loads nothing
  call("Emulation.setDeviceMetricsOverride", {{"width", view.width_px},
                                              {"height", view.height_px},
                                              {"deviceScaleFactor", 1},
                                              {"mobile", false}});
  const json scheme{{"name", "prefers-color-scheme"}, {"value", view.dark ? "dark" : "light"}};
  call("Emulation.setEmulatedMedia",
       {{"media", view.print ? "print" : "screen"}, {"features", json::array({scheme})}});
  complaints_.clear();
  requests_.clear();
  loaded_ = false;
  const std::string url = "file://" + file.string() + fragment;
  call("Page.navigate", {{"url", url}});
  while (!loaded_) {
    note(receive());
  }
  std::erase(requests_, "file://" + file.string());
}

std::string Session::evaluate(const std::string& expression) {
  const json result =
      call("Runtime.evaluate", {{"expression", "Promise.resolve(" + expression + ").then(String)"},
                                {"awaitPromise", true},
                                {"returnByValue", true}});
  if (result.contains("exceptionDetails")) {
    throw std::runtime_error(expression + ": " + result["exceptionDetails"].dump());
  }
  return result["result"]["value"].get<std::string>();
}

bool Session::wait_for(const std::string& expression) {
  using namespace std::chrono_literals;
  for (int waited_ms = 0; waited_ms < kPatienceMs; waited_ms += 50) {
    if (evaluate(expression) == "true") {
      return true;
    }
    std::this_thread::sleep_for(50ms);
  }
  return false;
}

void Session::press(const std::string& key) {
  for (const char* type : {"keyDown", "keyUp"}) {
    json event{{"type", type}, {"key", key}, {"code", key == " " ? "Space" : key}};
    if (key == " " && std::string_view(type) == "keyDown") {
      event["text"] = " ";
    }
    call("Input.dispatchKeyEvent", event);
  }
}

void Session::screenshot(const std::filesystem::path& png) {
  const json picture =
      call("Page.captureScreenshot", {{"format", "png"}, {"captureBeyondViewport", true}});
  std::ofstream(png, std::ios::binary) << decode_base64(picture["data"].get<std::string>());
}

}  // namespace voronaut::browser
