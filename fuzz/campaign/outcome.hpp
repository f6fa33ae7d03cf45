// The program under test, and the outcome of one case. Outcomes differ if a person would react to
// them differently.
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

// ---- Parts of texts ----

// Replaces every `part` of the text by `by`, from left to right; replaced text is not searched
// again. Requires: `part` is not empty.
inline void replace_all(std::string& text, const std::string& part, const std::string& by) {
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + by.size())) {
    text.replace(at, part.size(), by);
  }
}

// ---- Subject ----
// The program under test: how it is called, what it reads and writes, and the claim about its
// meshes.

// The program runs in a folder that holds only its input. In its arguments, {points} and {domain}
// stand for the path of the input, {mesh} for that of the mesh, {folder} for the folder.
struct Subject {
  std::vector<std::string> command;   // command[0]: an absolute path
  std::string input_name = "x.node";  // in the folder; its extension determines the format
  std::string mesh_name = "x.ele";    // the same for the mesh that the program writes
  bool reads_stdin = false;           // the input is its standard input (and in the folder)
  bool writes_stdout = false;         // the mesh is its standard output, as if it were that file
  std::optional<Talk> talk = {};      // it is a worker; then both of the above hold
  // The updates to a worker's structure before it answers; empty: none.
  std::set<generators::UpdateKind> updates = {};
  Claim claim = Claim::kDelaunay;
  std::size_t dimension = 3;
  Vertex first_index = 0;       // of the points of the input
  Fill fill = Fill::kEnclosed;  // for a domain: which part of it must be meshed
  bool merges_coplanar =
      false;  // the mesh is compared with the domain with coplanar polygons joined
  // Untidy domains; their meshes are compared with their arrangements (arrangement.hpp).
  bool is_untidy = false;
  bool full_dimension = false;                  // skip points that lie in a hyperplane
  std::set<int> refusal_codes = {};             // exit codes that say: not an input for me
  std::vector<std::string> refusal_texts = {};  // text that it prints to say so
  Limits limits = {};
  std::optional<Containment> containment = {};  // by default, the strongest available
  double judging_seconds = 100;                 // how long it may take to judge one mesh

  // Relations under which it must be as right as before, each tried on each input.
  std::set<generators::Relation> relations = {};
  // Another program, called in the same way, that gets each input on which this one is right or
  // which it refuses.
  std::vector<std::string> against = {};

  // The user's texts for issue.md: the program's version and how it was built; what its documents
  // promise.
  std::string about = {};
  std::string promise = {};

  bool is_about_domains() const { return is_about_a_domain(claim); }
};

// The arguments with all placeholders replaced. `paths`: of the folder, the input and the mesh.
struct Paths {
  std::string folder;
  std::string input;
  std::string mesh;
};
std::vector<std::string> filled_in(const Subject& subject, const Paths& paths);

// Does an argument of the command hold this placeholder, braces and all?
bool mentions(const std::vector<std::string>& command, const std::string& placeholder);

}  // namespace circumspect::campaign
