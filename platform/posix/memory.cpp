#include "platform/memory.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>

#include <sys/mman.h>

#include "platform/posix/descriptors.hpp"

namespace circumspect::platform {
namespace {

// To map and clear fewer bytes than that takes longer than to judge the small mesh that needs them.
constexpr std::size_t kLeastMapped = std::size_t{1} << 16;

void* allocate_zeros(std::size_t bytes) {
  constexpr std::size_t kCacheLine = 64;
  const std::size_t rounded = (bytes + kCacheLine - 1) / kCacheLine * kCacheLine;
  auto* const memory = static_cast<char*>(std::aligned_alloc(kCacheLine, rounded));
  if (memory == nullptr) throw std::bad_alloc();
  std::fill_n(memory, bytes, '\0');
  return memory;
}

}  // namespace

void* map_memory(std::size_t bytes) {
  if (bytes < kLeastMapped) return allocate_zeros(bytes);
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

void unmap_memory(void* memory, std::size_t bytes) {
  if (bytes < kLeastMapped) {
    std::free(memory);
  } else {
    munmap(memory, bytes);
  }
}

}  // namespace circumspect::platform
