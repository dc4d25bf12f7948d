#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "voronaut/benchmarks/isolation/child_process.h"

// What happens on the child's side of a ChildProcess, and the little language the two sides speak.
namespace voronaut {

// In a page that both processes see: survives however the child ends.
struct LastWords {
  std::atomic<bool> allocation_refused{false};
  std::array<char, 1024> message{};  // zero-terminated; of an exception that nobody caught
};

// What a process holds, as /proc/self/statm says it.
struct MemorySize {
  double address_space_bytes = 0;
  double resident_mb = 0;
};
MemorySize own_memory();

struct ChildSide {
  int output_fd;
  int error_fd;  // becomes standard error
  LastWords* last_words;
  ChildProcess::Streams streams;
  pid_t parent = 0;            // the guard, by the number that the child sees
  double inherited_bytes = 0;  // of address space, when it was forked
};

// Closes all but its pipe, sets the limits, does the work, writes one frame and leaves with _exit.
[[noreturn]] void run_child_side(const ChildProcess::Work& work, const ProcessLimits& limits,
                                 const ChildSide& side);

enum class FrameKind : char { result = 'R', exception = 'E', memory = 'M' };

struct Frame {
  FrameKind kind;
  std::string payload;
};

// Kind, length (8 bytes, little endian), payload.
std::string frame_header(FrameKind kind, std::size_t payload_size);
// Empty unless `bytes` begins with a whole frame.
std::optional<Frame> parse_frame(std::string_view bytes);

}  // namespace voronaut
