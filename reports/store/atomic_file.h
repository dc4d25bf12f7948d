#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string_view>

namespace voronaut {

// Writes to a temporary file in the same folder and renames it, so that a reader sees the old text
// or the new one, never a part. Throws std::runtime_error that names the file and the system's
// reason.
void write_file_atomically(const std::filesystem::path& file, std::string_view text);
// The same of what `write` puts into the stream.
void write_file_atomically(const std::filesystem::path& file,
                           const std::function<void(std::ostream&)>& write);

}  // namespace voronaut
