#include "platform/memory.hpp"

#include <cstdint>
#include <new>

#include <sys/mman.h>

#include "platform/posix/descriptors.hpp"

namespace circumspect::platform {

void* map_memory(std::size_t bytes) {
  constexpr std::size_t kPage = std::size_t{1} << 21;
  if (bytes > PTRDIFF_MAX - kPage) throw std::bad_alloc();
  void* const mapped =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  // Advises large pages only for pages within the array, so that no other memory is touched. The
  // system may ignore the advice.
  const auto begin = reinterpret_cast<std::uintptr_t>(mapped);
  const std::uintptr_t first = (begin + kPage - 1) / kPage * kPage,
                       last = (begin + bytes) / kPage * kPage;
  if (first < last) advise_large_pages(reinterpret_cast<void*>(first), last - first);
  return mapped;
}

void unmap_memory(void* memory, std::size_t bytes) { munmap(memory, bytes); }

}  // namespace circumspect::platform
