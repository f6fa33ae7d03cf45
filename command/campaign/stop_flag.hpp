// Ctrl-C for commands that keep what they have.
#pragma once

#include <atomic>

namespace circumspect::cli {

// Becomes true at the first SIGINT or SIGTERM; the next one ends the process. The handler is
// installed by the first call.
const std::atomic<bool>& stop_flag();

}  // namespace circumspect::cli
