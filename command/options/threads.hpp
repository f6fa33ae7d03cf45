// How many threads judge a mesh.
#pragma once

#include <algorithm>
#include <cstdint>
#include <thread>

#include <CLI/CLI.hpp>

#include "command/options/whole_number.hpp"

namespace circumspect::cli {

// Adds --threads; 0 if it is not given.
inline void add_threads_option(CLI::App& command, std::uint64_t& threads) {
  command
      .add_option("--threads", threads,
                  "Read and judge with at most N threads (default: one for each processor). The "
                  "answer is the same for any number")
      ->check(whole_number(1))
      ->option_text("N");
}

// As many as were asked for, but no more than there are processors: they would wait for each other.
inline unsigned thread_count(std::uint64_t asked) {
  const std::uint64_t most = std::max(1U, std::thread::hardware_concurrency());
  return static_cast<unsigned>(asked == 0 ? most : std::min(asked, most));
}

}  // namespace circumspect::cli
