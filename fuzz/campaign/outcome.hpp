// What became of one case: told apart by what a person would do about it.
#pragma once

#include <string>

#include "oracle/report/json.hpp"

namespace circumspect::campaign {

enum class OutcomeKind {
  kHolds,         // the mesh is what it is claimed to be
  kSkipped,       // the input is not one for this program: it was not run
  kRefused,       // the program said that it does not take this input, as it may
  kFails,         // the mesh breaks a rule
  kOtherPoints,   // the mesh has other points than the input
  kUnreadable,    // the file of the mesh is malformed
  kNoMesh,        // the program ended well and wrote no mesh
  kExitCode,      // it ended with an exit code other than 0
  kCrash,         // it died of a signal
  kHang,          // it ran longer than allowed
  kMemoryLimit,   // it said that its memory did not suffice
  kOutputLimit,   // it wrote more than allowed
  kProcessLimit,  // it started more processes than allowed
  kKillsParent,   // it killed the process that started it, twice
  kJudgingLimit,  // its mesh could not be judged within the time or the memory that there is for that
  kNotRun,        // it could not be started, or the disk is full: no fault of the program
  kInterrupted,  // this process is to end
};

struct Outcome {
  OutcomeKind kind = OutcomeKind::kInterrupted;
  // What is the same for the same fault: the identifier of the first broken rule,
  // "crash-SIGSEGV", "exit-code-3", "hang", … A name that can be one of a folder. Where no rule is
  // broken, "-flat" is added if the points lie in a hyperplane: many programs give up on those, which
  // must not hide that they give up on others, nor may making an input small lead from these to those.
  std::string signature = {};
  std::string text = {};         // one line for people
  std::string explanation = {};  // the witnesses of a broken rule; else what the program said
  report::Json verdict = {};     // kFails: the whole verdict
};

// An outcome as bytes, and back: for a process apart. Requires: bytes of this function.
std::string bytes_of(const Outcome& outcome);
Outcome outcome_of_bytes(const std::string& bytes);

// Is it something that the user wants to hear of?
bool is_finding(OutcomeKind kind);

// "holds", "refused" … as statistics name it.
std::string word(OutcomeKind kind);

}  // namespace circumspect::campaign
