#include "voronaut/benchmarks/isolation/process_tree.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <dirent.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace voronaut {

namespace {

constexpr double kBytesPerMb = 1024.0 * 1024.0;

std::string proc(pid_t pid, const char* name) {
  return "/proc/" + std::to_string(pid) + "/" + name;
}

template <class Use>
void for_each_entry(const std::string& folder, const Use& use) {
  DIR* stream = opendir(folder.c_str());
  if (stream == nullptr) return;
  while (const dirent* entry = readdir(stream))
    if (entry->d_name[0] != '.') use(folder + "/" + entry->d_name);
  closedir(stream);
}

double resident_mb(pid_t pid) {
  double pages = 0;
  if (std::FILE* file = std::fopen(proc(pid, "statm").c_str(), "re")) {
    if (std::fscanf(file, "%*s %lf", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / kBytesPerMb;
}

// Pages divided by the number of processes that share them.
struct Proportional {
  double anonymous_mb = 0;
  double shared_mb = 0;  // mappings of memory files and shared anonymous pages
};

Proportional proportional(pid_t pid) {
  Proportional found;
  std::FILE* file = std::fopen(proc(pid, "smaps_rollup").c_str(), "re");
  if (file == nullptr) return found;
  std::array<char, 256> line{};
  double kb = 0;
  while (std::fgets(line.data(), line.size(), file) != nullptr) {
    if (std::sscanf(line.data(), "Pss_Anon: %lf", &kb) == 1) found.anonymous_mb = kb / 1024;
    if (std::sscanf(line.data(), "Pss_Shmem: %lf", &kb) == 1) found.shared_mb = kb / 1024;
  }
  std::fclose(file);
  return found;
}

bool is_memory_file(const std::string& link) {
  std::array<char, 64> target{};
  if (readlink(link.c_str(), target.data(), target.size() - 1) <= 0) return false;
  return std::strncmp(target.data(), "/memfd:", 7) == 0 ||
         std::strncmp(target.data(), "/dev/shm/", 9) == 0;
}

double memory_files_mb(const std::vector<pid_t>& pids) {
  std::set<std::pair<dev_t, ino_t>> seen;
  double blocks = 0;  // of 512 bytes, whatever the file system's own
  for (const pid_t pid : pids) {
    for_each_entry(proc(pid, "fd"), [&](const std::string& link) {
      struct stat status {};
      if (is_memory_file(link) && stat(link.c_str(), &status) == 0 &&
          seen.emplace(status.st_dev, status.st_ino).second)
        blocks += static_cast<double>(status.st_blocks);
    });
  }
  return blocks * 512 / kBytesPerMb;
}

// 0 if it is gone.
pid_t parent_of(pid_t pid) {
  std::array<char, 512> text{};
  std::FILE* file = std::fopen(proc(pid, "stat").c_str(), "re");
  if (file == nullptr) return 0;
  const std::size_t size = std::fread(text.data(), 1, text.size() - 1, file);
  std::fclose(file);
  const std::string_view line(text.data(), size);
  const std::size_t name_end = line.rfind(')');  // a name may hold anything
  int parent = 0;
  if (name_end == std::string_view::npos ||
      std::sscanf(text.data() + name_end, ") %*c %d", &parent) != 1)
    return 0;
  return parent;
}

void add_children(pid_t parent, std::vector<pid_t>& list) {
  for_each_entry(proc(parent, "task"), [&](const std::string& task) {
    std::FILE* file = std::fopen((task + "/children").c_str(), "re");
    if (file == nullptr) return;
    pid_t child = 0;
    while (std::fscanf(file, "%d", &child) == 1) list.push_back(child);
    std::fclose(file);
  });
}

// For kernels that do not list the children of a task (CONFIG_PROC_CHILDREN).
std::multimap<pid_t, pid_t> children_by_parent() {
  std::multimap<pid_t, pid_t> children;
  for_each_entry("/proc", [&](const std::string& folder) {
    const pid_t pid = std::atoi(folder.c_str() + std::strlen("/proc/"));
    if (pid > 0) children.emplace(parent_of(pid), pid);
  });
  return children;
}

}  // namespace

std::vector<pid_t> descendants_of(pid_t root) {
  static const bool kListed =
      access(("/proc/self/task/" + std::to_string(getpid()) + "/children").c_str(), R_OK) == 0;
  std::vector<pid_t> list;
  if (kListed) {
    add_children(root, list);
    for (std::size_t i = 0; i < list.size(); ++i) add_children(list[i], list);
    return list;
  }
  const auto children = children_by_parent();
  const auto add = [&](pid_t parent) {
    const auto [begin, end] = children.equal_range(parent);
    for (auto child = begin; child != end; ++child) list.push_back(child->second);
  };
  add(root);
  for (std::size_t i = 0; i < list.size(); ++i) add(list[i]);
  return list;
}

TreeMemory::TreeMemory(pid_t bystander)
    : bystander_(bystander), resident_at_fork_mb_(resident_mb(bystander)) {}

double TreeMemory::in_use_mb(const std::vector<pid_t>& pids, double limit_mb) const {
  const double files = memory_files_mb(pids);
  double resident = files;
  for (const pid_t pid : pids) resident += std::max(resident_mb(pid) - resident_at_fork_mb_, 0.0);
  if (resident <= limit_mb) return resident;

  const Proportional not_its_own = proportional(bystander_);
  double anonymous = 0;
  double shared = 0;
  for (const pid_t pid : pids) {
    const Proportional part = proportional(pid);
    anonymous += std::max(part.anonymous_mb - not_its_own.anonymous_mb, 0.0);
    shared += std::max(part.shared_mb - not_its_own.shared_mb, 0.0);
  }
  return anonymous + std::max(shared, files);
}

void kill_descendants(pid_t root, pid_t spared) {
  const std::vector<pid_t> list = descendants_of(root);
  std::set<pid_t> family(list.begin(), list.end());
  family.insert(root);
  for (const pid_t pid : list) {
    if (pid == spared) continue;
    const int process = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
    if (process < 0 && errno == ESRCH) continue;
    if (family.count(parent_of(pid)) != 0 &&
        (process < 0 || syscall(SYS_pidfd_send_signal, process, SIGKILL, nullptr, 0) != 0))
      kill(pid, SIGKILL);  // a kernel without pidfd
    if (process >= 0) close(process);
  }
}

}  // namespace voronaut
