#pragma once

#include <string>
#include <string_view>

#include "voronaut/reports/run_record.h"

namespace voronaut {

// A record bit for bit, and its trace as the store keeps it: what a child sends to the runner, and
// what is on its way into the database.
struct PackedTrial {
  RunRecord record;
  std::string trace_blob;  // of compress_trace(); empty: none
};

std::string pack(const PackedTrial& trial);
// Throws std::invalid_argument for bytes that pack() does not make.
PackedTrial unpack(std::string_view bytes);

}  // namespace voronaut
