// Work on ranges of a list, by one thread or by several; which one does what changes no answer.
#pragma once

#include <algorithm>
#include <cstddef>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

// oneTBB as Debian ships it is not instrumented: ThreadSanitizer (preset `tsan`) would take its every
// locking for a race, and sees plain threads instead.
#if defined(__SANITIZE_THREAD__)
#define CIRCUMSPECT_PLAIN_THREADS
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CIRCUMSPECT_PLAIN_THREADS
#endif
#endif
#ifdef CIRCUMSPECT_PLAIN_THREADS
#include <atomic>
#include <thread>
#include <vector>
#endif

namespace circumspect::fast {

inline std::size_t chunks_of(std::size_t count, std::size_t size) {
  return (count + size - 1) / size;
}

// Calls work(chunk, first, last) for each chunk of `size` items, the last one shorter.
// Requires: threads ≥ 1; calls for different chunks do not disturb each other.
template <typename Work>
void in_chunks(std::size_t count, std::size_t size, unsigned threads, const Work& work) {
  const auto one = [&](std::size_t chunk) {
    work(chunk, chunk * size, std::min((chunk + 1) * size, count));
  };
  const std::size_t chunks = chunks_of(count, size);
  if (threads <= 1 || chunks <= 1) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) one(chunk);
    return;
  }
#ifdef CIRCUMSPECT_PLAIN_THREADS
  std::atomic<std::size_t> next = 0;  // relaxed: chunks are ordered by nothing
  std::vector<std::jthread> team;
  for (unsigned i = 0; i < threads; ++i) {
    team.emplace_back([&] {
      std::size_t chunk = 0;
      while ((chunk = next.fetch_add(1, std::memory_order_relaxed)) < chunks) one(chunk);
    });
  }
#else
  // More than there are make oneTBB complain.
  const int most = tbb::info::default_concurrency();
  tbb::task_arena arena(std::min(static_cast<int>(threads), most));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, chunks, one); });
#endif
}

}  // namespace circumspect::fast
