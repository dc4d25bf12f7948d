#pragma once

#include <chrono>
#include <cstddef>
#include <ostream>
#include <string>

namespace voronaut {

// How a run is getting on: one line that is rewritten on a terminal, a plain line every few seconds
// elsewhere. The time is an argument, so that nothing here waits for a clock.
class Progress {
 public:
  using Time = std::chrono::steady_clock::time_point;

  Progress(std::ostream& out, bool terminal, std::size_t total, Time now);

  void trial_stored();  // there from an earlier run: counts, but says nothing about the rate
  void trial_done(bool failed);
  // As many trials as there are have been counted: what was announced for a shard was an estimate.
  void all_done() { total_ = stored_ + done_; }
  // Prints if it is time to. Call it often.
  void tick(Time now);
  // The last line, always printed.
  void finish(Time now);

  // "12/100 trials, 3.4/s, 26 s left, 1 failed"
  std::string line(Time now) const;

 private:
  void print(Time now);

  std::ostream& out_;
  bool terminal_;
  std::size_t total_;
  std::size_t stored_ = 0;
  std::size_t done_ = 0;
  std::size_t failed_ = 0;
  Time begin_;
  Time printed_;
  std::size_t printed_width_ = 0;
};

// "850 ms", "42 s", "3 min 05 s", "2 h 07 min".
std::string duration_text(double seconds);

}  // namespace voronaut
