#include "oracle/judge/fast/in_chunks.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

#include "kernel/exact/interruption.hpp"

// oneTBB as Debian ships it is not instrumented: ThreadSanitizer (preset `tsan`) would report its
// locks as races, so that build uses plain threads. There is also no static archive of it, which
// CIRCUMSPECT_STATIC would need.
#if defined(__SANITIZE_THREAD__)
#define CIRCUMSPECT_PLAIN_THREADS
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CIRCUMSPECT_PLAIN_THREADS
#endif
#endif

#ifndef CIRCUMSPECT_PLAIN_THREADS
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace circumspect::fast {
namespace {

#ifdef CIRCUMSPECT_PLAIN_THREADS

// Calls one(chunk) for each chunk.
template <typename One>
void on_threads(std::size_t chunks, unsigned threads, const One& one) {
  std::atomic<std::size_t> next = 0;  // relaxed: no order of chunks is needed
  std::atomic_flag has_failed;
  std::exception_ptr failure;  // the first
  const auto take = [&] {
    std::size_t chunk = 0;
    try {
      while ((chunk = next.fetch_add(1, std::memory_order_relaxed)) < chunks) one(chunk);
    } catch (...) {
      if (!has_failed.test_and_set()) failure = std::current_exception();
      next = chunks;  // the rest is useless
    }
  };
  {
    std::vector<std::jthread> team;
    try {
      while (team.size() + 1 < std::min<std::size_t>(threads, chunks)) team.emplace_back(take);
    } catch (const std::system_error&) {
      // The system allows no more threads.
    }
    take();
  }
  if (failure) std::rethrow_exception(failure);
}

#else

// How many of these threads the system allows, including this one: oneTBB ends the work with an
// exception if it expects more. Determined once, by starting them.
int threads_to_be_had(int wanted) {
  static const int most = [wanted] {
    std::atomic<bool> is_counted = false;
    std::vector<std::jthread> team;
    try {
      while (static_cast<int>(team.size()) + 1 < wanted) {
        team.emplace_back([&is_counted] { is_counted.wait(false); });
      }
    } catch (const std::system_error&) {
      // No more.
    }
    is_counted = true;
    is_counted.notify_all();
    const int count = static_cast<int>(team.size()) + 1;
    team.clear();
    return count;
  }();
  return most;
}

// Calls one(chunk) for each chunk.
template <typename One>
void on_threads(std::size_t chunks, unsigned threads, const One& one) {
  // oneTBB complains about more threads than there are.
  const int most = threads_to_be_had(tbb::info::default_concurrency());
  if (most == 1) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) one(chunk);
    return;
  }
  tbb::task_arena arena(std::min(static_cast<int>(threads), most));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, chunks, one); });
}

#endif

}  // namespace

void in_chunks(std::size_t count, std::size_t size, unsigned threads, const ChunkWork& work) {
  const auto one = [&, interruption = interruption_of_thread](std::size_t chunk) {
    const Interruptible as_the_caller(interruption);
    end_if_interrupted();
    work(chunk, chunk * size, std::min((chunk + 1) * size, count));
  };
  const std::size_t chunks = chunks_of(count, size);
  if (threads <= 1 || chunks <= 1) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) one(chunk);
  } else {
    on_threads(chunks, threads, one);
  }
}

bool are_finite(std::span<const double> numbers, unsigned threads) {
  constexpr std::size_t kChunk = std::size_t{1} << 15;
  std::atomic<bool> finite = true;
  in_chunks(numbers.size(), kChunk, threads, [&](std::size_t, std::size_t first, std::size_t last) {
    // The sum of the products with 0 is 0, unless one of them is NaN: no branch.
    double sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += numbers[i] * 0;
    if (sum != 0) finite.store(false, std::memory_order_relaxed);
  });
  return finite.load(std::memory_order_relaxed);
}

}  // namespace circumspect::fast
