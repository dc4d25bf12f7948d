#pragma once

#include <chrono>
#include <filesystem>

namespace voronaut {

// One folder, one runner. The lock is the kernel's (flock on the file `in-use` in the folder): it
// goes with the process however that ends. The file says who holds it and is deleted by a holder
// that ends in order; without a holder it means nothing.
class FolderLock {
 public:
  static constexpr const char* kFile = "in-use";

  // Throws std::invalid_argument that says who holds the folder, std::runtime_error where the file
  // system takes no lock.
  // `patience` is how long it waits for a holder to go.
  explicit FolderLock(const std::filesystem::path& folder, std::chrono::seconds patience = {});
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  std::filesystem::path file_;
  int fd_ = -1;
};

}  // namespace voronaut
