#include "voronaut/benchmarks/isolation/namespaces.h"

#include <array>
#include <cstdio>
#include <string>

#include <fcntl.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace voronaut {

namespace {

bool write_text(const char* file, const std::string& text) {
  const int fd = open(file, O_WRONLY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool written = write(fd, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  close(fd);
  return written;
}

bool keep_own_numbers(uid_t user, gid_t group) {
  const auto same = [](auto id) { return std::to_string(id) + " " + std::to_string(id) + " 1"; };
  return write_text("/proc/self/setgroups", "deny") &&
         write_text("/proc/self/uid_map", same(user)) &&
         write_text("/proc/self/gid_map", same(group));
}

bool unshare_all() {
  constexpr int kAll = CLONE_NEWNS | CLONE_NEWPID | CLONE_NEWIPC;
  if (unshare(kAll) == 0) return true;
  const uid_t user = geteuid();
  const gid_t group = getegid();
  return unshare(kAll | CLONE_NEWUSER) == 0 && keep_own_numbers(user, group);
}

// Flags that a mount has already may not be taken from it in a user namespace.
unsigned long flags_of(const std::string& folder) {
  struct statvfs status {};
  if (statvfs(folder.c_str(), &status) != 0) return 0;
  constexpr std::array<std::pair<unsigned long, unsigned long>, 6> kSame{
      {{ST_NOSUID, MS_NOSUID},
       {ST_NODEV, MS_NODEV},
       {ST_NOEXEC, MS_NOEXEC},
       {ST_NOATIME, MS_NOATIME},
       {ST_NODIRATIME, MS_NODIRATIME},
       {ST_RELATIME, MS_RELATIME}}};
  unsigned long flags = 0;
  for (const auto& [stated, wanted] : kSame)
    if ((status.f_flag & stated) != 0) flags |= wanted;
  return flags;
}

bool make_read_only(const std::string& folder) {
  return mount(folder.c_str(), folder.c_str(), nullptr, MS_BIND, nullptr) == 0 &&
         mount(nullptr, folder.c_str(), nullptr,
               MS_BIND | MS_REMOUNT | MS_RDONLY | flags_of(folder), nullptr) == 0;
}

}  // namespace

Namespaces enter_namespaces(const std::vector<std::filesystem::path>& read_only) {
  Namespaces entered;
  if (!unshare_all()) return entered;
  entered.processes = true;
  entered.mounts = mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0;
  for (const std::filesystem::path& folder : read_only)
    entered.mounts = entered.mounts && make_read_only(folder.string());
  // The working folder is held by the mount that it was entered through.
  std::error_code ignored;
  const std::filesystem::path here = std::filesystem::current_path(ignored);
  if (!here.empty()) std::filesystem::current_path(here, ignored);
  return entered;
}

void give_up_mounting() {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> sets{};
  if (syscall(SYS_capget, &header, sets.data()) != 0) return;
  auto& low = sets[CAP_TO_INDEX(CAP_SYS_ADMIN)];
  const unsigned int others = ~CAP_TO_MASK(CAP_SYS_ADMIN);
  low.effective &= others;
  low.permitted &= others;
  low.inheritable &= others;
  syscall(SYS_capset, &header, sets.data());
}

}  // namespace voronaut
