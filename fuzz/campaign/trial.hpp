// The first inputs of a campaign test its command: does the program read its input, and does the
// campaign understand its answers?
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "fuzz/campaign/input.hpp"
#include "fuzz/campaign/outcome.hpp"
#include "fuzz/campaign/runner.hpp"
#include "fuzz/campaign/subject.hpp"

namespace circumspect::campaign {

// What a trial needs to know about a case.
struct TriedCase {
  OutcomeKind kind = OutcomeKind::kInterrupted;
  std::string signature = {};
  std::string text = {};              // from the outcome
  std::string first_line = {};        // that the program printed
  std::string misunderstanding = {};  // judge_mesh.hpp
  bool is_replayed = false;           // from a file, perhaps kept because the program fails on it
  bool is_trivial = false;            // the right mesh has one simplex of full dimension, or none
};

// `runner` has just run the program on the input, with this outcome.
TriedCase tried_case(const Subject& subject, const Input& input, const Outcome& outcome,
                     const Runner& runner, bool is_replayed);

// A program that cannot start fails on every input, and so does one whose answers are not
// understood. Neither is worth a finding: the author of the command wants to know before anything
// is made small.
//
// A mesh that breaks a rule does not count here, as long as it is a mesh of the input: a program
// may be wrong on all inputs. Nor does it count if a program refuses an input, or is right on one
// with at most one simplex.
class Trial {
 public:
  static constexpr std::size_t kFailures = 10;

  enum class Standing { kOpen, kPassed, kFailed };
  Standing standing() const { return standing_; }

  // In the order of the cases.
  void look(const TriedCase& one);

  // The doubt about the command, in one line; empty if the program has done what it should, or has
  // not been seen to fail.
  std::string doubt() const;

 private:
  Standing standing_ = Standing::kOpen;
  std::size_t looked_at_ = 0;
  std::size_t failures_ = 0;
  bool was_right_about_trivial_ = false;
  std::map<std::string, std::size_t> signatures_;
  std::map<std::string, std::size_t> misunderstandings_;
  TriedCase first_;
};

// The note after a doubt that ends a campaign.
inline constexpr const char* kGoOn =
    "; nothing was kept. --go-on draws more inputs, and makes failures small";

}  // namespace circumspect::campaign
