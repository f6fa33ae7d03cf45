// What happens inside the process of a Supervisor.
#pragma once

#include <sys/types.h>

#include "oracle/campaign/process.hpp"

namespace circumspect::campaign {

// Runs one program to its end and kills all that is left of it. `lifeline`: a socket; when its other
// end is closed, nobody waits for the answer any more, and the program is killed.
// Requires: this process is a child subreaper and has no other children.
Ended run_supervised(const Request& request, const Limits& limits, int lifeline);

// Every process that descends from this one.
std::vector<pid_t> descendants();

// How many bytes the files of a folder take on disk.
std::uint64_t bytes_in(const std::string& folder);

}  // namespace circumspect::campaign
