// Calls of the C interface that may take long, while other Python threads keep running.
#pragma once

#include <functional>
#include <string>

#include <circumspect/circumspect.h>

namespace circumspect {

// The outcome of a call, which may have been made in another thread.
struct Outcome {
  circumspect_status status = CIRCUMSPECT_OK;
  std::string fault = {};
  std::string option = {};
};

// Of the call that this thread has just made.
Outcome outcome_of(circumspect_status status);

// Makes the call in a thread of its own, without the interpreter's lock; meanwhile this thread
// handles signals. Ctrl-C stops the call and then raises KeyboardInterrupt. After so many seconds
// (0: no limit) the call ends undecided. Requires: the caller has the lock, and nothing changes
// what the call reads.
Outcome made(const std::function<circumspect_status()>& call, double seconds = 0);

// The same in this thread, which is quicker for short calls. Signals wait until the call ends.
Outcome made_here(const std::function<circumspect_status()>& call);

// Stops all calls, including those that other threads make later, and waits for their end. To be
// called when the interpreter ends, because that destroys what the calls need. Those threads do not
// continue.
void stop_all_calls();

}  // namespace circumspect
