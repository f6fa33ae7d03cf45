// Runs our own work in a separate process that can be killed, when it may take too much time or
// memory.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

namespace circumspect::campaign {

struct Apart {
  enum class End {
    kDone,         // text: the result
    kTimeLimit,    // it took too long, and was killed
    kMemoryLimit,  // it ran out of memory
    kInterrupted,  // `stop` became true
  };
  End end = End::kDone;
  std::string text = {};
};

// The exit code by which a process reports that it ran out of memory; the command uses it, too.
inline constexpr int kOutOfMemory = 5;

// The result of `compute`, which a child of this process computes on a copy of the memory.
// `memory`: bytes of address space that it may use beyond that, 0 for any. If the system allows no
// further process, this one computes it, without limits. Requires: `compute` takes no lock that
// another thread may hold, and starts no thread. Throws std::runtime_error if the child dies in
// another way, which is a bug.
Apart computed_apart(const std::function<std::string()>& compute, double seconds,
                     std::uint64_t memory, const std::atomic<bool>& stop);

}  // namespace circumspect::campaign
