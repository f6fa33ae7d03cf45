#include "fuzz/campaign/campaign.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>
#include <tuple>

#include "fuzz/campaign/finding_folder.hpp"
#include "fuzz/campaign/runner.hpp"
#include "fuzz/campaign/trial.hpp"
#include "inputs/dice.hpp"

namespace circumspect::campaign {
namespace {

using Clock = std::chrono::steady_clock;

// How often threads check whether there is work for them.
constexpr std::chrono::milliseconds kTick{20};

// The state that threads share. Cases are handed out, and registered, in order.
class Campaign {
 public:
  Campaign(const Plan& plan, Journal journal, const std::atomic<bool>& stop)
      : plan_(plan), stop_(stop), journal_(std::move(journal)) {
    for (const FindingRecord& record : journal_.findings()) {
      first_[record.signature] = record.case_number;
      if (!record.is_minimised) unfinished_.push_back(record);
      if (!record.is_minimised && record.is_cut_off) cut_off_.insert(record.signature);
    }
    minimising_ = unfinished_.size();
    for (const CaseRecord& record : journal_.cases()) count(record);
    result_.was_killed_before = journal_.was_killed();
    given_ = registered_ = tried_ = result_.cases_before = result_.cases;
    is_tried_ = registered_ == 0;
    is_held_back_ = is_tried_ && !plan_.goes_on;
  }

  // The outcome of a case, and its number of points.
  struct Ended {
    Outcome outcome;
    std::size_t points = 0;
    std::optional<TriedCase> tried = {};  // for the trial, if it is still open
  };

  // The life of a thread.
  void work(Runner& runner) {
    try {
      while (std::optional<FindingRecord> record = take_unfinished(true)) {
        finish(*record, runner);
      }
      while (const std::optional<std::size_t> number = take_case()) {
        const Input input = drawn(*number);
        Outcome outcome = runner.run(input);
        if (is_new(outcome)) outcome = runner.confirmed(input, outcome);
        if (is_known(outcome)) outcome.kind = OutcomeKind::kKnown;
        note(outcome);
        auto tried = for_trial(*number, input, outcome, runner);
        add(*number, {std::move(outcome), point_count(input), std::move(tried)}, runner);
      }
      end_trial();
      while (std::optional<FindingRecord> record = take_unfinished(false)) {
        finish(*record, runner);
      }
    } catch (const std::system_error& error) {
      // The disk is full, or the like: what is on it is valid, and the campaign can continue later.
      const std::lock_guard lock(mutex_);
      end_for(error.what());
    } catch (...) {
      fail(std::current_exception());
    }
    const std::lock_guard lock(mutex_);
    --working_;
    one_ended_.notify_all();
  }

  // All runners end, and result() throws it.
  void fail(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
  }

  // One more thread is about to work, or could not be started.
  void expect_one(bool more) {
    const std::lock_guard lock(mutex_);
    working_ += more ? 1 : static_cast<std::size_t>(-1);
    drawing_ += more ? 1 : static_cast<std::size_t>(-1);
  }
  // Waits for the end, but no longer than this.
  bool is_over_within(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return one_ended_.wait_for(lock, time, [this] { return working_ == 0; });
  }
  bool must_stop() {
    const std::lock_guard lock(mutex_);
    return must_end();
  }

  Progress progress() {
    const std::lock_guard lock(mutex_);
    return {result_.cases, first_.size(), seconds(), !drawing_is_over_, minimising_};
  }

  tl::expected<Result, std::string> result() {
    try {
      journal_.add_end();
    } catch (const std::system_error& error) {
      end_for(error.what());
    }
    if (failure_) std::rethrow_exception(failure_);
    if (!not_run_.empty()) return tl::unexpected(not_run_);
    result_.interrupted = stop_;
    if (is_tried_) result_.doubt = trial_.doubt();
    result_.seconds = seconds();
    for (const auto& [signature, number] : first_) {
      Finding finding{signature, family_of(number), number};
      finding.folder = finding_folder(plan_.output, signature);
      finding.cut_off = cut_off_.count(signature) != 0;
      for (const auto& family : result_.statistics) {
        const auto found = family.second.find(signature);
        if (found != family.second.end()) finding.count += found->second;
      }
      result_.findings.push_back(std::move(finding));
    }
    const auto place = [](const Finding& finding) {
      const std::string& name = finding.signature;
      return std::tuple(name.find("-flat") != name.npos, name.find("-extreme") != name.npos,
                        finding.case_number);
    };
    std::sort(result_.findings.begin(), result_.findings.end(),
              [&](const Finding& a, const Finding& b) { return place(a) < place(b); });
    return std::move(result_);
  }

