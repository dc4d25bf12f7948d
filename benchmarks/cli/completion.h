#pragma once

#include <string>
#include <vector>

// What completes the program's commands in a shell, made of the commands themselves.
namespace voronaut {

const std::vector<std::string>& completed_shells();

// For bash a file to source, or for share/bash-completion/completions/voronaut; for zsh `_voronaut`
// in a folder of $fpath; for fish a file for vendor_completions.d. Names of what ships and of what
// plans and flies are asked of the program when they are needed.
std::string completion_script(const std::string& shell);

}  // namespace voronaut
