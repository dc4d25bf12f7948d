#include "voronaut/benchmarks/isolation/stop_signals.h"

#include <cerrno>
#include <system_error>

#include <sys/signalfd.h>
#include <unistd.h>

namespace voronaut {

StopSignals::StopSignals() {
  sigemptyset(&watched_);
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaddset(&watched_, signal);
  sigprocmask(SIG_BLOCK, &watched_, &before_);
  fd_ = signalfd(-1, &watched_, SFD_CLOEXEC | SFD_NONBLOCK);
  if (fd_ < 0) {
    const std::error_code why(errno, std::generic_category());
    sigprocmask(SIG_SETMASK, &before_, nullptr);
    throw std::system_error(why, "watching for signals");
  }
}

StopSignals::~StopSignals() {
  received();
  close(fd_);
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

bool StopSignals::received() {
  signalfd_siginfo info;
  while (read(fd_, &info, sizeof info) == static_cast<ssize_t>(sizeof info)) {
    received_ = true;
    interrupted_ = interrupted_ || info.ssi_signo == SIGINT;
  }
  return received_;
}

}  // namespace voronaut
