// All chunks are processed, each once; an interruption of the caller reaches the threads that help
// it.
#include "oracle/judge/fast/in_chunks.hpp"

#include <atomic>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>

#include "kernel/exact/interruption.hpp"

namespace circumspect::fast {
namespace {

TEST_CASE("each item is in one chunk, for any number of threads") {
  for (const unsigned threads : {1U, 2U, 5U}) {
    std::vector<std::atomic<int>> times(1000);
    in_chunks(times.size(), 7, threads,
              [&](std::size_t chunk, std::size_t first, std::size_t last) {
                CHECK(first == chunk * 7);
                for (std::size_t i = first; i < last; ++i) ++times[i];
              });
    for (const auto& count : times) CHECK(count == 1);
  }
}

TEST_CASE("who interrupts the caller interrupts its helpers, and the rest is not worked on") {
  for (const unsigned threads : {1U, 2U, 5U}) {
    std::int32_t stop = 0;
    const Interruption by{&stop};
    const Interruptible interruptible(&by);
    std::atomic<int> begun = 0;
    std::atomic<int> undisturbed = 0;
    CHECK_THROWS_AS(in_chunks(100'000, 1, threads,
                              [&](std::size_t, std::size_t, std::size_t) {
                                if (interruption_of_thread != &by) ++undisturbed;
                                if (++begun == 10) __atomic_store_n(&stop, 1, __ATOMIC_RELAXED);
                              }),
                    Interrupted);
    CHECK(undisturbed == 0);
    CHECK(begun < 1000);
    CHECK(interruption_of_thread == &by);
  }
}

}  // namespace
}  // namespace circumspect::fast
