// Ends long work before its answer, when the answer is no longer wanted.
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <optional>

namespace circumspect {

// Ends work at any point. The judges keep no state beyond a call, so nothing is left half done.
struct Interrupted : std::exception {
  explicit Interrupted(bool late) : is_late(late) {}
  const char* what() const noexcept override;

  bool is_late;  // the limit was reached; else the user asked for the end
};

// When work is to end.
struct Interruption {
  const std::int32_t* stop = nullptr;  // none, or a number that another thread makes other than 0
  std::optional<std::chrono::steady_clock::time_point> deadline = {};

  void end_if_asked() const;  // throws Interrupted
};

// What can interrupt the work of this thread; nullptr: nothing does.
inline constinit thread_local const Interruption* interruption_of_thread = nullptr;

// As long as this exists, `by` can interrupt the work of this thread. A thread that helps another
// takes over the other's interruption (oracle/judge/fast/in_chunks.cpp).
class Interruptible {
 public:
  explicit Interruptible(const Interruption* by) : before_(interruption_of_thread) {
    interruption_of_thread = by;
  }
  ~Interruptible() { interruption_of_thread = before_; }
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  const Interruption* before_;
};

// The inner steps of long work call this: chunks of the fast judge, determinants, systems of
// equations, comparisons where many things are sorted, and rows where many are converted.
inline void end_if_interrupted() {
  if (interruption_of_thread != nullptr) interruption_of_thread->end_if_asked();
}

}  // namespace circumspect
