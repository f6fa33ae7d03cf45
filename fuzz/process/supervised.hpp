// The code that runs inside the process of a Supervisor.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <signal.h>
#include <sys/types.h>

#include "fuzz/process/process.hpp"

namespace circumspect::campaign {

// Says what happens at every signal but those that say that a child has ended: SIG_IGN or SIG_DFL.
// The processes above a program ignore them all: those from the terminal are meant for the process
// that wants the answers, and a program may send them any others. A fault of their own still ends
// them. Only makes system calls.
void set_signals(void (*handler)(int));

// What a run depends on, apart from its request.
struct Surroundings {
  // A socket: when its other end is closed, the answer is no longer wanted, and the program is
  // killed, or not started.
  int lifeline;
  Turn turn;  // held while the program, or anything that it started, runs
  Containment containment;
};

// Opens a file of our own for writing, truncated; −1 if that fails. An earlier program may have put
// a pipe or a link in its place, which would block for ever or lead elsewhere; it is replaced.
int opened_empty(const std::string& path);

// Starts the program when its turn comes, with these for its standard input, output and error.
// `cases`: it may use processor time for so many times its limit. Returns its process, or −errno;
// ECANCELED: its answer is no longer wanted.
pid_t start_program(const Request& request, const Limits& limits, const Surroundings& around,
                    const int (&files)[3], std::size_t cases);

// Kills a program, which is a child of this process, and everything that it started. Returns its
// exit status.
int killed(pid_t process, Containment containment);

// The outcome of a program that has this exit status. `ending`: kExited, or why it was killed.
Ended described(Ending ending, int status, const Request& request, const Limits& limits);

// How long a program was ready to run but had no processor, from looks at the kernel's counters for
// each of its tasks. Other programs had the processors then. Time that its tasks take from each
// other does not count, and neither does sleep.
class Stalls {
 public:
  // Nanoseconds since it began.
  struct Task {
    std::uint64_t ran = 0;
    std::uint64_t waited = 0;  // for a processor; a wait that has not ended is not in it
  };

  // `passed`: since the program began. Time before the first look counts as its own, because
  // nothing is known about it.
  void look(std::chrono::nanoseconds passed, const std::map<pid_t, Task>& tasks,
            unsigned processors);

  double seconds() const { return 1e-9 * static_cast<double>(stalled_); }

 private:
  std::map<pid_t, Task> before_;
  bool has_looked_ = false;
  std::uint64_t passed_ = 0;
  std::uint64_t idle_ = 0;  // none of its tasks ran, and no wait has explained it yet
  std::uint64_t stalled_ = 0;
};

// Watches a running program.
class Watch {
 public:
  // Requires: `request` and `limits` live longer.
  Watch(pid_t process, const Request& request, const Limits& limits, int lifeline);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // Waits until it ends or must be ended. kExited: it ended by itself, in any way.
  Ending wait();

  // The limit that it exceeds now, if any. Called every kTick or so.
  std::optional<Ending> exceeded();
  bool has_too_many_processes() const;
  // It remains to be reaped.
  bool has_ended() const;
  // A file that can be polled for its end; −1 where the kernel has none.
  int file() const { return process_; }
  double seconds() const;

  static constexpr double kTick = 0.02;  // seconds between two looks at what it uses

 private:
  const Request& request_;
  const Limits& limits_;
  int lifeline_;
  pid_t number_;
  int process_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Stalls stalls_;
};

// Runs one program to its end and kills all processes that are left of it. Requires: this process
// is a child subreaper and has no other children.
Ended run_supervised(const Request& request, const Limits& limits, const Surroundings& around);

// Processes that descend from this one: all of them, or as many as are enough.
std::vector<pid_t> descendants(std::size_t enough = static_cast<std::size_t>(-1));
// Adds the children of all threads of one process.
void add_children(pid_t process, std::vector<pid_t>& found);

// Kills every process that descends from this one, and waits for their ends.
// Requires: this process is a child subreaper, or the first of a process namespace.
void kill_descendants(Containment containment);

// Kills these children of this process and all their descendants, and waits for their ends.
void kill_children(const std::function<std::vector<pid_t>()>& children);

}  // namespace circumspect::campaign
