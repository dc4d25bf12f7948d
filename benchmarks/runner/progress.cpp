#include "voronaut/benchmarks/runner/progress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace voronaut {

namespace {

std::string format(const char* pattern, double a, double b = 0) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), pattern, a, b);
  return text.data();
}

double seconds_between(Progress::Time from, Progress::Time to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

std::string duration_text(double seconds) {
  if (seconds < 0.9995) return format("%.0f ms", 1000 * seconds);
  const double whole = std::round(seconds);
  if (whole < 60) return format("%.0f s", whole);
  if (whole < 3600)
    return format("%.0f min %02.0f s", std::floor(whole / 60), std::fmod(whole, 60));
  const double minutes = std::round(whole / 60);
  return format("%.0f h %02.0f min", std::floor(minutes / 60), std::fmod(minutes, 60));
}

Progress::Progress(std::ostream& out, bool terminal, std::size_t total, Time now)
    : out_(out), terminal_(terminal), total_(total), begin_(now), printed_(now) {}

void Progress::trial_stored() { ++stored_; }

void Progress::trial_done(bool failed) {
  ++done_;
  if (failed) ++failed_;
}

std::string Progress::line(Time now) const {
  const double elapsed_s = seconds_between(begin_, now);
  std::string text = std::to_string(stored_ + done_) + "/" + std::to_string(total_) + " trials";
  if (done_ > 0 && elapsed_s > 0) {
    const double rate = static_cast<double>(done_) / elapsed_s;
    const std::size_t left = total_ - std::min(total_, stored_ + done_);
    text += format(rate < 9.95 ? ", %.1f/s" : ", %.0f/s", rate);
    if (left > 0) text += ", " + duration_text(static_cast<double>(left) / rate) + " left";
  }
  if (failed_ > 0) text += ", " + std::to_string(failed_) + " failed";
  return text;
}

void Progress::tick(Time now) {
  const double period_s = terminal_ ? 0.1 : 5.0;
  if (seconds_between(printed_, now) >= period_s) print(now);
}

void Progress::print(Time now) {
  printed_ = now;
  std::string text = line(now);
  if (terminal_) {
    const std::size_t width = text.size();
    text.resize(std::max(width, printed_width_), ' ');
    printed_width_ = width;
    out_ << '\r' << text << std::flush;
  } else {
    out_ << text << std::endl;
  }
}

void Progress::finish(Time now) {
  print(now);
  if (terminal_) out_ << std::endl;
}

}  // namespace voronaut
