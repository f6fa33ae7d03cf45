// What the command answers to the shell.
#pragma once

namespace circumspect::cli {

enum class ExitCode {
  kHolds = 0,
  kFails = 1,
  kUsage = 2,
  kInputFault = 3,
  kUndecided = 4,
  kInternalError = 5,
};

// Of several answers the worst, in the order 5, 2, 3, 1, 4, 0.
ExitCode worse(ExitCode a, ExitCode b);

}  // namespace circumspect::cli
