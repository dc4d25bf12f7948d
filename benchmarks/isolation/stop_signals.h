#pragma once

#include <csignal>

namespace voronaut {

// SIGINT, SIGTERM and SIGUSR1 become readable instead of deadly, as long as this lives. Those that
// were read are not sent on when it goes.
class StopSignals {
 public:
  // Throws std::system_error where the system has no descriptor for it.
  StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  ~StopSignals();

  int fd() const { return fd_; }  // for poll()

  bool received();                                   // at least one, ever
  bool interrupted() const { return interrupted_; }  // one of those was SIGINT

 private:
  sigset_t watched_{};
  sigset_t before_{};
  int fd_ = -1;
  bool received_ = false;
  bool interrupted_ = false;
};

}  // namespace voronaut
