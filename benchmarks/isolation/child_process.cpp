#include "voronaut/benchmarks/isolation/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/benchmarks/isolation/child_side.h"
#include "voronaut/environments/config/config_node.h"

namespace voronaut {

namespace {

constexpr off_t kErrorBytes = off_t{64} * 1024;  // of standard error that are kept

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// A file of fixed size in memory: what is written past it is refused, so a talkative child costs
// nothing.
int make_error_file() {
  const int fd = memfd_create("voronaut-stderr", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (fd < 0) return fd;
  if (ftruncate(fd, kErrorBytes) != 0 || fcntl(fd, F_ADD_SEALS, F_SEAL_GROW) != 0) {
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
      return signal_in_words(report);
    case ChildReport::End::memory:
      return "asked for more than " + number_text(limits.memory_mb) + " MB of memory";
    case ChildReport::End::cpu_limit:
      return "used more than " + number_text(limits.cpu_s) + " s of CPU time";
    case ChildReport::End::wall_limit:
      return "took longer than " + number_text(limits.wall_s) + " s";
    case ChildReport::End::finished:
      break;
  }
  return "sent a garbled result";
}

ChildProcess::ChildProcess(const Work& work, const ProcessLimits& limits, Streams streams)
    : cpu_limit_s_(std::ceil(limits.cpu_s)) {
  void* page =
      mmap(nullptr, sizeof(LastWords), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) fail("a shared page for a child");
  last_words_ = new (page) LastWords();
  std::array<int, 2> pipe_fds{-1, -1};
  if (pipe2(pipe_fds.data(), O_CLOEXEC) != 0) {
    munmap(page, sizeof(LastWords));
    fail("a pipe to a child");
  }
  error_fd_ = make_error_file();
  output_fd_ = pipe_fds[0];
  fcntl(output_fd_, F_SETFL, O_NONBLOCK);

  std::fflush(nullptr);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {
    close(output_fd_);
    run_child_side(work, limits,
                   {pipe_fds[1], error_fd_, parent, static_cast<LastWords*>(page), streams});
  }
  close(pipe_fds[1]);
  if (pid_ < 0) {
    const std::error_code why(errno, std::generic_category());
    close(output_fd_);
    if (error_fd_ >= 0) close(error_fd_);
    munmap(page, sizeof(LastWords));
    throw std::system_error(why, "a child process");
  }
  setpgid(pid_, pid_);  // on both sides: whoever comes first
  process_fd_ = static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(limits.wall_s));
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    kill(-pid_, SIGKILL);
    kill(pid_, SIGKILL);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  for (const int fd : {process_fd_, output_fd_, error_fd_}) {
    if (fd >= 0) close(fd);
  }
  munmap(last_words_, sizeof(LastWords));
}

void ChildProcess::read_output() {
  std::array<char, 65536> buffer;
  while (output_fd_ >= 0) {
    const ssize_t count = read(output_fd_, buffer.data(), buffer.size());
    if (count > 0) {
      received_.append(buffer.data(), static_cast<std::size_t>(count));
    } else if (count < 0 && errno == EINTR) {
      continue;
    } else if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      return;
    } else {
      close(output_fd_);
      output_fd_ = -1;
    }
  }
}

bool ChildProcess::has_ended() {
  if (pid_ < 0) return true;
  siginfo_t info{};
  if (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
      info.si_pid != pid_) {
    return false;
  }
  kill(-pid_, SIGKILL);  // what it left behind; the number is its own until it is waited for
  int status = 0;
  rusage usage{};
  while (wait4(pid_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  read_output();
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  report_.cpu_time_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  report_.memory_max_mb = static_cast<double>(usage.ru_maxrss) / 1024;
  interpret(status);
  return true;
}

void ChildProcess::interpret(int wait_status) {
  using End = ChildReport::End;
  const auto* words = static_cast<const LastWords*>(last_words_);
  auto frame = parse_frame(received_);
  received_.clear();
  const bool left_in_order = WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == 0;
  const bool over_cpu_limit =
      WIFSIGNALED(wait_status) &&
      (WTERMSIG(wait_status) == SIGXCPU || (WTERMSIG(wait_status) == SIGKILL && !over_wall_limit_ &&
                                            report_.cpu_time_s >= cpu_limit_s_));
  if (frame && left_in_order && frame->kind == FrameKind::result) {
    report_.end = End::finished;
    report_.output = std::move(frame->payload);
  } else if (over_wall_limit_) {
    report_.end = End::wall_limit;
  } else if (over_cpu_limit) {
    report_.end = End::cpu_limit;
  } else if (words->allocation_refused || (frame && frame->kind == FrameKind::memory)) {
    report_.end = End::memory;
  } else if (frame && left_in_order) {
    report_.end = End::exception;
    report_.message = first_line(frame->payload);
  } else if (WIFEXITED(wait_status)) {
    report_.end = End::exited;
    report_.code = WEXITSTATUS(wait_status);
  } else {
    report_.end = End::signalled;
    report_.code = WTERMSIG(wait_status);
    report_.message = first_line(words->message.data());
    if (report_.message.empty()) report_.message = failed_assertion(error_fd_);
  }
}

void ChildProcess::enforce_wall_limit(Clock::time_point now) {
  if (pid_ < 0 || now < deadline_) return;
  kill(-pid_, over_wall_limit_ ? SIGKILL : SIGTERM);
  over_wall_limit_ = true;
  deadline_ = now + std::chrono::seconds(1);
}

ChildReport run_in_child(const ChildProcess::Work& work, const ProcessLimits& limits,
                         ChildProcess::Streams streams) {
  ChildProcess child(work, limits, streams);
  while (!child.has_ended()) {
    std::array<pollfd, 2> fds{pollfd{child.output_fd(), POLLIN, 0},
                              pollfd{child.process_fd(), POLLIN, 0}};
    poll(fds.data(), fds.size(), 50);
    child.read_output();
    child.enforce_wall_limit(ChildProcess::Clock::now());
  }
  return child.report();
}

}  // namespace voronaut
