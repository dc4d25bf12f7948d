#include "voronaut/reports/store/pending_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include "voronaut/reports/store/sqlite.h"

namespace voronaut {

namespace {

constexpr std::size_t kFrameHeader = 13;

std::uint32_t crc_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

void append_number(std::string& bytes, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xffU);
}

std::uint64_t number_in(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;)
    value = (value << 8U) | static_cast<unsigned char>(bytes[i]);
  return value;
}

}  // namespace

PendingFile::~PendingFile() {
  if (fd_ >= 0) close(fd_);
}

void PendingFile::fail() const {
  throw StoreError(file_.string() + ": cannot write: " + std::strerror(errno));
}

void PendingFile::append(Kind kind, std::string_view payload) {
  if (fd_ < 0) {
    fd_ = open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (fd_ < 0) fail();
  }
  std::string frame(1, static_cast<char>(kind));
  append_number(frame, payload.size(), 8);
  append_number(frame, crc_of(payload), 4);
  frame += payload;
  for (std::size_t done = 0; done < frame.size();) {
    const ssize_t written = pwrite(fd_, frame.data() + done, frame.size() - done, size_);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail();
    done += static_cast<std::size_t>(written);
    size_ += written;
  }
}

void PendingFile::clear() {
  if (fd_ >= 0) close(fd_);
  fd_ = -1;
  size_ = 0;
  unlink(file_.c_str());
}

std::vector<PendingFile::Frame> PendingFile::read(const std::filesystem::path& file) {
  std::vector<Frame> frames;
  std::ifstream in(file, std::ios::binary);
  if (!in) return frames;
  std::ostringstream text;
  text << in.rdbuf();
  const std::string bytes = std::move(text).str();
  std::string_view rest = bytes;
  while (rest.size() >= kFrameHeader) {
    const std::uint64_t size = number_in(rest.substr(1, 8));
    const std::uint64_t crc = number_in(rest.substr(9, 4));
    const auto kind = static_cast<Kind>(rest.front());
    rest.remove_prefix(kFrameHeader);
    if (size > rest.size() || crc_of(rest.substr(0, size)) != crc) break;
    frames.push_back({kind, std::string(rest.substr(0, size))});
    rest.remove_prefix(size);
  }
  return frames;
}

}  // namespace voronaut
