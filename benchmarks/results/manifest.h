#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "voronaut/benchmarks/suite/suite_config.h"
#include "voronaut/environments/config/file_session.h"

namespace voronaut {

// A suite file as text with what the command line changed about it: enough to read it again, at any
// time, from a folder of results.
struct SuiteSource {
  std::string file;  // as its messages and its relative paths need it
  std::string text;
  std::string data_argument;
  std::string seed;         // replaces the suite's; empty: not given
  std::string repetitions;  // the same
  // Copies of the files that it names, by absolute path: taken when it is read first, read from
  // then on, so that it is the same suite wherever and whenever.
  FileSession::Files files{};
  std::vector<std::string> set{};  // "path=value" each: replaces what the file says (suite_paths.h)

  // The suite's root with what it includes and what is set. Throws ConfigError.
  ConfigNode root() const;
  // Throws ConfigError, std::invalid_argument.
  SuiteConfig read(const PlannerCatalog& planners);
};

// The full configuration with every default, as JSON with a fixed order of keys.
std::string suite_json(const SuiteConfig& suite);

// The part of it that decides results: without repetitions, limits, traces and where data lies.
nlohmann::ordered_json defining_json(const SuiteConfig& suite);

// SHA-256 over what a folder of results must agree about: the whole suite but for repetitions,
// limits and traces. Rows of two suites with different identities do not belong into one table.
std::string suite_identity(const SuiteConfig& suite);

// manifest.json: the shard if it is one, build, machine, command, configuration, the suite's text.
std::string manifest_json(const SuiteSource& source, const SuiteConfig& suite,
                          const std::vector<std::string>& command, const std::string& started_utc,
                          const std::string& shard = {});

}  // namespace voronaut
