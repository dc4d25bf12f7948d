#include <ostream>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/keys/json_schema.h"
#include "voronaut/benchmarks/keys/keys_page.h"

namespace voronaut {

ExitCode execute(const SchemaOptions& options, const CommandContext& context) {
  const FileKeys keys = file_keys(context.planners);
  if (options.format == "md")
    context.out << keys_page(keys);
  else
    context.out << (options.of == "suite" ? suite_schema(keys) : scenario_schema(keys));
  return ExitCode::success;
}

}  // namespace voronaut
