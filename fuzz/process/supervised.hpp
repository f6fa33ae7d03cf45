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

// Signals from the terminal, which are for the process that wants the answers.
constexpr int kIgnored[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGTTIN, SIGTTOU};

// What a run depends on beside its request.
struct Surroundings {
  // A socket: when its other end is closed, nobody waits for the answer any more, and the program is
  // killed, or not even started.
  int lifeline;
  Turn turn;  // held while the program, or anything that it started, runs
  Containment containment;
};

// Opens a file of our own for writing, emptied; −1: it cannot be. A program that ran before may have put a pipe or
// a link in its place, which would wait for ever or lead elsewhere: that is replaced.
int opened_empty(const std::string& path);

// Starts the program when its turn comes, with these for its standard input, output and error. `cases`: for so many
// times its limit the processors may be its own. Returns its process, or −errno; ECANCELED: nobody waits for it any more.
pid_t start_program(const Request& request, const Limits& limits, const Surroundings& around,
                    const int (&files)[3], std::size_t cases);

// Kills a program, which is a child of this process, and all that it started. Its exit status.
int killed(pid_t process, Containment containment);

// What became of a program that has this exit status. `ending`: kExited, or why it was killed.
Ended described(Ending ending, int status, const Request& request, const Limits& limits);

// How long a program could have run and had no processor, from looks at the counters of the kernel for each of its tasks.
// Others took the processors then. Tasks that take them from each other are no excuse, and neither is sleep.
class Stalls {
 public:
  // Nanoseconds since it began.
  struct Task {
    std::uint64_t ran = 0;
    std::uint64_t waited = 0;  // for a processor; a wait that has not ended is not in it
  };

  // `passed`: since the program began. What happened before the first look is not known, and counts as its own time.
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

// Looks at a program that runs.
class Watch {
 public:
  // Requires: `request` and `limits` live longer.
  Watch(pid_t process, const Request& request, const Limits& limits, int lifeline);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // Waits until it ends or must be ended. kExited: it ended by itself, in whatever way.
  Ending wait();

  // The limit that it exceeds now, if any. Called every kTick or so.
  std::optional<Ending> exceeded();
  bool has_too_many_processes() const;
  // It stays to be reaped.
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

// Runs one program to its end and kills all that is left of it.
// Requires: this process is a child subreaper and has no other children.
Ended run_supervised(const Request& request, const Limits& limits, const Surroundings& around);

// Processes that descend from this one: all of them, or as many as are enough.
std::vector<pid_t> descendants(std::size_t enough = static_cast<std::size_t>(-1));
// Adds the children of one process, of all its threads.
void add_children(pid_t process, std::vector<pid_t>& found);

// Kills every process that descends from this one, and waits for their ends.
// Requires: this process is a child subreaper, or the first of a process namespace.
void kill_descendants(Containment containment);

// Kills these children of this process and all that descends from them, and waits for their ends.
void kill_children(const std::function<std::vector<pid_t>()>& children);

}  // namespace circumspect::campaign
