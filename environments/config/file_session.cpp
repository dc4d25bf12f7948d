#include "voronaut/environments/config/file_session.h"

#include <cassert>
#include <filesystem>
#include <utility>

namespace voronaut {

namespace {

FileSession* g_session = nullptr;

std::string key_of(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

}  // namespace

FileSession::FileSession(Files copies) : copies_(std::move(copies)) {
  assert(g_session == nullptr);
  g_session = this;
}

FileSession::~FileSession() { g_session = nullptr; }

const std::string* FileSession::copy_of(const std::string& path) {
  if (!has_copies()) return nullptr;
  const auto copy = g_session->copies_.find(key_of(path));
  return copy == g_session->copies_.end() ? nullptr : &copy->second;
}

bool FileSession::has_copies() { return g_session != nullptr && !g_session->copies_.empty(); }

void FileSession::note(const std::string& path, const std::string& bytes) {
  if (g_session != nullptr) g_session->read_.insert_or_assign(key_of(path), bytes);
}

}  // namespace voronaut
