#include "voronaut/benchmarks/results/folder_lock.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace voronaut {

namespace {

std::string holder_text() {
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> time{};
  std::strftime(time.data(), time.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return "process " + std::to_string(getpid()) + " on " + host.data() + " since " + time.data();
}

std::string text_in(int fd) {
  std::array<char, 512> text{};
  const ssize_t size = pread(fd, text.data(), text.size(), 0);
  const std::string found(text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  return found.substr(0, found.find('\n'));
}

// Whether the name still leads to the file that was locked, not to a later one.
bool is_file_of(int fd, const std::filesystem::path& path) {
  struct stat locked {};
  struct stat named {};
  return fstat(fd, &locked) == 0 && stat(path.c_str(), &named) == 0 &&
         locked.st_ino == named.st_ino && locked.st_dev == named.st_dev;
}

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw std::runtime_error(file.string() + ": cannot be locked: " + std::strerror(errno));
}

// Who has the file of a descriptor locked, which is closed then; empty if nobody has and it is
// ours.
std::string holder_of(int fd, const std::filesystem::path& file) {
  if (flock(fd, LOCK_EX | LOCK_NB) == 0) return {};
  const int reason = errno;
  const std::string holder = text_in(fd);
  close(fd);
  errno = reason;
  if (reason != EWOULDBLOCK) fail(file);
  return holder.empty() ? "another process" : holder;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, std::chrono::seconds patience)
    : file_(folder / kFile) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (true) {
    fd_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (fd_ < 0) fail(file_);
    const std::string holder = holder_of(fd_, file_);
    if (holder.empty()) {
      if (is_file_of(fd_, file_)) break;
      close(fd_);  // its holder deleted it between our two calls
    } else if (std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    } else {
      throw std::invalid_argument(folder.string() + ": in use by " + holder +
                                  "; wait for it or give another --out");
    }
  }
  // Who holds it is a help, not the lock: a full disk is no reason to stop here.
  const std::string text = holder_text() + "\n";
  if (ftruncate(fd_, 0) != 0 || pwrite(fd_, text.data(), text.size(), 0) < 0) errno = 0;
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : file_(std::move(other.file_)), fd_(std::exchange(other.fd_, -1)) {}

FolderLock::~FolderLock() {
  if (fd_ < 0) return;
  if (is_file_of(fd_, file_)) unlink(file_.c_str());
  close(fd_);
}

}  // namespace voronaut
