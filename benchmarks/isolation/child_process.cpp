#include "voronaut/benchmarks/isolation/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/benchmarks/isolation/child_side.h"
#include "voronaut/benchmarks/isolation/supervisor.h"

namespace voronaut {

namespace {

// Given to a supervisor for what it has to do beyond its limits.
constexpr auto kSupervisorPatience = std::chrono::seconds(10);

constexpr off_t kErrorBytes = off_t{64} * 1024;  // of standard error that are kept

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// A file of fixed size in memory: what is written past it is refused, so a talkative child costs
// nothing; nor can a child spoil it for the next one.
int make_error_file() {
  const int fd = memfd_create("voronaut-stderr", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (fd < 0) return fd;
  if (ftruncate(fd, kErrorBytes) != 0 ||
      fcntl(fd, F_ADD_SEALS, F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) != 0) {
    close(fd);
    return -1;
  }
  return fd;
}

// "program: file.h:12: function: Assertion `x' failed." without the program's name: it repeats for
// the same build, other output may hold addresses.
std::string failed_assertion(int error_fd) {
  if (error_fd < 0) return {};
  std::string text(static_cast<std::size_t>(std::max<off_t>(lseek(error_fd, 0, SEEK_CUR), 0)), ' ');
  const ssize_t size = pread(error_fd, text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  const std::size_t found = text.rfind(": Assertion `");
  if (found == std::string::npos) return {};
  const std::size_t line = text.rfind('\n', found) + 1;  // npos + 1 is the beginning
  const std::size_t name = text.find(": ", line);
  return text.substr(name + 2, text.find('\n', found) - name - 2);
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

// What operators, service managers, terminals and the kernel's memory killer send. A program may
// send it to itself, which looks the same.
bool is_sent_by_others(int signal) {
  return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
}

// A limit as the suite file says it.
std::string limit_text(double value) {
  std::array<char, 64> text{};
  return {
      text.data(),
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr};
}

std::string signal_in_words(const ChildReport& report) {
  const char* name = sigabbrev_np(report.code);
  const std::string text = name ? "SIG" + std::string(name) : std::to_string(report.code);
  return "ended by " + text + (report.message.empty() ? "" : ": " + report.message);
}

}  // namespace

std::string end_in_words(const ChildReport& report, const ProcessLimits& limits) {
  switch (report.end) {
    case ChildReport::End::exception:
      return "exception: " + report.message;
    case ChildReport::End::exited:
      return "ended the process with exit code " + std::to_string(report.code);
    case ChildReport::End::signalled:
    case ChildReport::End::killed:
      return signal_in_words(report);
    case ChildReport::End::memory:
      return "asked for more than " + limit_text(limits.memory_mb) + " MB of memory";
    case ChildReport::End::cpu_limit:
      return "used more than " + limit_text(limits.cpu_s) + " s of CPU time";
    case ChildReport::End::wall_limit:
      return "took longer than " + limit_text(limits.wall_s) + " s";
    case ChildReport::End::output_limit:
      return "sent more than " + std::to_string(kOutputBytesMax >> 20U) + " MB as its result";
    case ChildReport::End::finished:
      break;
  }
  return "sent a garbled result";
}

ChildSeries::ChildSeries(const std::vector<Task>& tasks, const ProcessLimits& limits,
                         const Setup& setup)
    : tasks_(tasks.size()),
      cpu_limit_s_(std::ceil(limits.cpu_s)),
      patience_(kSupervisorPatience + std::chrono::duration_cast<Clock::duration>(
                                          std::chrono::duration<double>(limits.wall_s))),
      deadline_(Clock::time_point::max()) {
  void* page =
      mmap(nullptr, sizeof(LastWords), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) fail("a shared page for a child");
  last_words_ = new (page) LastWords();
  std::array<int, 2> output{-1, -1};
  std::array<int, 2> verdict{-1, -1};
  if (pipe2(output.data(), O_CLOEXEC) != 0 ||
      socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, verdict.data()) != 0) {
    const std::error_code why(errno, std::generic_category());
    for (const int fd : output) close(fd);
    munmap(page, sizeof(LastWords));
    throw std::system_error(why, "a pipe to a child");
  }
  error_fd_ = make_error_file();
  output_fd_ = output[0];
  verdict_fd_ = verdict[0];
  fcntl(output_fd_, F_SETFL, O_NONBLOCK);
  fcntl(verdict_fd_, F_SETFL, O_NONBLOCK);

  std::fflush(nullptr);
  const pid_t caller = getpid();
  pid_ = fork();
  if (pid_ == 0)
    supervise({tasks,
               limits,
               setup,
               caller,
               verdict[1],
               {output[1], error_fd_, static_cast<LastWords*>(page), setup.streams}});
  const std::error_code why(errno, std::generic_category());
  close(output[1]);
  close(verdict[1]);
  if (pid_ < 0) {
    for (const int fd : {output_fd_, verdict_fd_, error_fd_}) close(fd);
    munmap(page, sizeof(LastWords));
    throw std::system_error(why, "a child process");
  }
}

ChildSeries::~ChildSeries() {
  if (pid_ > 0) {
    kill(pid_, SIGTERM);
    wait_for_supervisor();
  }
  for (const int fd : {verdict_fd_, output_fd_, error_fd_}) {
    if (fd >= 0) close(fd);
  }
  munmap(last_words_, sizeof(LastWords));
}

bool ChildSeries::start_next() {
  if (pid_ < 0 || started_ == tasks_) return false;
  new (last_words_) LastWords();
  received_.clear();
  report_ = {};
  over_wall_limit_ = over_output_limit_ = false;
  const char go = 0;
  if (send(verdict_fd_, &go, 1, MSG_NOSIGNAL) != 1) {
    wait_for_supervisor();
    return false;
  }
  ++started_;
  running_ = true;
  deadline_ = Clock::now() + patience_;
  return true;
}

// It ends as soon as nothing is left below it, unless somebody stopped it.
void ChildSeries::wait_for_supervisor() {
  const auto patience = Clock::now() + kSupervisorPatience;
  pid_t ended = 0;
  while ((ended = waitpid(pid_, nullptr, WNOHANG)) == 0 || (ended < 0 && errno == EINTR)) {
    if (Clock::now() > patience) kill(pid_, SIGKILL);
    usleep(200);
  }
  pid_ = -1;
}

void ChildSeries::read_output() {
  std::array<char, 65536> buffer;
  while (output_fd_ >= 0) {
    const ssize_t count = read(output_fd_, buffer.data(), buffer.size());
    if (count > 0) {
      received_.append(buffer.data(), static_cast<std::size_t>(count));
      if (received_.size() <= kOutputBytesMax) continue;
      over_output_limit_ = true;
      received_ = {};
      if (pid_ > 0) kill(pid_, SIGTERM);
    } else if (count < 0 && errno == EINTR) {
      continue;
    } else if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      return;
    }
    close(output_fd_);
    output_fd_ = -1;
  }
}

bool ChildSeries::has_ended() {
  if (!running_) return true;
  Verdict verdict;
  const ssize_t size = read(verdict_fd_, &verdict, sizeof verdict);
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return false;
  const bool whole = size == sizeof verdict;
  if (!whole || verdict.last) wait_for_supervisor();
  read_output();
  running_ = false;
  deadline_ = Clock::time_point::max();
  if (!whole) {
    verdict.cause = Verdict::Cause::guard_ended;  // the supervisor itself was killed
  } else if (verdict.cause == Verdict::Cause::not_started) {
    throw std::system_error(verdict.error, std::generic_category(), "a child process");
  }
  report_.cpu_time_s = verdict.cpu_time_s;
  report_.memory_max_mb = verdict.memory_max_mb;
  interpret(verdict);
  return true;
}

void ChildSeries::interpret(const Verdict& verdict) {
  using Cause = Verdict::Cause;
  using End = ChildReport::End;
  if (over_output_limit_) {
    report_.end = End::output_limit;
  } else if (over_wall_limit_ || verdict.cause == Cause::wall_limit) {
    report_.end = End::wall_limit;
  } else if (verdict.cause == Cause::memory) {
    report_.end = End::memory;
  } else if (verdict.cause == Cause::ended) {
    interpret_end(verdict.wait_status);
  } else {
    report_.end = End::killed;
    report_.code = verdict.cause == Cause::stopped ? SIGTERM : SIGKILL;
  }
}

void ChildSeries::interpret_end(int wait_status) {
  using End = ChildReport::End;
  const auto* words = static_cast<const LastWords*>(last_words_);
  auto frame = parse_frame(received_);
  received_.clear();
  const bool left_in_order = WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == 0;
  const int signal = WIFSIGNALED(wait_status) ? WTERMSIG(wait_status) : 0;
  if (frame && left_in_order && frame->kind == FrameKind::result) {
    report_.end = End::finished;
    report_.output = std::move(frame->payload);
  } else if (signal == SIGXCPU || (signal == SIGKILL && report_.cpu_time_s >= cpu_limit_s_)) {
    report_.end = End::cpu_limit;
  } else if (words->allocation_refused || (frame && frame->kind == FrameKind::memory)) {
    report_.end = End::memory;
  } else if (frame && left_in_order) {
    report_.end = End::exception;
    report_.message = first_line(frame->payload);
  } else {
    interpret_status(wait_status, first_line(words->message.data()));
  }
}

void ChildSeries::interpret_status(int wait_status, std::string last_message) {
  using End = ChildReport::End;
  if (WIFEXITED(wait_status)) {
    report_.end = End::exited;
    report_.code = WEXITSTATUS(wait_status);
    return;
  }
  report_.code = WIFSIGNALED(wait_status) ? WTERMSIG(wait_status) : 0;
  report_.end = is_sent_by_others(report_.code) ? End::killed : End::signalled;
  report_.message = std::move(last_message);
  if (report_.message.empty()) report_.message = failed_assertion(error_fd_);
}

void ChildSeries::enforce_wall_limit(Clock::time_point now) {
  if (pid_ < 0 || now < deadline_) return;
  kill(pid_, SIGKILL);
  over_wall_limit_ = true;
  deadline_ = now + kSupervisorPatience;
}

ChildProcess::ChildProcess(const Work& work, const ProcessLimits& limits, const Setup& setup)
    : ChildSeries({{work}}, limits, setup) {
  start_next();
}

ChildReport run_in_child(const ChildProcess::Work& work, const ProcessLimits& limits,
                         const ChildProcess::Setup& setup) {
  ChildProcess child(work, limits, setup);
  while (!child.has_ended()) {
    std::array<pollfd, 2> fds{pollfd{child.output_fd(), POLLIN, 0},
                              pollfd{child.verdict_fd(), POLLIN, 0}};
    poll(fds.data(), fds.size(), 50);
    child.read_output();
    child.enforce_wall_limit(ChildProcess::Clock::now());
  }
  return child.report();
}

}  // namespace voronaut
