// Memory for large arrays, directly from the system.
#pragma once

#include <cstddef>

namespace circumspect::platform {

// So many bytes, all zero. Many of them are in large pages, if the system offers these, and
// untouched; few may come from the allocator. Throws std::bad_alloc.
void* map_memory(std::size_t bytes);
// Gives them back. Requires: map_memory gave `memory` for as many.
void unmap_memory(void* memory, std::size_t bytes);

}  // namespace circumspect::platform
