// Runs a program on many inputs, and keeps the failures.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "fuzz/campaign/input.hpp"
#include "fuzz/campaign/journal.hpp"
#include "fuzz/campaign/subject.hpp"
#include "inputs/minimise.hpp"

namespace circumspect::campaign {

using generators::MinimiseLimits;

// A source of inputs: each seed stands for one.
struct Source {
  std::string family;
  std::function<Input(std::uint64_t seed)> drawn;
};

// An input from a file, which is tried before all drawn ones.
struct Replayed {
  std::string name;
  Input input;
};

struct Plan {
  Subject subject;
  std::vector<Source> sources;
  std::vector<Replayed> replayed = {};
  std::uint64_t seed = 0;
  std::optional<std::size_t> cases = {};  // drawn ones; by default, until the time is over
  // Of this call, including making inputs small; by default, until the cases are done and the
  // findings are small.
  std::optional<double> seconds = {};
  std::size_t jobs = 1;
  std::string output;                   // the folder for the journal and the findings
  Settings settings = {};               // what must not change when it is continued
  std::vector<std::string> known = {};  // signatures that are not findings
  std::string magnitudes = {};          // what numbers the drawn inputs have, for the verdict
  MinimiseLimits minimise = {};
  bool goes_on = false;  // even if the program fails on all inputs of the trial (trial.hpp)
};

// Once something is found, cases are drawn until this share of the time is left, which is for
// making it small.
inline constexpr double kMinimisingShare = 0.25;

// Everything with one signature.
struct Finding {
  std::string signature;
  std::string family;           // of the first case
  std::size_t case_number = 0;  // the first case
  std::size_t count = 0;
  std::string folder = {};
  bool cut_off = false;  // there was no time to make it smaller: the next call continues
};

struct Result {
  std::size_t cases = 0;           // in all, including those of earlier calls
  std::size_t cases_before = 0;    // done by earlier calls
  bool was_killed_before = false;  // the last of them did not end by itself
  // In the order of their first cases, except that those with extreme numbers follow the others,
  // and those of flat sets come last.
  std::vector<Finding> findings = {};
  // For each family, how often each outcome occurred: "holds", "refused", "skipped", "flaky",
  // "known", or a signature.
  std::map<std::string, std::map<std::string, std::size_t>> statistics = {};
  std::string first_flaky = {};  // of this call: cases that were wrong only once, and how
  // The least and the largest number of points of all cases; for this call, the count of each
  // reason for skipped cases, for refused ones, and for different answers of another program, for
  // the first reasons only.
  std::optional<std::pair<std::size_t, std::size_t>> points = {};
  std::map<std::string, std::map<std::string, std::size_t>> reasons = {};
  // If the campaign began in this call and its program has failed on all inputs so far: why the
  // command may be wrong. Otherwise empty.
  std::string doubt = {};
  bool interrupted = false;
  double seconds = 0;  // of this call
  Containment containment = Containment::kSupervisor;
};

// The progress, for a progress line.
struct Progress {
  std::size_t cases = 0;
  std::size_t signatures = 0;
  double seconds = 0;
  bool drawing = true;         // will there be more cases?
  std::size_t minimising = 0;  // findings that are being made small, or wait for it
};

// Case i is the i-th replayed input or, after those, the input that seed_of_case(seed, i) stands
// for in source i mod sources.size(). Cases are counted in this order whatever the number of jobs,
// so the first case with a signature, and everything that follows from it, depends only on the
// plan, the program and the number of cases. If `output` has a journal with the same settings, the
// campaign continues there. When the time is over, running cases are finished, and findings that
// are not yet small are left to the next call, which continues there. When `stop` becomes true, it
// ends within a second; running cases are forgotten, and run the next time. Unless Plan::goes_on is
// set, a new campaign is on trial: nothing is written before the program has made a mesh of an
// input, or there are no more cases. Errors: the journal belongs to another campaign; the program
// cannot be started, or has failed its trial. Requires: sources or replayed inputs; cases or
// seconds; jobs ≥ 1; called while there is one thread.
tl::expected<Result, std::string> run(const Plan& plan, const std::atomic<bool>& stop,
                                      const std::function<void(const Progress&)>& progress);

// splitmix64 of both numbers: seeds of different campaigns have nothing in common.
std::uint64_t seed_of_case(std::uint64_t seed, std::uint64_t number);

// Makes an input small on which a program fails with this outcome's signature. If `stop` becomes
// true, returns the smallest so far.
Input minimised(const Input& input, const std::string& signature, class Runner& runner,
                const MinimiseLimits& limits, const std::atomic<bool>& stop);

}  // namespace circumspect::campaign
