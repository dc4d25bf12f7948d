#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

// What was in flight when a runner died without a word.
namespace voronaut {

// A file beside the results with one line for each trial in flight, written through a shared
// mapping: no system call, nothing to wait for, and it outlives the process, though not the
// machine. A runner that ends in any orderly way takes its marks back.
//
// A trial found in flight is a suspect: a runner that an operator killed looks the same. It is to
// be flown again with nothing beside it. One that was in flight alone as a suspect when the runner
// died again took it along.
class FlightMarks {
 public:
  enum class Suspicion { none, suspect, culprit };

  // Reads what an earlier runner left, or makes the file. One runner has it at a time. Throws
  // std::system_error that names the file.
  explicit FlightMarks(std::filesystem::path file);
  FlightMarks(const FlightMarks&) = delete;
  FlightMarks& operator=(const FlightMarks&) = delete;
  ~FlightMarks();  // deletes the file unless suspects are left

  Suspicion suspicion(std::string_view trial_id) const;

  // Before the fork. `alone`: nothing else is in flight, and it is a suspect. Ids have at most
  // kIdBytes; up to kFlightsMax marks are set at a time, what is beyond goes without.
  void takes_off(std::string_view trial_id, bool alone);
  // Its result is here: what happens from now on is not its doing.
  void landed(std::string_view trial_id);
  // Its row is stored.
  void stored(std::string_view trial_id);

  static constexpr std::size_t kIdBytes = 64;
  static constexpr std::size_t kFlightsMax = 2048;

 private:
  struct Line;
  Line& line(std::size_t index) const;
  void take_back_flights();

  std::filesystem::path file_;
  void* lines_ = nullptr;
  std::map<std::string, std::size_t, std::less<>> line_of_;
};

}  // namespace voronaut