 private:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  // Requires: the mutex is locked.
  bool must_end() const { return stop_ || failure_ || !not_run_.empty(); }

  bool time_is_over() const { return plan_.seconds && seconds() >= *plan_.seconds; }
  // Requires: the mutex is locked.
  bool time_for_cases_is_over() const {
    const double share = minimising_ > 0 ? kMinimisingShare : 0;
    return plan_.seconds && seconds() >= (1 - share) * *plan_.seconds;
  }

  // A thread makes its own finding a little smaller even when the time is over.
  std::optional<FindingRecord> take_unfinished(bool in_time) {
    const std::lock_guard lock(mutex_);
    if (must_end() || unfinished_.empty() || (in_time && time_is_over())) return std::nullopt;
    FindingRecord record = unfinished_.back();
    unfinished_.pop_back();
    return record;
  }

  std::optional<std::size_t> take_case() {
    const std::lock_guard lock(mutex_);
    const std::size_t replayed = plan_.replayed.size();
    const bool all_done =
        given_ >= replayed &&
        (plan_.sources.empty() || (plan_.cases && given_ - replayed >= *plan_.cases));
    drawing_is_over_ = drawing_is_over_ || all_done || time_for_cases_is_over();
    if (must_end() || drawing_is_over_) return std::nullopt;
    return given_++;
  }

  const Source& source_of(std::size_t number) const {
    return plan_.sources[(number - plan_.replayed.size()) % plan_.sources.size()];
  }
  std::string family_of(std::size_t number) const {
    if (number < plan_.replayed.size()) return "corpus";
    return source_of(number).family;
  }
  Input drawn(std::size_t number) {
    if (number < plan_.replayed.size()) return plan_.replayed[number].input;
    return source_of(number).drawn(seed_of_case(plan_.seed, number - plan_.replayed.size()));
  }

  // A finding counts only if it repeats, so the first of each signature is run again.
  bool is_new(const Outcome& outcome) {
    const std::lock_guard lock(mutex_);
    const auto is_same = [&](const auto& held_back) {
      return held_back.second.outcome.signature == outcome.signature;
    };
    return is_finding(outcome.kind) && first_.count(outcome.signature) == 0 &&
           std::none_of(waiting_.begin(), waiting_.end(), is_same);
  }

  bool is_known(const Outcome& outcome) const {
    return is_finding(outcome.kind) && std::find(plan_.known.begin(), plan_.known.end(),
                                                 outcome.signature) != plan_.known.end();
  }

  // The first failure is the reason: later ones may follow from it. Requires: the mutex is locked.
  void end_for(const std::string& reason) {
    if (not_run_.empty()) not_run_ = reason;
  }

  // The facts that the trial, if it is open, needs about a case that the runner has just run.
  std::optional<TriedCase> for_trial(std::size_t number, const Input& input, const Outcome& outcome,
                                     const Runner& runner) {
    {
      const std::lock_guard lock(mutex_);
      if (!is_tried_ || trial_.standing() != Trial::Standing::kOpen) return std::nullopt;
    }
    return tried_case(plan_.subject, input, outcome, runner, number < plan_.replayed.size());
  }

  // In the order of cases, so that nothing depends on the number of jobs. Requires: the mutex is
  // locked.
  void go_on_with_trial() {
    for (auto next = waiting_.find(tried_); next != waiting_.end() && next->first == tried_;
         ++next, ++tried_) {
      if (next->second.tried) trial_.look(*next->second.tried);
    }
    if (!is_held_back_ || trial_.standing() == Trial::Standing::kOpen) return;
    is_held_back_ = false;
    if (trial_.standing() == Trial::Standing::kFailed) end_for(trial_.doubt() + kGoOn);
  }

  // The cases may end before the trial does. When no thread has further cases, those that were held
  // back are registered after all; but after an interruption they are tried again the next time.
  void end_trial() {
    std::unique_lock lock(mutex_);
    --drawing_;
    while (is_held_back_ && drawing_ > 0 && !must_end()) one_ended_.wait_for(lock, kTick);
    if (!is_held_back_ || must_end()) return;
    is_held_back_ = false;
    for (FindingRecord& record : register_waiting()) unfinished_.push_back(std::move(record));
  }

