#include "voronaut/environments/config/input_file.h"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/config_tree.h"
#include "voronaut/environments/config/file_session.h"

namespace voronaut {
namespace {

class OpenFile {
 public:
  // Opening a pipe without a writer waits for one, unless it is told not to.
  explicit OpenFile(const std::string& path)
      : descriptor_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {}
  ~OpenFile() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  std::string problem() const {
    struct stat status {};
    if (descriptor_ < 0 || fstat(descriptor_, &status) != 0) return last_problem();
    if (S_ISDIR(status.st_mode)) return "is a folder";
    if (S_ISFIFO(status.st_mode)) return "is a pipe";
    if (!S_ISREG(status.st_mode)) return "is a device";
    return size_problem(status.st_size);
  }

  static std::string size_problem(std::int64_t bytes) {
    if (bytes <= kLargestInputFile_bytes) return "";
    return "has more than the " + std::to_string(kLargestInputFile_bytes) +
           " bytes that are read of a file";
  }

  static std::string last_problem() { return std::strerror(errno); }

  // The next bytes, as many as fit; 0 at the end, below 0 for a fault.
  ssize_t read_some(char* to, std::size_t size) const {
    ssize_t count = 0;
    do count = read(descriptor_, to, size);
    while (count < 0 && errno == EINTR);
    return count;
  }

 private:
  int descriptor_;
};

ConfigError unreadable(const std::string& path, const std::string& problem) {
  return {path, 0, "", "cannot be read (" + problem + ")"};
}

}  // namespace

std::string input_file_problem(const std::string& path) { return OpenFile(path).problem(); }

std::string read_bytes(const std::string& path) {
  if (const std::string* copy = FileSession::copy_of(path)) return *copy;
  const OpenFile file(path);
  if (const std::string problem = file.problem(); !problem.empty()) throw unreadable(path, problem);
  std::string bytes;
  // Files under /proc say that they have no bytes, and any file may grow while it is read.
  for (char chunk[1 << 16];;) {
    const ssize_t count = file.read_some(chunk, sizeof chunk);
    if (count < 0) throw unreadable(path, OpenFile::last_problem());
    if (count == 0) break;
    bytes.append(chunk, static_cast<std::size_t>(count));
    const auto size = static_cast<std::int64_t>(bytes.size());
    if (const std::string problem = OpenFile::size_problem(size); !problem.empty())
      throw unreadable(path, problem);
  }
  FileSession::note(path, bytes);
  return bytes;
}

std::string read_text_file(const std::string& path) {
  std::string text = read_bytes(path);
  require_utf8(text, path);
  return text;
}

}  // namespace voronaut
