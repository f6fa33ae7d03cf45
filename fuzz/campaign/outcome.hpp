// The program under test, and the outcome of one case. Outcomes differ if a person would react to them differently.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fuzz/campaign/input.hpp"
#include "fuzz/process/process.hpp"
#include "inputs/relations.hpp"
#include "inputs/updates.hpp"
#include "oracle/domain/filling.hpp"
#include "oracle/model/verdict.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::campaign {

enum class OutcomeKind {
  kHolds,         // the mesh is what it is claimed to be
  kSkipped,       // the input is not one for this program: it was not run
  kRefused,       // the program said that it does not take this input, as it may
  kFlaky,         // something was wrong with it once, and not when it was run again, three times
  kKnown,         // something is wrong with it that its user knows of
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
  kDiffers,  // it refuses an input, and not the same one changed, or what another program takes; or
             // its mesh is another one than that program's where there is one right one
  kJudgingLimit,  // its mesh could not be judged within the time or the memory that there is for that
  kNotRun,        // it could not be started, or the disk is full: no fault of the program
  kInterrupted,  // this process is to end
};

struct Outcome {
  OutcomeKind kind = OutcomeKind::kInterrupted;
  // What is the same for the same fault: the identifier of the first broken rule,
  // "crash-SIGSEGV", "exit-code-3", "hang", … A name that can be one of a folder. What is added sets apart what must
  // not hide, nor be led to by making an input small: "-rounding" if a vertex is in a ball by less than kRounding of it
  // at worst, "-extreme" if the input has a number outside of kOrdinary, and "-flat" if its points lie in a hyperplane or
  // are too few not to. None of this has a say in what is a finding.
  std::string signature = {};
  std::string text = {};         // one line for people; kHolds: what another program did otherwise
  std::string explanation = {};  // the witnesses of a broken rule; else what the program said
  report::Json verdict = {};     // kFails: the whole verdict
  // On which input, if that is the one that was given changed by a relation; the signature then ends in "-after-order" or
  // the like.
  std::optional<Input> image = {};
};

// A depth in a ball, relative to it, below which it is called rounding.
inline constexpr double kRounding = 1e-9;

// An outcome as bytes, and back: for a process apart. Requires: bytes of this function.
std::string bytes_of(const Outcome& outcome);
Outcome outcome_of_bytes(const std::string& bytes);

// Is it something that the user wants to hear of?
bool is_finding(OutcomeKind kind);

// "holds", "refused" … as statistics name it.
std::string word(OutcomeKind kind);

// ---- Parts of texts ----

// Puts `by` in place of every `part` of the text, from left to right; what was put there is not looked at again.
// Requires: `part` is not empty.
inline void replace_all(std::string& text, const std::string& part, const std::string& by) {
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + by.size())) {
    text.replace(at, part.size(), by);
  }
}

// ---- Subject ----
// The program under test: how it is called, what it reads and writes, what is claimed of it.

// The program runs in an empty folder that holds its input and nothing else. In its arguments,
// {points} and {domain} stand for the path of the input, {mesh} for that of the mesh, {folder} for
// the folder.
struct Subject {
  std::vector<std::string> command;   // command[0]: an absolute path
  std::string input_name = "x.node";  // in the folder; its extension says the format
  std::string mesh_name = "x.ele";    // likewise: where the program writes the mesh
  bool reads_stdin = false;           // the input is its standard input (and in the folder)
  bool writes_stdout = false;         // the mesh is its standard output, as if it were that file
  std::optional<Talk> talk = {};      // it is a worker; then both of these hold
  // What happens to the points of a worker's structure before it answers; empty: nothing.
  std::set<generators::UpdateKind> updates = {};
  Claim claim = Claim::kDelaunay;
  std::size_t dimension = 3;
  Vertex first_index = 0;       // of the points of the input
  Fill fill = Fill::kEnclosed;  // of a domain: which part of it is to be meshed
  bool merges_coplanar =
      false;  // the mesh is held against the domain with polygons of one plane joined
  // Domains of the plane that are not tidy; their meshes are held against their arrangements (arrangement.hpp).
  bool is_untidy = false;
  bool full_dimension = false;                  // skip points that lie in a hyperplane
  std::set<int> refusal_codes = {};             // exit codes that say: not an input for me
  std::vector<std::string> refusal_texts = {};  // what it prints when it says so
  Limits limits = {};
  std::optional<Containment> containment = {};  // without it, the strongest that there is
  double judging_seconds = 100;                 // how long it may take to judge one mesh

  // Changes after which it has to be as right as before, each tried on each input.
  std::set<generators::Relation> relations = {};
  // Another program, called in the same way, that is given each input on which this one is right or which it refuses.
  std::vector<std::string> against = {};

  // What its user says of it, for issue.md: its version and how it was built; what its documents promise.
  std::string about = {};
  std::string promise = {};

  bool is_about_domains() const { return is_about_a_domain(claim); }
};

// The arguments with everything in place. `paths` of: the folder, the input, the mesh.
struct Paths {
  std::string folder;
  std::string input;
  std::string mesh;
};
std::vector<std::string> filled_in(const Subject& subject, const Paths& paths);

// Does an argument of the command hold this placeholder, braces and all?
bool mentions(const std::vector<std::string>& command, const std::string& placeholder);

}  // namespace circumspect::campaign