  // Why cases were skipped or refused.
  void note(const Outcome& outcome) {
    constexpr std::size_t kMostReasons = 100;
    const std::lock_guard lock(mutex_);
    const bool says_why = outcome.kind == OutcomeKind::kSkipped ||
                          outcome.kind == OutcomeKind::kRefused ||
                          (outcome.kind == OutcomeKind::kHolds && !outcome.text.empty());
    if (!says_why) return;
    std::map<std::string, std::size_t>& reasons = result_.reasons[word(outcome.kind)];
    if (reasons.size() < kMostReasons) ++reasons[outcome.text];
  }

  // Registers the outcome of a case, and of later ones that waited for it. A thread that registers
  // new signatures makes their inputs small.
  void add(std::size_t number, Ended ended, Runner& runner) {
    std::vector<FindingRecord> fresh;
    {
      const std::lock_guard lock(mutex_);
      if (ended.outcome.kind == OutcomeKind::kInterrupted) return;
      if (ended.outcome.kind == OutcomeKind::kNotRun) return end_for(ended.outcome.text);
      waiting_.emplace(number, std::move(ended));
      go_on_with_trial();
      if (is_held_back_ || !not_run_.empty()) return;
      fresh = register_waiting();
    }
    for (const FindingRecord& record : fresh) finish(record, runner);
  }

  // The new findings among them. Requires: the mutex is locked.
  std::vector<FindingRecord> register_waiting() {
    std::vector<FindingRecord> fresh;
    for (auto next = waiting_.begin(); next != waiting_.end() && next->first == registered_;
         next = waiting_.erase(next)) {
      if (register_next(next->second)) {
        fresh.push_back({next->second.outcome.signature, next->first});
      }
    }
    minimising_ += fresh.size();
    return fresh;
  }

  // Is it the first with its signature? If so, its input is on the disk before the journal says so.
  bool register_next(const Ended& ended) {
    const Outcome& outcome = ended.outcome;
    const std::size_t number = registered_;
    const bool finds = is_finding(outcome.kind);
    if (outcome.kind == OutcomeKind::kFlaky && result_.first_flaky.empty()) {
      result_.first_flaky =
          "case " + std::to_string(number) + " of " + family_of(number) + ": " + outcome.text;
    }
    const bool is_new = finds && first_.count(outcome.signature) == 0;
    if (is_new) {
      write_input(finding_folder(plan_.output, outcome.signature), plan_.subject, drawn(number));
      journal_.add_finding(outcome.signature, number);
      first_[outcome.signature] = number;
    }
    const CaseRecord record{family_of(number), finds ? outcome.signature : word(outcome.kind),
                            finds, ended.points};
    journal_.add_case(number, record);
    count(record);
    ++registered_;
    return is_new;
  }

  void count(const CaseRecord& record) {
    ++result_.cases;
    ++result_.statistics[record.family][record.what];
    if (!record.points) return;
    auto& points = result_.points;
    if (!points) points = {*record.points, *record.points};
    points->first = std::min(points->first, *record.points);
    points->second = std::max(points->second, *record.points);
  }

  // The remaining time in equal parts for those that wait, but no more than the plan allows for
  // one.
  MinimiseLimits limits_now() {
    MinimiseLimits limits = plan_.minimise;
    if (!plan_.seconds) return limits;
    const std::lock_guard lock(mutex_);
    const double at_once = static_cast<double>(plan_.jobs + 1);
    const double rounds = std::max(1.0, std::ceil(static_cast<double>(minimising_) / at_once));
    const double left = std::max(0.0, *plan_.seconds - seconds());
    limits.time = std::min(limits.time, std::chrono::duration<double>(left / rounds));
    return limits;
  }

  // The input to begin with: the one that was found, or the result of an earlier call.
  Input begun(const FindingRecord& record, const Input& found, Runner& runner) {
    if (!record.is_cut_off) return found;
    const auto reached =
        read_minimal(finding_folder(plan_.output, record.signature), plan_.subject);
    return reached && runner.run_anew(*reached).signature == record.signature ? *reached : found;
  }

