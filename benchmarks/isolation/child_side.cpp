#include "voronaut/benchmarks/isolation/child_side.h"

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "voronaut/benchmarks/isolation/descriptors.h"
#include "voronaut/benchmarks/isolation/namespaces.h"

namespace voronaut {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

LastWords* g_last_words = nullptr;  // handlers take no argument; one child, one page

void note_refused_allocation() {
  g_last_words->allocation_refused = true;
  throw std::bad_alloc();
}

void note_message(const char* text) {
  auto& message = g_last_words->message;
  std::strncpy(message.data(), text, message.size() - 1);
}

[[noreturn]] void note_uncaught_exception() {
  if (const std::exception_ptr current = std::current_exception()) {
    try {
      std::rethrow_exception(current);
    } catch (const std::bad_alloc&) {
      g_last_words->allocation_refused = true;
    } catch (const std::exception& error) {
      note_message(error.what());
    } catch (...) {
      note_message("an exception that is no std::exception");
    }
  }
  std::abort();
}

void set_limit(__rlimit_resource resource, double soft, double hard) {
  const rlimit limit{static_cast<rlim_t>(soft), static_cast<rlim_t>(hard)};
  setrlimit(resource, &limit);
}

void set_limits(const ProcessLimits& limits, double inherited_bytes) {
  if (!kSanitized) {
    const double bytes = inherited_bytes + limits.memory_mb * 1024 * 1024;
    set_limit(RLIMIT_AS, bytes, bytes);
  }
  const double seconds = std::ceil(limits.cpu_s);
  set_limit(RLIMIT_CPU, seconds, seconds + 1);
  set_limit(RLIMIT_CORE, 0, 0);
}

void reset_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGXCPU, SIGXFSZ, SIGHUP}) std::signal(signal, SIG_DFL);
  std::signal(SIGPIPE, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

// Standard error of a sanitized build stays visible: it is where the sanitizer reports.
void silence_streams(int error_fd) {
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing >= 0) {
    dup2(nothing, STDIN_FILENO);
    dup2(nothing, STDOUT_FILENO);
  }
  if (kSanitized || error_fd < 0) return;
  fcntl(error_fd, F_SETFL, 0);
  lseek(error_fd, 0, SEEK_SET);
  dup2(error_fd, STDERR_FILENO);
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void send(int fd, FrameKind kind, std::string_view payload) {
  if (write_all(fd, frame_header(kind, payload.size()))) write_all(fd, payload);
}

}  // namespace

MemorySize own_memory() {
  std::array<char, 128> text{};
  double total = 0;
  double resident = 0;
  const int fd = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (fd < 0) return {};
  if (read(fd, text.data(), text.size() - 1) <= 0 ||
      std::sscanf(text.data(), "%lf %lf", &total, &resident) != 2)
    total = resident = 0;
  close(fd);
  const auto page = static_cast<double>(sysconf(_SC_PAGESIZE));
  return {total * page, resident * page / (1024 * 1024)};
}

void run_child_side(const ChildProcess::Work& work, const ProcessLimits& limits,
                    const ChildSide& side) {
  setsid();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != side.parent) _exit(1);  // the guard died before that held
  reset_signals();
  if (side.streams == ChildProcess::Streams::silent) silence_streams(side.error_fd);
  const int output_fd = move_out_of_reach(side.output_fd);
  fcntl(output_fd, F_SETFL, 0);  // what an earlier child did to the pipe is not for this one
  close_all_but({output_fd});
  give_up_mounting();
  g_last_words = side.last_words;
  std::set_new_handler(note_refused_allocation);
  std::set_terminate(note_uncaught_exception);
  set_limits(limits, side.inherited_bytes);

  try {
    send(output_fd, FrameKind::result, work());
  } catch (const std::bad_alloc&) {
    send(output_fd, FrameKind::memory, {});
  } catch (const std::exception& error) {
    send(output_fd, FrameKind::exception, error.what());
  } catch (...) {
    send(output_fd, FrameKind::exception, "an exception that is no std::exception");
  }
  std::fflush(nullptr);
  _exit(0);
}

std::string frame_header(FrameKind kind, std::size_t payload_size) {
  std::string header(1, static_cast<char>(kind));
  for (int byte = 0; byte < 8; ++byte) {
    header += static_cast<char>((payload_size >> (8 * byte)) & 0xffU);
  }
  return header;
}

std::optional<Frame> parse_frame(std::string_view bytes) {
  if (bytes.size() < 9) return std::nullopt;
  std::uint64_t size = 0;
  for (std::size_t byte = 0; byte < 8; ++byte) {
    size |= std::uint64_t{static_cast<unsigned char>(bytes[1 + byte])} << (8 * byte);
  }
  if (bytes.size() - 9 < size) return std::nullopt;
  return Frame{static_cast<FrameKind>(bytes[0]), std::string(bytes.substr(9, size))};
}

}  // namespace voronaut
