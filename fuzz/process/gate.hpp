// How many programs may run at a time.
#pragma once

#include <atomic>
#include <cstddef>

namespace circumspect::campaign {

class Gate;

// What one supervisor holds of a gate: a place or none. Without a gate there is always room.
class Turn {
 public:
  Turn() = default;

  // Waits for a place and takes it. False: the other end of the socket `lifeline` was closed before there
  // was one. Makes system calls alone, so that a process between vfork and exec may call it.
  bool take(int lifeline) const;
  // Gives the place back, if it holds one.
  void give_back() const;

 private:
  friend class Gate;
  Turn(Gate* gate, int holder) : gate_(gate), holder_(holder) {}

  Gate* gate_ = nullptr;
  int holder_ = 0;
};

// Places in memory that this process shares with those that it forks: programs are started by the
// processes of supervisors, each as soon as another one has ended, without asking this one. Each place
// says who holds it, so that it can be given back for a supervisor that was killed.
class Gate {
 public:
  // Throws std::system_error. Requires: places ≥ 1.
  explicit Gate(std::size_t places);
  ~Gate();
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;

  // Of a new holder. Called before the fork that shares it.
  Turn turn() { return {this, ++holders_}; }

 private:
  friend class Turn;
  using Cell = std::atomic<int>;
  static_assert(Cell::is_always_lock_free);

  Cell* cells_ =
      nullptr;  // the first counts what was given back; the others: who holds the place, or 0
  std::size_t count_ = 0;
  int holders_ = 0;
};

}  // namespace circumspect::campaign
