#include "fuzz/campaign/outcome.hpp"

#include <string>

#include "fuzz/process/process.hpp"
#include "oracle/model/verdict.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::campaign {

std::string bytes_of(const Outcome& outcome) {
  const report::Json fields = {static_cast<int>(outcome.kind), outcome.signature, outcome.text,
                               outcome.explanation, outcome.verdict};
  std::string bytes;
  report::Json::to_cbor(fields, bytes);
  return bytes;
}

Outcome outcome_of_bytes(const std::string& bytes) {
  const report::Json fields = report::Json::from_cbor(bytes);
  return {static_cast<OutcomeKind>(fields.at(0).get<int>()), fields.at(1), fields.at(2),
          fields.at(3), fields.at(4)};
}

bool is_finding(OutcomeKind kind) {
  switch (kind) {
    case OutcomeKind::kHolds:
    case OutcomeKind::kSkipped:
    case OutcomeKind::kRefused:
    case OutcomeKind::kFlaky:
    case OutcomeKind::kKnown:
    case OutcomeKind::kNotRun:
    case OutcomeKind::kInterrupted:
      return false;
    default:
      return true;
  }
}

std::string word(OutcomeKind kind) {
  switch (kind) {
    case OutcomeKind::kHolds:
      return "holds";
    case OutcomeKind::kSkipped:
      return "skipped";
    case OutcomeKind::kRefused:
      return "refused";
    case OutcomeKind::kFlaky:
      return "flaky";
    case OutcomeKind::kKnown:
      return "known";
    case OutcomeKind::kFails:
      return "fails";
    case OutcomeKind::kOtherPoints:
      return "other-points";
    case OutcomeKind::kUnreadable:
      return "unreadable-mesh";
    case OutcomeKind::kNoMesh:
      return "no-mesh";
    case OutcomeKind::kExitCode:
      return "exit-code";
    case OutcomeKind::kCrash:
      return "crash";
    case OutcomeKind::kHang:
      return "hang";
    case OutcomeKind::kMemoryLimit:
      return "memory-limit";
    case OutcomeKind::kOutputLimit:
      return "output-limit";
    case OutcomeKind::kProcessLimit:
      return "process-limit";
    case OutcomeKind::kKillsParent:
      return "kills-parent";
    case OutcomeKind::kDiffers:
      return "differs";
    case OutcomeKind::kJudgingLimit:
      return "judging-limit";
    case OutcomeKind::kNotRun:
      return "not-run";
    case OutcomeKind::kInterrupted:
      return "interrupted";
  }
  return "";
}

}  // namespace circumspect::campaign
