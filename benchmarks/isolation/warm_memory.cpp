#include "voronaut/benchmarks/isolation/warm_memory.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string_view>

#include <fcntl.h>
#include <link.h>
#include <unistd.h>

namespace voronaut {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kUnderSanitizer = true;
#else
constexpr bool kUnderSanitizer = false;
#endif

// Allocates and never frees until allocations come from behind the heap's old end, large gaps
// first. A bound on their number ends it where the allocator is another.
void fill_gaps_of_heap() {
  const auto old_end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  constexpr int kGapsMax = 20'000;
  int filled = 0;
  for (std::size_t size = std::size_t{64} << 10U; size >= 16;
       size = size > 1024 ? size / 2 : size - 16) {
    for (; filled < kGapsMax; ++filled) {
      void* const gap = std::malloc(size);
      const auto at = reinterpret_cast<std::uintptr_t>(gap);
      if (at < old_end && gap != nullptr) continue;
      std::free(gap);
      break;
    }
  }
}

bool runs_trials(std::string_view object) {
  if (object.empty()) return true;  // the program itself
  const std::string_view name = object.substr(object.rfind('/') + 1);
  for (const std::string_view library : {"libompl.so", "libstdc++.so", "libc.so", "libm.so"})
    if (name.starts_with(library)) return true;
  return false;
}

// A fork copies the page table of a file's mapping, as far as it was used here, only where one of
// its pages is the process's own, which writing a byte over itself makes it.
int map_for_children(dl_phdr_info* object, std::size_t, void* memory) {
  if (!runs_trials(object->dlpi_name)) return 0;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_LOAD || (segment.p_flags & PF_W) != 0) continue;
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const std::uintptr_t begin = (object->dlpi_addr + segment.p_vaddr) & ~(page - 1);
    char byte = 0;
    const int fd = *static_cast<const int*>(memory);
    const auto at = static_cast<off_t>(begin);
    if (pread(fd, &byte, 1, at) == 1) static_cast<void>(!pwrite(fd, &byte, 1, at));
  }
  return 0;
}

void map_code() {
  int memory = open("/proc/self/mem", O_RDWR | O_CLOEXEC);
  if (memory < 0) return;
  dl_iterate_phdr(map_for_children, &memory);
  close(memory);
}

}  // namespace

void warm_memory() {
  std::once_flag flag;
  std::call_once(flag, [] {});  // the loader looks it up here, not in each child
  if (kUnderSanitizer) return;  // whose allocator and memory are not these
  fill_gaps_of_heap();
  map_code();
}

}  // namespace voronaut
