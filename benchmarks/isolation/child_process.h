#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

// Work done in a forked child, so that whatever happens to it stays there. docs/isolation.md says
// what that promises.
namespace voronaut {

struct ProcessLimits {
  // Address space that the child may add (not set where a sanitizer needs terabytes), and memory in
  // use by it, its own children and the memory files they hold, looked at every 20 ms.
  double memory_mb = 1024;
  double cpu_s = 120;  // CPU time of the child, rounded up to whole seconds
  double wall_s = 300;
};

// The longest result that is taken from a child; what sends more is stopped.
inline constexpr std::size_t kOutputBytesMax = std::size_t{64} << 20U;

// How a child ended.
struct ChildReport {
  enum class End {
    finished,   // `output` is what the work returned
    exception,  // it threw; `message` is what() of it
    exited,     // it ended the process itself, with `code`
    signalled,  // `code` is the signal; `message` a failed assertion or uncaught exception, if any
    killed,     // by a signal that programs get from others, `code`; no limit of ours sent it
    memory,     // an allocation was refused and it did not get over it, or too much was in use
    cpu_limit,
    wall_limit,
    output_limit,  // it sent more than kOutputBytesMax
  };
  End end = End::finished;
  int code = 0;
  std::string output;
  std::string message;
  double cpu_time_s = 0;
  double memory_max_mb = 0;  // largest resident set beyond what it inherited
};

// Why it brought no result, in one line: "ended by SIGABRT: a.h:12: f: Assertion `x' failed.".
std::string end_in_words(const ChildReport& report, const ProcessLimits& limits);

// Children one after another, each for one task, behind one supervisor (supervisor.h) that holds
// their limits and takes along whatever they started. They are forked from a warm parent that does
// nothing but prepare tasks, and what the system needs for a series of children is made once. The
// caller must have a single thread when it makes a series, and nothing else about it changes: no
// signal handler, no subreaper, no children but the supervisor. A child inherits nothing but
// standard streams and its pipe, stands in a session of its own, so that a Ctrl-C on the terminal
// reaches the caller only, and dies with the caller. It ends without running destructors of the
// caller's objects.
class ChildSeries {
 public:
  using Clock = std::chrono::steady_clock;
  using Work = std::function<std::string()>;
  enum class Streams { silent, inherited };

  struct Task {
    Work work;  // in the child
    // In the warm parent before the child is forked: what it leaves in memory is shared by this
    // child and all later ones. An exception is ignored: the work will meet the same.
    std::function<void()> prepare{};
  };

  struct Setup {
    Streams streams = Streams::silent;
    // Folders that the child may read only, where the system allows it mounts of its own.
    std::vector<std::filesystem::path> read_only{};
    bool namespaces = true;  // false: as on a system that allows none
  };

  // Forks; throws std::system_error if that is impossible. No child is started.
  ChildSeries(const std::vector<Task>& tasks, const ProcessLimits& limits, const Setup& setup);
  ChildSeries(const ChildSeries&) = delete;
  ChildSeries& operator=(const ChildSeries&) = delete;
  ~ChildSeries();  // stops what still runs

  // Starts the child of the next task; the one before has ended. False if there is none any more:
  // all tasks are done, or somebody killed what they have in common, or a child left something
  // behind that goes only with all of it. started() tells which are left over.
  bool start_next();
  std::size_t started() const { return started_; }

  // For poll(): readable when there is output, and when the child has ended.
  int output_fd() const { return output_fd_; }
  int verdict_fd() const { return verdict_fd_; }

  // Takes what the child has written so far out of the pipe; never blocks.
  void read_output();
  // True once the child and all that it started are gone; its report is complete then. Does not
  // wait. Throws std::system_error if the system had no process for it.
  bool has_ended();
  const ChildReport& report() const { return report_; }

  // The supervisor ends a child that is past its wall limit; one that does not, for it was itself
  // stopped by somebody, is ended here.
  void enforce_wall_limit(Clock::time_point now);
  Clock::time_point deadline() const { return deadline_; }

 private:
  void interpret(const struct Verdict& verdict);
  void interpret_end(int wait_status);
  void interpret_status(int wait_status, std::string last_message);
  void wait_for_supervisor();

  pid_t pid_ = -1;       // of the supervisor
  int verdict_fd_ = -1;  // a socket: starts children, brings verdicts
  int output_fd_ = -1;
  int error_fd_ = -1;           // memory file that holds the child's standard error
  void* last_words_ = nullptr;  // page shared with the child
  std::size_t tasks_;
  std::size_t started_ = 0;
  bool running_ = false;
  double cpu_limit_s_;
  Clock::duration patience_;  // with a supervisor that has a child
  Clock::time_point deadline_;
  bool over_wall_limit_ = false;
  bool over_output_limit_ = false;
  std::string received_;
  ChildReport report_;
};

// A series of one, started.
class ChildProcess : public ChildSeries {
 public:
  ChildProcess(const Work& work, const ProcessLimits& limits, const Setup& setup);
};

// Waits for one child alone.
ChildReport run_in_child(const ChildProcess::Work& work, const ProcessLimits& limits,
                         const ChildProcess::Setup& setup = {});

}  // namespace voronaut
