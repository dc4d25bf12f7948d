#include "voronaut/benchmarks/isolation/flight_marks.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace voronaut {

namespace {

constexpr char kFree = '\0';
constexpr char kFlying = 'F';
constexpr char kAlone = 'A';
constexpr char kLanded = 'L';
constexpr char kSuspect = 'S';
constexpr char kCulprit = 'C';

}  // namespace

// Text, so that a person can read the file.
struct FlightMarks::Line {
  volatile char state;
  char blank;
  std::array<char, kIdBytes> trial_id;  // padded with blanks
  char end;
};

FlightMarks::FlightMarks(std::filesystem::path file) : file_(std::move(file)) {
  constexpr std::size_t kBytes = kFlightsMax * sizeof(Line);
  const int fd = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  int error = fd < 0 ? errno : 0;
  if (error == 0) error = posix_fallocate(fd, 0, kBytes);  // a store into a hole could fail
  if (error == 0) {
    lines_ = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    if (lines_ == MAP_FAILED) error = errno;
  }
  if (fd >= 0) close(fd);
  if (error != 0)
    throw std::system_error(error, std::generic_category(), file_.string() + ": cannot write");
  madvise(lines_, kBytes, MADV_DONTFORK);  // no child can reach it

  for (std::size_t i = 0; i < kFlightsMax; ++i) {
    Line& found = line(i);
    if (found.state == kFlying) found.state = kSuspect;
    if (found.state == kAlone) found.state = kCulprit;
    if (found.state != kSuspect && found.state != kCulprit) {
      found.state = kFree;
      continue;
    }
    const std::string_view id(found.trial_id.data(), kIdBytes);
    line_of_.emplace(id.substr(0, id.find(' ')), i);
  }
}

FlightMarks::~FlightMarks() {
  take_back_flights();
  std::error_code ignored;
  if (line_of_.empty()) std::filesystem::remove(file_, ignored);
  munmap(lines_, kFlightsMax * sizeof(Line));
}

// A suspect that was dropped in its second flight remains one.
void FlightMarks::take_back_flights() {
  for (auto mark = line_of_.begin(); mark != line_of_.end();) {
    Line& its = line(mark->second);
    if (its.state == kAlone) its.state = kSuspect;
    const bool keep = its.state == kSuspect || its.state == kCulprit;
    if (!keep) its.state = kFree;
    mark = keep ? std::next(mark) : line_of_.erase(mark);
  }
}

FlightMarks::Line& FlightMarks::line(std::size_t index) const {
  return static_cast<Line*>(lines_)[index];
}

FlightMarks::Suspicion FlightMarks::suspicion(std::string_view trial_id) const {
  const auto mark = line_of_.find(trial_id);
  if (mark == line_of_.end()) return Suspicion::none;
  const char state = line(mark->second).state;
  return state == kCulprit   ? Suspicion::culprit
         : state == kSuspect ? Suspicion::suspect
                             : Suspicion::none;
}

void FlightMarks::takes_off(std::string_view trial_id, bool alone) {
  auto mark = line_of_.find(trial_id);
  if (mark == line_of_.end()) {
    std::size_t index = 0;
    while (index < kFlightsMax && line(index).state != kFree) ++index;
    if (index == kFlightsMax || trial_id.size() > kIdBytes) return;
    mark = line_of_.emplace(trial_id, index).first;
    Line& its = line(index);
    its.blank = ' ';
    its.end = '\n';
    its.trial_id.fill(' ');
    std::copy(trial_id.begin(), trial_id.end(), its.trial_id.begin());
  }
  line(mark->second).state = alone ? kAlone : kFlying;  // last: a line is whole or free
}

void FlightMarks::landed(std::string_view trial_id) {
  const auto mark = line_of_.find(trial_id);
  if (mark != line_of_.end()) line(mark->second).state = kLanded;
}

void FlightMarks::stored(std::string_view trial_id) {
  const auto mark = line_of_.find(trial_id);
  if (mark == line_of_.end()) return;
  line(mark->second).state = kFree;
  line_of_.erase(mark);
}

}  // namespace voronaut
