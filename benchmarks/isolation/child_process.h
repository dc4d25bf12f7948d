#pragma once

#include <chrono>
#include <functional>
#include <string>

#include <sys/types.h>

// Work done in a forked child, so that whatever happens to it stays there.
namespace voronaut {

struct ProcessLimits {
  double memory_mb = 1024;  // address space it may add; not set where a sanitizer needs terabytes
  double cpu_s = 120;       // CPU time of the child, rounded up to whole seconds
  double wall_s = 300;
};

// How a child ended.
struct ChildReport {
  enum class End {
    finished,   // `output` is what the work returned
    exception,  // it threw; `message` is what() of it
    exited,     // it ended the process itself, with `code`
    signalled,  // `code` is the signal; `message` a failed assertion or uncaught exception, if any
    memory,     // an allocation was refused and it did not get over it
    cpu_limit,
    wall_limit,
  };
  End end = End::finished;
  int code = 0;
  std::string output;
  std::string message;
  double cpu_time_s = 0;
  double memory_max_mb = 0;  // largest resident set, pages shared with the parent included
};

// Why it brought no result, in one line: "ended by SIGABRT: a.h:12: f: Assertion `x' failed.".
std::string end_in_words(const ChildReport& report, const ProcessLimits& limits);

// One child. The parent must have a single thread when it starts one. The child runs in a process
// group of its own, so that a Ctrl-C on the terminal reaches the parent only, and dies with the
// parent. It ends without running destructors of the parent's objects.
class ChildProcess {
 public:
  using Clock = std::chrono::steady_clock;
  using Work = std::function<std::string()>;
  enum class Streams { silent, inherited };

  // Forks; throws std::system_error if that is impossible.
  ChildProcess(const Work& work, const ProcessLimits& limits, Streams streams = Streams::silent);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();  // kills it if it still runs

  // For poll(): readable when there is output, and when it has ended. process_fd() is -1 where the
  // kernel has no pidfd; ask has_ended() from time to time then.
  int output_fd() const { return output_fd_; }
  int process_fd() const { return process_fd_; }

  // Takes what the child has written so far out of the pipe; never blocks.
  void read_output();
  // True once the child is gone; its report is complete then. Never blocks.
  bool has_ended();
  const ChildReport& report() const { return report_; }

  // Past its wall limit: asks it to stop, and a second later makes it.
  void enforce_wall_limit(Clock::time_point now);
  Clock::time_point deadline() const { return deadline_; }

 private:
  void interpret(int wait_status);

  pid_t pid_ = -1;
  int process_fd_ = -1;
  int output_fd_ = -1;
  int error_fd_ = -1;           // memory file that holds the child's standard error
  void* last_words_ = nullptr;  // page shared with the child
  double cpu_limit_s_ = 0;
  Clock::time_point deadline_;
  bool over_wall_limit_ = false;
  std::string received_;
  ChildReport report_;
};

// Waits for one child alone.
ChildReport run_in_child(const ChildProcess::Work& work, const ProcessLimits& limits,
                         ChildProcess::Streams streams = ChildProcess::Streams::silent);

}  // namespace voronaut
