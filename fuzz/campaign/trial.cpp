#include "fuzz/campaign/trial.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "fuzz/campaign/judge_mesh.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/model/rule.hpp"

namespace circumspect::campaign {
namespace {

// After so many inconclusive cases, the trial ends.
constexpr std::size_t kMostLooks = 100;

// The signature without the suffixes for inputs: a program that cannot start fails on every input.
std::string without_marks(const std::string& signature) {
  return signature.substr(0, std::min(signature.find("-extreme"), signature.find("-flat")));
}

bool breaks(const TriedCase& one, Rule rule) {
  return one.signature.rfind(identifier(rule), 0) == 0;
}

// Is it inconclusive about the command?
bool says_nothing(const TriedCase& one) {
  switch (one.kind) {
    case OutcomeKind::kSkipped:
    case OutcomeKind::kRefused:
    case OutcomeKind::kFlaky:
    case OutcomeKind::kJudgingLimit:
      return true;
    case OutcomeKind::kHolds:
      return one.is_trivial;
    default:
      return false;
  }
}

// Was there no mesh of the input, or is it one only if it is read in another way?
bool is_failure(const TriedCase& one) {
  if (one.kind == OutcomeKind::kFails) {
    return !one.misunderstanding.empty() || breaks(one, Rule::kUnknownVertex) ||
           breaks(one, Rule::kWrongDimension);
  }
  return is_finding(one.kind) && one.kind != OutcomeKind::kDiffers;
}

std::pair<std::string, std::size_t> most_frequent(const std::map<std::string, std::size_t>& all) {
  return *std::max_element(all.begin(), all.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
}

}  // namespace

TriedCase tried_case(const Subject& subject, const Input& input, const Outcome& outcome,
                     const Runner& runner, bool is_replayed) {
  TriedCase tried{outcome.kind, outcome.signature, outcome.text, runner.first_line_said()};
  tried.is_replayed = is_replayed;
  // An image is a different input, and was tried because the program was right on this one.
  if (outcome.image) tried.kind = OutcomeKind::kDiffers;
  if (tried.kind == OutcomeKind::kHolds) {
    tried.is_trivial = point_count(input) <= subject.dimension + 1 || is_flat(subject, input);
  }
  const bool is_of_mesh = tried.kind == OutcomeKind::kFails ||
                          tried.kind == OutcomeKind::kUnreadable ||
                          tried.kind == OutcomeKind::kOtherPoints;
  const std::string mesh = is_of_mesh ? runner.mesh_file() : "";
  if (!mesh.empty()) tried.misunderstanding = misunderstanding(subject, input, mesh);
  return tried;
}

void Trial::look(const TriedCase& one) {
  was_right_about_trivial_ =
      was_right_about_trivial_ || (one.kind == OutcomeKind::kHolds && one.is_trivial);
  if (standing_ != Standing::kOpen || says_nothing(one)) {
    if (++looked_at_ >= kMostLooks && standing_ == Standing::kOpen) standing_ = Standing::kPassed;
    return;
  }
  if (!is_failure(one)) {
    standing_ = Standing::kPassed;
    return;
  }
  if (one.is_replayed) return;
  if (failures_ == 0) first_ = one;
  ++signatures_[without_marks(one.signature)];
  if (!one.misunderstanding.empty()) ++misunderstandings_[one.misunderstanding];
  if (++failures_ == kFailures) standing_ = Standing::kFailed;
}

std::string Trial::doubt() const {
  if (standing_ == Standing::kPassed || failures_ == 0) return "";
  if (!misunderstandings_.empty()) {
    const auto [text, count] = most_frequent(misunderstandings_);
    return fmt::format("{} ({} of the {} inputs on which the program fails)", text, count,
                       failures_);
  }
  // The first case of the most frequent kind tells what happened.
  std::string said =
      signatures_.size() == 1
          ? first_.text
          : fmt::format("{} of {} times {}; the first time {}", most_frequent(signatures_).second,
                        failures_, most_frequent(signatures_).first, first_.text);
  const std::string quoted = formats::quote(first_.first_line);
  // A Python traceback names the error at its end, and its first line says nothing.
  const bool says_more = !first_.first_line.empty() && said.find(quoted) == std::string::npos &&
                         first_.first_line.rfind("Traceback", 0) != 0;
  if (says_more) said += ", and said " + quoted;
  return fmt::format("the program fails on every input{} ({} until now): is the command right? {}",
                     was_right_about_trivial_ ? " of more than one simplex" : "", failures_, said);
}

}  // namespace circumspect::campaign
