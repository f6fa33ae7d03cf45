// Calls of the C interface that may take long, while other threads of Python go on.
#pragma once

#include <functional>
#include <string>

#include <circumspect/circumspect.h>

namespace circumspect {

// What came of a call, which was perhaps made in another thread.
struct Outcome {
  circumspect_status status = CIRCUMSPECT_OK;
  std::string message = {};
};

// Makes the call in a thread of its own, without the interpreter's lock; meanwhile this thread looks for signals.
// Ctrl-C stops the call and then raises KeyboardInterrupt. After so many seconds (0: no limit) the call ends undecided.
// Requires: the caller has the lock, and nothing changes what the call reads.
Outcome made(const std::function<circumspect_status()>& call, double seconds = 0);

// The same in this thread, which is quicker where the call is short. Signals wait for its end.
Outcome made_here(const std::function<circumspect_status()>& call);

// Stops all calls, and those that other threads make later, and waits for their end: for the end of the interpreter,
// which takes away what they need. Those threads do not go on.
void stop_all_calls();

}  // namespace circumspect
