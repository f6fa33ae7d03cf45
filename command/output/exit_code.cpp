#include "command/output/exit_code.hpp"

namespace circumspect::cli {
namespace {

int severity(ExitCode code) {
  switch (code) {
    case ExitCode::kHolds:
      return 0;
    case ExitCode::kUndecided:
      return 1;
    case ExitCode::kFails:
      return 2;
    case ExitCode::kInputFault:
      return 3;
    case ExitCode::kUsage:
      return 4;
    case ExitCode::kInternalError:
      return 5;
  }
  return 5;
}

}  // namespace

ExitCode worse(ExitCode a, ExitCode b) { return severity(a) < severity(b) ? b : a; }

}  // namespace circumspect::cli
