// What happens inside the process of a Supervisor.
#pragma once

#include <functional>
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
