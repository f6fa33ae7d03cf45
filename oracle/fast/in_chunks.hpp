// Work on ranges of a list, by one thread or by several; which one does what changes no answer.
#pragma once

#include <algorithm>
#include <cstddef>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

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
  // More than there are make oneTBB complain.
  const int most = tbb::info::default_concurrency();
  tbb::task_arena arena(std::min(static_cast<int>(threads), most));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, chunks, one); });
}

}  // namespace circumspect::fast
