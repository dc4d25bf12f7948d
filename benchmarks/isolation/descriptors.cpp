#include "voronaut/benchmarks/isolation/descriptors.h"

#include <algorithm>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace voronaut {

namespace {

void close_between(unsigned int first, unsigned int last) {
  if (first > last || syscall(SYS_close_range, first, last, 0U) == 0) return;
  rlimit limit{};  // a kernel before 5.9
  getrlimit(RLIMIT_NOFILE, &limit);
  const auto end = static_cast<unsigned int>(std::min<rlim_t>(limit.rlim_cur, 1U << 16U));
  for (unsigned int fd = first; fd < end && fd <= last; ++fd) close(static_cast<int>(fd));
}

}  // namespace

void close_all_but(std::initializer_list<int> kept) {
  std::vector<int> sorted(kept);
  std::sort(sorted.begin(), sorted.end());
  unsigned int first = STDERR_FILENO + 1;
  for (const int fd : sorted) {
    if (fd <= STDERR_FILENO) continue;
    const auto number = static_cast<unsigned int>(fd);
    close_between(first, number - 1);
    first = number + 1;
  }
  close_between(first, ~0U);
}

int move_out_of_reach(int fd) {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  const auto number = static_cast<int>(std::min<rlim_t>(limit.rlim_cur / 2, 700));
  const int moved = fcntl(fd, F_DUPFD_CLOEXEC, number);
  close(fd);
  return moved;
}

}  // namespace voronaut
