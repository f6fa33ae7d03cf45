// How much a search may do.
#pragma once

#include <atomic>
#include <cstddef>
#include <limits>

namespace circumspect::check {

// Counts steps of about a microsecond each. Whether more are taken than a search may take depends
// neither on the machine nor on the number of threads, so a search that gives up does so
// everywhere.
class Work {
 public:
  explicit Work(std::size_t most = std::numeric_limits<std::size_t>::max()) : most_(most) {}
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  void add(std::size_t steps) { done_.fetch_add(steps, std::memory_order_relaxed); }
  bool is_too_much() const { return done() > most_; }
  bool has_room_for(std::size_t steps) const { return steps <= most_ && done() <= most_ - steps; }
  std::size_t done() const { return done_.load(std::memory_order_relaxed); }

 private:
  std::size_t most_;
  std::atomic<std::size_t> done_ = 0;
};

}  // namespace circumspect::check
