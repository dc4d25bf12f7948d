#pragma once

#include <map>
#include <string>

namespace voronaut {

// What lies behind the files that configurations and worlds are read from, as long as it lives:
// copies first, where there are any, else the disk. It notes what was read, so that results can
// keep copies of all they came from. One at a time in a process; without one the disk alone is
// read.
class FileSession {
 public:
  using Files = std::map<std::string, std::string>;  // bytes by absolute path

  explicit FileSession(Files copies = {});
  FileSession(const FileSession&) = delete;
  FileSession& operator=(const FileSession&) = delete;
  ~FileSession();

  const Files& read() const { return read_; }

  // For readers of files. The copy of a file, null if there is none.
  static const std::string* copy_of(const std::string& path);
  static bool has_copies();
  static void note(const std::string& path, const std::string& bytes);

 private:
  Files copies_;
  Files read_;
};

}  // namespace voronaut