  void finish(const FindingRecord& record, Runner& runner) {
    const Input found = drawn(record.case_number);
    const MinimiseLimits limits = limits_now();
    const Clock::time_point begin = Clock::now();
    const Input minimal =
        minimised(begun(record, found, runner), record.signature, runner, limits, stop_);
    const bool is_cut_off =
        limits.time < plan_.minimise.time && Clock::now() - begin >= limits.time;
    Outcome outcome = runner.run_anew(minimal);
    if (stop_ || outcome.kind == OutcomeKind::kInterrupted) return;
    if (outcome.kind == OutcomeKind::kNotRun) {
      const std::lock_guard lock(mutex_);
      return end_for(outcome.text);
    }
    const std::string other = runner.said_of_other(outcome.image ? *outcome.image : minimal);
    if (!other.empty()) outcome.explanation += "The other program, " + other + "\n";
    if (outcome.signature != record.signature) {
      outcome.text = "not every time: when it was run again, " +
                     (outcome.signature.empty() ? "the mesh was right" : outcome.signature);
      outcome.signature = record.signature;
    }
    const std::string folder = finding_folder(plan_.output, record.signature);
    write_minimal(folder, plan_.subject,
                  {family_of(record.case_number), record.case_number, plan_.seed}, found, minimal,
                  outcome, runner);
    const std::lock_guard lock(mutex_);
    --minimising_;
    if (is_cut_off) {
      journal_.add_cut_off(record.signature);
      cut_off_.insert(record.signature);
    } else {
      journal_.add_minimised(record.signature);
      cut_off_.erase(record.signature);
    }
  }

  const Plan& plan_;
  const std::atomic<bool>& stop_;
  const Clock::time_point start_ = Clock::now();

  std::mutex mutex_;                   // for all below
  std::condition_variable one_ended_;  // a thread
  Journal journal_;
  std::size_t working_ = 0;  // threads; among them
  std::size_t drawing_ = 0;  // these may still have cases to run
  std::size_t given_ = 0;
  std::size_t registered_ = 0;
  std::map<std::size_t, Ended> waiting_;
  Trial trial_;
  std::size_t tried_ = 0;      // the trial has looked at the cases before this one
  bool is_tried_ = false;      // the campaign begins in this call
  bool is_held_back_ = false;  // nothing is registered until the trial is over
  std::map<std::string, std::size_t> first_;
  std::vector<FindingRecord> unfinished_;
  std::size_t minimising_ = 0;  // those, and what is being made small
  std::set<std::string> cut_off_;
  bool drawing_is_over_ = false;
  Result result_;
  std::string not_run_;
  std::exception_ptr failure_;
};

}  // namespace

std::uint64_t seed_of_case(std::uint64_t seed, std::uint64_t number) {
  return generators::mixed(generators::mixed(seed) ^ number);
}

tl::expected<Result, std::string> run(const Plan& plan, const std::atomic<bool>& stop,
                                      const std::function<void(const Progress&)>& progress) {
  auto journal = Journal::open(plan.output, plan.settings);
  if (!journal) return tl::unexpected(journal.error());
  std::optional<Gate> gate;  // Runners use it until they end.
  std::vector<std::unique_ptr<Runner>> runners;
  try {
    gate.emplace(plan.jobs);
    // Runners fork, which is cheapest before there are threads. One more than programs may run: it
    // judges, and prepares the next input, while the others wait for their programs.
    for (std::size_t i = 0; i < plan.jobs + 1; ++i) {
      runners.push_back(std::make_unique<Runner>(plan.subject, gate->turn()));
    }
    journal->add_begin();
  } catch (const std::system_error& error) {
    return tl::unexpected(std::string(error.what()));
  }
  Campaign campaign(plan, std::move(*journal), stop);
  std::vector<std::thread> threads;
  threads.reserve(runners.size());
  // No exception may pass threads that are not joined.
  try {
    for (const auto& runner : runners) {
      campaign.expect_one(true);
      threads.emplace_back([&campaign, &runner] { campaign.work(*runner); });
    }
  } catch (const std::exception&) {
    // The system allows no more threads, or there is no memory for one: those that exist do the
    // work.
    threads.empty() ? campaign.work(*runners.front()) : campaign.expect_one(false);
  }
  while (!campaign.is_over_within(kTick)) {
    if (campaign.must_stop()) {
      for (const auto& runner : runners) runner->interrupt();
    }
    try {
      progress(campaign.progress());
    } catch (...) {
      campaign.fail(std::current_exception());
    }
  }
  for (std::thread& thread : threads) thread.join();
  auto result = campaign.result();
  if (result) result->containment = runners.front()->containment();
  return result;
}

}  // namespace circumspect::campaign
