// Runs work of our own that may take too much time or memory in a separate process, which can be killed.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

namespace circumspect::campaign {

struct Apart {
  enum class End {
    kDone,         // text: what was computed
    kTimeLimit,    // it took too long, and was killed
    kMemoryLimit,  // its memory did not suffice
    kInterrupted,  // `stop` became true
  };
  End end = End::kDone;
  std::string text = {};
};

// The exit code with which a process says that its memory did not suffice; the command's, too.
inline constexpr int kOutOfMemory = 5;

// What `compute` returns, computed by a child of this process on a copy of all that is in memory. `memory`: bytes
// of address space that it may have beyond that, 0 for any. Where no process is to be had, this one computes it, without limits.
// Requires: `compute` takes no lock that another thread may hold, and asks for no thread.
// Throws std::runtime_error if the child dies in another way, which is a mistake of ours.
Apart computed_apart(const std::function<std::string()>& compute, double seconds,
                     std::uint64_t memory, const std::atomic<bool>& stop);

}  // namespace circumspect::campaign
