#include "platform/memory.hpp"

#include <new>

#include <windows.h>

namespace circumspect::platform {

// Large pages need a right that users do not have.
void* map_memory(std::size_t bytes) {
  void* const memory = VirtualAlloc(nullptr, bytes, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void unmap_memory(void* memory, std::size_t /*bytes*/) { VirtualFree(memory, 0, MEM_RELEASE); }

}  // namespace circumspect::platform
