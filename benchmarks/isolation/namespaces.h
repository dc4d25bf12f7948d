#pragma once

#include <filesystem>
#include <vector>

// What Linux offers a process to shut itself in, where it is allowed to.
namespace voronaut {

struct Namespaces {
  bool processes = false;  // children of the caller see no process outside, and end with the first
  bool mounts = false;     // the folders are read-only for the caller and its children
};

// Puts the calling process (of one thread) into namespaces of its own: process numbers for the
// children it will have, mounts, System V memory. As root directly, else through a user namespace
// of its own, where its user keeps its number. What the system refuses is left out.
Namespaces enter_namespaces(const std::vector<std::filesystem::path>& read_only);

// Gives up the right to mount, so that what is read-only stays so.
void give_up_mounting();

}  // namespace voronaut
