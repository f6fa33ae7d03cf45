// The outcome of one case. Outcomes differ if a person would react to them differently.
#pragma once

#include <optional>
#include <string>

#include "fuzz/campaign/input.hpp"
#include "inputs/relations.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::campaign {

enum class OutcomeKind {
  kHolds,         // the claim holds for the mesh
  kSkipped,       // the input is not for this program, which was not run
  kRefused,       // the program said that it does not take this input, as it may
  kFlaky,         // it failed once, but not in three further runs
  kKnown,         // it failed in a way that the user already knows
  kFails,         // the mesh breaks a rule
  kOtherPoints,   // the mesh has other points than the input
  kUnreadable,    // the file of the mesh is malformed
  kNoMesh,        // the program ended well and wrote no mesh
  kExitCode,      // it ended with an exit code other than 0
  kCrash,         // it died of a signal
  kHang,          // it ran longer than allowed
  kMemoryLimit,   // it reported that it ran out of memory
  kOutputLimit,   // it wrote more than allowed
  kProcessLimit,  // it started more processes than allowed
  kKillsParent,   // it killed the process that started it, twice
  kDiffers,  // it refuses an input, and not the same one changed, or what another program takes; or
             // its mesh is another one than that program's where there is one right one
  kJudgingLimit,  // its mesh could not be judged within the limits on time and memory
  kNotRun,        // it could not be started, or the disk is full: not a fault of the program
  kInterrupted,   // this process is to end
};

struct Outcome {
  OutcomeKind kind = OutcomeKind::kInterrupted;
  // Equal for equal faults: the identifier of the first broken rule, "crash-SIGSEGV",
  // "exit-code-3", "hang", … It can be the name of a folder. A suffix distinguishes failures that
  // must not hide others, and that making an input small must not drift to: "-rounding" if vertices
  // are in a ball by less than kRounding of it at worst, "-extreme" if the input has a number
  // outside of kOrdinary, and "-flat" if its points lie in a hyperplane, perhaps because they are
  // too few. Suffixes do not affect what is a finding.
  std::string signature = {};
  std::string text = {};         // one line for people; kHolds: how another program differs
  std::string explanation = {};  // the witnesses of a broken rule; else what the program said
  report::Json verdict = {};     // kFails: the whole verdict
  // The relation, if the program fails on the input changed by it; the signature then ends in
  // "-after-order" or the like.
  std::optional<Input> image = {};
};

// A relative depth in a ball below which it is called rounding.
inline constexpr double kRounding = 1e-9;

// An outcome as bytes, and back, for a separate process. Requires: bytes of this function.
std::string bytes_of(const Outcome& outcome);
Outcome outcome_of_bytes(const std::string& bytes);

// Is it something that the user wants to know?
bool is_finding(OutcomeKind kind);

// "holds", "refused" … as statistics name it.
std::string word(OutcomeKind kind);

}  // namespace circumspect::campaign
