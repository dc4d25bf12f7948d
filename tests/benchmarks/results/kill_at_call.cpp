#include <atomic>
#include <csignal>
#include <cstdlib>

#include <dlfcn.h>
#include <unistd.h>

// Preloaded into a program: kills it at the beginning of the n-th of its calls that change what is
// on the disk, n from VORONAUT_KILL_AT_CALL. Calls of its children do not count.
namespace {

const pid_t kOwner = getpid();

void count() {
  static std::atomic<long> left{std::atol(std::getenv("VORONAUT_KILL_AT_CALL"))};
  if (getpid() == kOwner && --left == 0) kill(kOwner, SIGKILL);
}

template <class Function>
Function original(const char* name) {
  count();
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int fdatasync(int fd) { return original<int (*)(int)>("fdatasync")(fd); }
int fsync(int fd) { return original<int (*)(int)>("fsync")(fd); }
int unlink(const char* path) noexcept { return original<int (*)(const char*)>("unlink")(path); }
int rename(const char* from, const char* to) noexcept {
  return original<int (*)(const char*, const char*)>("rename")(from, to);
}
ssize_t pwrite(int fd, const void* bytes, size_t size, off_t offset) {
  return original<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite")(fd, bytes, size, offset);
}
ssize_t pwrite64(int fd, const void* bytes, size_t size, off64_t offset) {
  return original<ssize_t (*)(int, const void*, size_t, off64_t)>("pwrite64")(fd, bytes, size,
                                                                              offset);
}
}
