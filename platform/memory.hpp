// Memory for large arrays, directly from the system.
#pragma once

#include <cstddef>

namespace circumspect::platform {

// So many bytes, in large pages if the system offers them, and touched by nobody yet. Throws
// std::bad_alloc.
void* map_memory(std::size_t bytes);
// Returns them to the system. Requires: map_memory gave `memory` for as many.
void unmap_memory(void* memory, std::size_t bytes);

}  // namespace circumspect::platform
