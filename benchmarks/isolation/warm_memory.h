#pragma once

namespace voronaut {

// Makes the calling process a parent whose children need few page faults: their allocations lie
// together, not in the gaps of its heap, of which each would cost them the copy of a page; the code
// that trials run is mapped for them; functions that are looked up at their first call have been.
// Changes nothing that a program can see, and does what the system allows.
void warm_memory();

}  // namespace voronaut
