// Memory for large arrays. Not initialized, so that the threads that write it touch it first; in large pages,
// where the system has them for the asking: what is written all over an array then misses fewer translations
// of addresses, and first touches are fewer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <type_traits>

#include <sys/mman.h>

namespace circumspect::fast {

struct Unmapped {
  std::size_t bytes = 0;

  void operator()(void* memory) const { munmap(memory, bytes); }
};

// T[] of a type that needs neither constructor nor destructor.
template <typename T>
using LargeArray = std::unique_ptr<T[], Unmapped>;

// Straight from the system, and back to it: what an allocator keeps would count as memory in use. Throws
// std::bad_alloc.
template <typename T>
LargeArray<T> large_array(std::size_t count) {
  static_assert(std::is_trivial_v<T>);
  constexpr std::size_t kPage = std::size_t{1} << 21;
  if (count > PTRDIFF_MAX / sizeof(T) - kPage) throw std::bad_alloc();
  const std::size_t bytes = count * sizeof(T) + 1;
  void* const mapped =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  // The pages that lie within the array, so that no more memory is touched than it has. Advice: it may be
  // refused.
  const auto begin = reinterpret_cast<std::uintptr_t>(mapped);
  const std::uintptr_t first = (begin + kPage - 1) / kPage * kPage,
                       last = (begin + bytes) / kPage * kPage;
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
  return LargeArray<T>(static_cast<T*>(mapped), Unmapped{bytes});
}

}  // namespace circumspect::fast
