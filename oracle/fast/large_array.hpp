// Memory for large arrays. Not initialized, so that the threads that write it touch it first; in large pages,
// where the system has them for the asking: what is written all over an array then misses fewer translations
// of addresses, and first touches are fewer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

#include <sys/mman.h>

namespace circumspect::fast {

struct Freed {
  void operator()(void* memory) const { std::free(memory); }
};

// T[] of a type that needs neither constructor nor destructor.
template <typename T>
using LargeArray = std::unique_ptr<T[], Freed>;

// Throws std::bad_alloc.
template <typename T>
LargeArray<T> large_array(std::size_t count) {
  static_assert(std::is_trivial_v<T>);
  constexpr std::size_t kPage = std::size_t{1} << 21;
  const std::size_t bytes = count * sizeof(T);
  if (count > PTRDIFF_MAX / sizeof(T)) throw std::bad_alloc();
  const bool large = bytes >= kPage;
  void* const memory = large ? std::aligned_alloc(kPage, (bytes + kPage - 1) / kPage * kPage)
                             : std::malloc(bytes + 1);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  // Only what the array fills, so that no more memory is touched than it has. Advice: it may be refused.
  if (large) madvise(memory, bytes / kPage * kPage, MADV_HUGEPAGE);
#endif
  return LargeArray<T>(static_cast<T*>(memory));
}

}  // namespace circumspect::fast
