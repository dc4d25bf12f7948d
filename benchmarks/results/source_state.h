#pragma once

namespace voronaut {

// Filled in by the build, in a file of its own that alone is compiled again after a commit.
struct SourceState {
  const char* version;
  const char* commit;
  bool dirty;
  const char* build_type;
  const char* flags;
};

SourceState source_state();

}  // namespace voronaut
