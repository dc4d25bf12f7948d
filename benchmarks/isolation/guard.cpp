#include "voronaut/benchmarks/isolation/guard.h"

#include <algorithm>
#include <cerrno>
#include <csignal>

#include <poll.h>
#include <sys/ipc.h>
#include <sys/msg.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/wait.h>
#include <unistd.h>

#include "voronaut/benchmarks/isolation/process_tree.h"
#include "voronaut/benchmarks/isolation/warm_memory.h"

namespace voronaut {

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

bool is_gone(int other_side) {
  pollfd asked{other_side, 0, 0};
  return poll(&asked, 1, 0) > 0 && (asked.revents & (POLLERR | POLLHUP)) != 0;
}

// Orphans become children of the guard, which is their subreaper or the first process of their
// namespace: nobody is left when it has no child.
void leave_no_child(bool own_namespaces) {
  while (waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD) {
    if (own_namespaces) {
      kill(-1, SIGKILL);  // all in the namespace but its first process
    } else {
      kill_descendants(getpid(), 0);
    }
    usleep(200);
  }
}

// System V memory, semaphores and queues outlive who made them.
bool leavings_in_memory() {
  shm_info shared{};
  seminfo semaphores{};
  msginfo queues{};
  union {
    seminfo* info;
  } argument{&semaphores};
  return (shmctl(0, SHM_INFO, reinterpret_cast<shmid_ds*>(&shared)) >= 0 && shared.used_ids > 0) ||
         (semctl(0, 0, SEM_INFO, argument) >= 0 && semaphores.semusz > 0) ||
         (msgctl(0, MSG_INFO, reinterpret_cast<msqid_ds*>(&queues)) >= 0 && queues.msgpool > 0);
}

void prepare(const ChildSeries::Task& task) {
  if (!task.prepare) return;
  try {
    task.prepare();
  } catch (...) {  // the work meets the same, where it is looked at
  }
}

ChildEnd run_child(const Guarded& guarded, const ChildSeries::Task& task) {
  ChildEnd end;
  prepare(task);
  const MemorySize own = own_memory();
  ChildSide side = guarded.supervised.child;
  side.parent = getpid();
  side.inherited_bytes = own.address_space_bytes;
  const pid_t child = fork();
  if (child == 0) run_child_side(task.work, guarded.supervised.limits, side);
  if (child < 0) {
    end.error = errno;
    return end;
  }
  for (pid_t ended = 0; ended != child;) {
    rusage usage{};
    ended = wait4(-1, &end.wait_status, 0, &usage);
    if (ended < 0 && errno != EINTR) _exit(1);
    end.cpu_time_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    end.memory_max_mb =
        std::max(static_cast<double>(usage.ru_maxrss) / 1024 - own.resident_mb, 0.0);
  }
  leave_no_child(guarded.own_namespaces);
  end.spoilt = guarded.own_namespaces && leavings_in_memory();
  return end;
}

}  // namespace

void guard(const Guarded& guarded) {
  setsid();
  prctl(PR_SET_NAME, "voronaut-guard");
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  if (is_gone(guarded.supervisor_fd)) _exit(1);  // the supervisor died before that held
  if (guarded.supervised.tasks.size() > 1) warm_memory();
  for (const ChildSeries::Task& task : guarded.supervised.tasks) {
    char go = 0;
    if (read(guarded.supervisor_fd, &go, 1) != 1) _exit(0);
    const ChildEnd end = run_child(guarded, task);
    if (write(guarded.supervisor_fd, &end, sizeof end) != sizeof end) _exit(1);
  }
  pause();  // until the supervisor ends it: it may not see the other side gone before it has read
  _exit(0);
}

}  // namespace voronaut
