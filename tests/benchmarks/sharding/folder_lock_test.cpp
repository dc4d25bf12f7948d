#include "voronaut/benchmarks/results/folder_lock.h"

#include <chrono>
#include <optional>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "voronaut/tests/support/temporary_folder.h"

namespace voronaut {
namespace {

TEST(FolderLock, WaitsForAHolderThatGoesAndForNoOther) {
  const TemporaryFolder folder;
  std::optional<FolderLock> held(std::in_place, folder.path());
  EXPECT_THROW(FolderLock(folder.path(), std::chrono::seconds(0)), std::invalid_argument);
  std::thread goes([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    held.reset();
  });
  EXPECT_NO_THROW(FolderLock(folder.path(), std::chrono::seconds(300)));
  goes.join();
}

}  // namespace
}  // namespace voronaut
