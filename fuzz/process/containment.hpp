// The ways to confine an untrusted program: what it sees of the system, and how all its processes
// are ended.
#pragma once

#include <atomic>
#include <cstddef>

#include <sys/resource.h>
#include <sys/types.h>

namespace circumspect::campaign {

enum class Containment {
  // In a process namespace, whose first process is the supervisor. A program cannot see the
  // processes outside, so it can neither stop nor kill them. One kill ends everything that it
  // started, even a fork bomb whose processes each begin a session. The kernel counts its processes
  // and refuses too many.
  kNamespaces,
  // As descendants of the supervisor, which looks for them and kills them. A program can see, stop
  // and kill every process of its user; this is detected, and everything that it started is killed.
  kSupervisor,
};

// "namespaces" or "supervisor".
const char* name(Containment containment);

// As fork. The child is the first process of a process namespace of its own, with its own /proc. −1
// where the system does not allow that: then there is no child. Requires: this process has one
// thread.
pid_t fork_into_namespaces();

// How many tasks (processes and their threads) the kernel should allow a program that may have so
// many processes; a supervisor calls this once. Threads count too, so a hundred are added, and four
// for each processor.
rlim_t most_tasks(Containment containment, std::size_t processes);

// In a process namespace: makes the kernel refuse more tasks, even to a superuser, if the kernel
// can.
void let_kernel_refuse_more_tasks(rlim_t tasks);

// A process whose ID is not reused meanwhile, as far as this process can tell.
class Known {
 public:
  Known() = default;
  // Requires: the process exists.
  explicit Known(pid_t process);
  ~Known();
  Known(Known&& other) noexcept;
  Known& operator=(Known&& other) noexcept;

  pid_t number() const { return number_; }
  // Also true of no process.
  bool has_ended_within(int milliseconds) const;
  void send(int signal_number) const;
  // Its state according to the kernel: 'R', 'S', 'T' (stopped), 't' (traced), …; 0 if it has ended.
  char state() const;

 private:
  pid_t number_ = -1;
  int file_ = -1;
};

// Limits how many programs run at a time.

class Gate;

// A supervisor's hold on a gate: a place or none. Without a gate there is always room.
class Turn {
 public:
  Turn() = default;

  // Waits for a place and takes it. False: the other end of the socket `lifeline` was closed before
  // there was one. Makes only system calls, so that a process between vfork and exec may call it.
  bool take(int lifeline) const;
  // Gives the place back, if it holds one.
  void give_back() const;

 private:
  friend class Gate;
  Turn(Gate* gate, int holder) : gate_(gate), holder_(holder) {}

  Gate* gate_ = nullptr;
  int holder_ = 0;
};

// Places in memory that this process shares with those that it forks: supervisors start a program
// as soon as another one has ended, without asking this process. Each place records its holder, so
// that it can be given back on behalf of a supervisor that was killed.
class Gate {
 public:
  // Throws std::system_error. Requires: places ≥ 1.
  explicit Gate(std::size_t places);
  ~Gate();
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;

  // For a new holder. Called before the fork that shares it.
  Turn turn() { return {this, ++holders_}; }

 private:
  friend class Turn;
  using Cell = std::atomic<int>;
  static_assert(Cell::is_always_lock_free);

  Cell* cells_ =
      nullptr;  // the first counts returned places; the others: who holds the place, or 0
  std::size_t count_ = 0;
  int holders_ = 0;
};

}  // namespace circumspect::campaign
