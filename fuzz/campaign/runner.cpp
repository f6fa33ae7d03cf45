#include "fuzz/campaign/runner.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "fuzz/campaign/judge_mesh.hpp"
#include "fuzz/campaign/outcome.hpp"
#include "fuzz/process/apart.hpp"
#include "fuzz/process/folders.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::campaign {
namespace {

namespace fs = std::filesystem;

// The memory for our own work on a run, as a multiple of the program's.
constexpr std::uint64_t kJudgingMemory = 4;

// A file system in memory is faster and does not wear out a disk. A container may have a very small
// one.
fs::path place_for_scratch(const Limits& limits) {
  const fs::path memory = "/dev/shm";
  std::error_code error;
  const fs::space_info space = fs::space(memory, error);
  const bool has_room = !error && space.available / 32 >= limits.output;
  const char* chosen = std::getenv("TMPDIR");
  if (chosen != nullptr && *chosen == '\0') chosen = nullptr;
  if (has_room && chosen == nullptr && access(memory.c_str(), W_OK) == 0) return memory;
  return fs::absolute(chosen == nullptr ? "/tmp" : chosen);
}

std::string new_scratch_folder(const Limits& limits) {
  std::string path = (place_for_scratch(limits) / "circumspect-campaign-XXXXXX").string();
  if (mkdtemp(path.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), path);
  }
  return path;
}

// Is it a file, and not a pipe or a link that would mislead a reader?
bool is_plain_file(const std::string& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

// Our own errors in reading a file, as opposed to what a program may do to its own files.
std::string why_not_read(const std::string& path) {
  char byte = 0;
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  const bool reads = file >= 0 && read(file, &byte, 1) >= 0;
  const int reason = reads ? 0 : errno;
  if (file >= 0) close(file);
  const bool ours = reason == EMFILE || reason == ENFILE || reason == ENOMEM || reason == EIO;
  return ours ? path + ": " + std::strerror(reason) : "";
}

// The beginning of a file, about as much as a person reads.
std::string beginning_of(const std::string& path) {
  constexpr std::size_t kBytes = 8000;
  if (!is_plain_file(path)) return "";
  std::string text(kBytes, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(kBytes));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return text;
}

std::string signal_name(int number) {
  const char* const name = sigabbrev_np(number);
  return name == nullptr ? std::to_string(number) : std::string("SIG") + name;
}

// The most informative line: the first that mentions an error, else the last.
std::string telling_line(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    last = line;
    if (line.find("rror") != std::string::npos || line.find("ERROR") != std::string::npos) break;
  }
  return last.empty() ? "and said nothing" : formats::quote(last);
}

bool speaks_of_memory(const std::string& text) {
  const auto has = [&](const char* part) { return text.find(part) != std::string::npos; };
  return has("bad_alloc") || has("ut of memory") || has("MemoryError") ||
         has("not enough memory") || has("nsufficient memory") || has("annot allocate memory") ||
         has("memory exhausted");
}

// How much of its answer a killed worker had given.
std::string missing_lines(const Ended& ended) {
  if (ended.expected_lines == 0) return "";
  return fmt::format(": expected {} of its answer, found {}",
                     report::counted(ended.expected_lines, "line"), ended.lines);
}

Outcome not_run(const std::string& text) {
  return {OutcomeKind::kNotRun, word(OutcomeKind::kNotRun), text};
}

// Is there so little disk space left that a program may have failed because of it?
bool is_full(const std::string& folder) {
  struct statvfs status {};
  constexpr std::uint64_t kNeeded = 1 << 20;
  return statvfs(folder.c_str(), &status) == 0 && status.f_bavail * status.f_frsize < kNeeded;
}

}  // namespace

Runner::Runner(const Subject& subject, Turn turn)
    : subject_(subject),
      scratch_(new_scratch_folder(subject.limits)),
      supervisor_(scratch_, turn, subject.containment) {
  if (subject.against.empty()) return;
  other_subject_ = subject;
  other_subject_->command = subject.against;
  other_subject_->against.clear();
  other_subject_->relations.clear();
  other_ = std::make_unique<Runner>(*other_subject_, turn);
}

Runner::~Runner() = default;

std::string Runner::mesh_file() const {
  const std::string path = (subject_.writes_stdout ? scratch_ : work_) + "/" + subject_.mesh_name;
  return is_plain_file(path) ? path : "";
}

// The line `error TEXT` of a worker, if that is its whole answer.
std::optional<std::string> Runner::said_error() const {
  if (!subject_.talk) return std::nullopt;
  std::istringstream text(beginning_of(scratch_ + "/" + subject_.mesh_name));
  std::string word;
  std::string line;
  if (!(text >> word) || word != "error") return std::nullopt;
  std::getline(text, line);
  if (text >> word) return std::nullopt;
  return line.empty() ? "it said no more than error" : formats::quote(line.substr(1));
}

std::string Runner::said() const {
  const auto said_in = [&](const std::string& name) {
    constexpr std::size_t kShown = 4000;
    return without_places(beginning_of(scratch_ + "/" + name)).substr(0, kShown);
  };
  return (subject_.writes_stdout ? "" : said_in("stdout")) + said_in("stderr");
}

std::string Runner::first_line_said() const {
  for (const char* const name : {"/stderr", "/stdout"}) {
    if (subject_.writes_stdout && name == std::string_view("/stdout")) continue;
    std::istringstream lines(without_places(beginning_of(scratch_ + name)));
    for (std::string line; std::getline(lines, line);) {
      if (line.find_first_not_of(" \t\r") != std::string::npos) return line;
    }
  }
  return "";
}

std::string Runner::without_places(std::string text) const {
  replace_all(text, work_ + "/", "");
  replace_all(text, scratch_ + "/", "");
  return text;
}

// If the folder of the last run cannot be emptied, it is left, and the next run gets another one.
// The program may have deleted the folder around it.
std::string Runner::prepare_work_folder() {
  // A link in its place would lead to other people's files, which must not be deleted.
  if (!is_folder(scratch_) && (!removed(scratch_) || mkdir(scratch_.c_str(), 0700) != 0)) {
    return scratch_ + ": " + std::strerror(errno);
  }
  if (!work_.empty() && emptied(work_)) return "";
  if (work_.empty() || !removed(work_)) {
    work_ = scratch_ + "/work" + (folders_ == 0 ? "" : std::to_string(folders_));
    ++folders_;
  }
  if (mkdir(work_.c_str(), 0700) == 0) return "";
  return work_ + ": " + std::strerror(errno);
}

Outcome Runner::run(const Input& input) {
  const bool anew = !has_talked_;
  has_talked_ = true;
  return run(input, anew);
}

Outcome Runner::run_anew(const Input& input) { return run(input, true); }

Outcome Runner::confirmed(const Input& input, const Outcome& outcome) {
  constexpr int kRuns = 3;
  for (int i = 0; i < kRuns; ++i) {
    const Outcome again = run_anew(input);
    const bool is_settled = is_finding(again.kind) || again.kind == OutcomeKind::kNotRun ||
                            again.kind == OutcomeKind::kInterrupted;
    if (is_settled) return again;
  }
  return {OutcomeKind::kFlaky, word(OutcomeKind::kFlaky),
          outcome.signature + " once, and not when it was run again: " + outcome.text};
}

Outcome Runner::run(const Input& input, bool anew) {
  const auto is_fair = [](const Outcome& outcome) {
    return outcome.kind == OutcomeKind::kHolds || outcome.kind == OutcomeKind::kRefused;
  };
  Outcome outcome = run_once(input, anew);
  if (is_fair(outcome) && other_) outcome = against_other(input, std::move(outcome), anew);
  if (!is_fair(outcome)) return outcome;
  return after_relations(input, std::move(outcome), anew);
}

// A program that is right, or refuses, must do the same when nothing relevant has changed.
Outcome Runner::after_relations(const Input& input, Outcome outcome, bool anew) {
  for (const generators::Relation relation : subject_.relations) {
    auto changed = image_of(relation, input);
    if (!changed) continue;
    Outcome after = run_once(*changed, anew);
    if (after.kind == OutcomeKind::kInterrupted || after.kind == OutcomeKind::kNotRun) return after;
    if (after.kind == OutcomeKind::kSkipped) continue;
    const std::string what(name(relation));
    const bool refuses = outcome.kind == OutcomeKind::kRefused;
    const bool refuses_then = after.kind == OutcomeKind::kRefused;
    if (refuses != refuses_then && !is_finding(after.kind)) {
      const Outcome& refusal = refuses ? outcome : after;
      after = {OutcomeKind::kDiffers, marked("refused", input),
               "it " + std::string(refuses ? "refuses" : "takes") + " the input, and " +
                   (refuses ? "takes" : "refuses") + " it after a change of " + what + ": " +
                   refusal.text};
      after.explanation = indented(said());
    }
    if (!is_finding(after.kind)) continue;
    after.signature += "-after-" + what;
    after.image = std::move(changed);
    return after;
  }
  return outcome;
}

// If there is more than one right answer, both may be right and differ.
Outcome Runner::against_other(const Input& input, Outcome outcome, bool anew) {
  const Outcome theirs = anew ? other_->run_anew(input) : other_->run(input);
  if (theirs.kind == OutcomeKind::kInterrupted || theirs.kind == OutcomeKind::kNotRun)
    return theirs;
  const std::string name = fs::path(subject_.against.front()).filename().string();
  if (is_finding(theirs.kind)) outcome.text = name + " is wrong: " + theirs.signature;
  if (theirs.kind != OutcomeKind::kHolds) return outcome;
  if (outcome.kind == OutcomeKind::kRefused) {
    return {OutcomeKind::kDiffers, marked("refused-alone", input),
            "it refuses what " + name + " takes, and gets right: " + outcome.text,
            indented(said())};
  }
  const Comparison comparison = compared(subject_, input, mesh_file(), other_->mesh_file());
  if (comparison.are_same) return outcome;
  if (!comparison.is_unique) {
    outcome.text = "another mesh than that of " + name + "; both are right";
    return outcome;
  }
  return {OutcomeKind::kDiffers, marked("other-mesh", input),
          "expected the mesh of " + name +
              ", for there is one Delaunay triangulation of the points, found another mesh",
          indented(said())};
}

std::string Runner::said_of_other(const Input& input) {
  if (!other_) return "";
  const Outcome theirs = other_->run_anew(input);
  return on_one_line(fs::path(subject_.against.front()).filename().string()) + ": " +
         (is_finding(theirs.kind) ? theirs.signature : word(theirs.kind));
}

std::string Runner::marked(const std::string& signature, const Input& input) const {
  const auto set = judged_points(input);
  const bool is_extreme = set && !generators::lie_within(*set, kOrdinary);
  return signature + (is_extreme ? "-extreme" : "") + (is_flat(subject_, input) ? "-flat" : "");
}

Outcome Runner::run_once(const Input& input, bool anew) {
  const std::optional<std::string> reason = reason_in_time(input);
  if (!reason) return {OutcomeKind::kInterrupted, word(OutcomeKind::kInterrupted), "interrupted"};
  if (!reason->empty()) return {OutcomeKind::kSkipped, "skipped", *reason};
  const auto text = file_text(input, formats::extension(subject_.input_name), subject_.first_index,
                              subject_.dimension);
  if (!text) return {OutcomeKind::kSkipped, "skipped", "the format has no way to say this input"};
  Outcome outcome = run_on(input, *text, anew);
  // Someone else may have killed the supervisor: only a program that does it again is to blame.
  if (outcome.kind == OutcomeKind::kKillsParent) outcome = run_on(input, *text, anew);
  if (!is_finding(outcome.kind)) return outcome;
  if (is_full(scratch_)) return not_run(scratch_ + ": the disk is full");
  outcome.signature = marked(outcome.signature, input);
  return outcome;
}

Outcome Runner::run_on(const Input& input, const std::string& text, bool anew) {
  const std::string fault = prepare_work_folder();
  if (!fault.empty()) return not_run(fault);
  const Paths paths{work_, work_ + "/" + subject_.input_name, work_ + "/" + subject_.mesh_name};
  if (!(std::ofstream(paths.input, std::ios::binary) << text << std::flush)) {
    return not_run(paths.input + ": cannot be written: " + std::strerror(errno));
  }
  Request request;
  request.command = filled_in(subject_, paths);
  request.folder = work_;
  if (subject_.reads_stdin) request.stdin_file = paths.input;
  request.stdout_file = scratch_ + "/" + (subject_.writes_stdout ? subject_.mesh_name : "stdout");
  request.stderr_file = scratch_ + "/stderr";
  if (!anew) request.talk = subject_.talk;
  const Ended ended = supervisor_.run(request, subject_.limits);
  Outcome outcome = outcome_of(ended, input);
  if (outcome.kind == OutcomeKind::kUnreadable || outcome.kind == OutcomeKind::kNoMesh) {
    // The program is to blame for what is not a mesh twice, and not for a call of our own that
    // failed.
    const std::string reason = why_not_read(
        subject_.writes_stdout ? request.stdout_file : work_ + "/" + subject_.mesh_name);
    if (!reason.empty()) return not_run(reason);
    outcome = outcome_of(ended, input);
  }
  outcome.text = on_one_line(without_places(std::move(outcome.text)));
  outcome.explanation = on_lines(without_places(std::move(outcome.explanation)));
  return outcome;
}

Outcome Runner::outcome_of(const Ended& ended, const Input& input) const {
  const auto named = [&](OutcomeKind kind, const std::string& detail, const std::string& text) {
    return Outcome{kind, word(kind) + detail, text, indented(said())};
  };
  switch (ended.ending) {
    case Ending::kInterrupted:
      return named(OutcomeKind::kInterrupted, "", "interrupted");
    case Ending::kNotStarted:
      return named(OutcomeKind::kNotRun, "",
                   subject_.command.front() + ": could not be run: " + std::strerror(ended.code));
    case Ending::kSupervisorKilled:
      return named(OutcomeKind::kKillsParent, "", "it killed the process that started it");
    case Ending::kTimeLimit:
      return named(OutcomeKind::kHang, "",
                   "it ran longer than allowed, and was killed" + missing_lines(ended));
    case Ending::kOutOfStep:
      return named(OutcomeKind::kUnreadable, "",
                   "expected nothing behind the answer to the case before this one, found " +
                       telling_line(beginning_of(scratch_ + "/" + subject_.mesh_name)));
    case Ending::kOutputLimit:
      return named(OutcomeKind::kOutputLimit, "", "it wrote more than allowed, and was killed");
    case Ending::kProcessLimit:
      return named(OutcomeKind::kProcessLimit, "",
                   "it started more processes than allowed, and was killed");
    default:
      break;
  }
  const std::string what = said();
  const bool refuses =
      (ended.ending == Ending::kExited && subject_.refusal_codes.count(ended.code) != 0) ||
      std::any_of(subject_.refusal_texts.begin(), subject_.refusal_texts.end(),
                  [&](const std::string& text) { return what.find(text) != std::string::npos; });
  if (refuses) return named(OutcomeKind::kRefused, "", telling_line(what));
  if (const auto words = said_error(); words) return named(OutcomeKind::kRefused, "", *words);
  const bool failed = ended.ending == Ending::kSignalled || ended.code != 0;
  if (failed && subject_.limits.memory != 0 && speaks_of_memory(what)) {
    return named(OutcomeKind::kMemoryLimit, "",
                 "its memory did not suffice: " + telling_line(what));
  }
  if (ended.ending == Ending::kSignalled) {
    const std::string name = signal_name(ended.code);
    return named(OutcomeKind::kCrash, "-" + name, "it died of signal " + name);
  }
  if (ended.code != 0) {
    const std::string code = std::to_string(ended.code);
    return named(OutcomeKind::kExitCode, "-" + code,
                 "it ended with exit code " + code + ": " + telling_line(what));
  }
  const std::string mesh = mesh_file();
  if (mesh.empty() || (subject_.writes_stdout && fs::file_size(mesh) == 0)) {
    return named(OutcomeKind::kNoMesh, "",
                 "it ended with exit code 0 and wrote no " + subject_.mesh_name);
  }
  return judged_in_time(input, mesh);
}

// Why an input is skipped, within the limits of judging; nothing if it was interrupted. Examining a
// domain in space may take as long as judging a mesh of it.
std::optional<std::string> Runner::reason_in_time(const Input& input) const {
  if (!subject_.is_about_domains() || subject_.dimension < 3)
    return reason_to_skip(subject_, input);
  const Apart apart =
      computed_apart([&] { return reason_to_skip(subject_, input); }, subject_.judging_seconds,
                     kJudgingMemory * subject_.limits.memory, is_interrupted_);
  switch (apart.end) {
    case Apart::End::kTimeLimit:
      return fmt::format("examining the domain takes longer than {:g} s (--limit-judging)",
                         subject_.judging_seconds);
    case Apart::End::kMemoryLimit:
      return "examining the domain takes more memory than there is for it (--limit-memory, four "
             "times)";
    case Apart::End::kInterrupted:
      return std::nullopt;
    case Apart::End::kDone:
      break;
  }
  return apart.text;
}

// A small file has short numbers and is judged quickly: a separate process would take longer.
Outcome Runner::judged_in_time(const Input& input, const std::string& mesh) const {
  constexpr std::uintmax_t kSmallFile = 4096;
  constexpr std::size_t kFewPoints = 64;
  if (fs::file_size(mesh) <= kSmallFile && point_count(input) <= kFewPoints) {
    return judged(subject_, input, mesh);
  }
  const Apart apart = computed_apart([&] { return bytes_of(judged(subject_, input, mesh)); },
                                     subject_.judging_seconds,
                                     kJudgingMemory * subject_.limits.memory, is_interrupted_);
  const auto limited = [&](const std::string& what) {
    return Outcome{OutcomeKind::kJudgingLimit, word(OutcomeKind::kJudgingLimit),
                   subject_.mesh_name + ": judging it takes " + what, indented(said())};
  };
  switch (apart.end) {
    case Apart::End::kTimeLimit:
      return limited(fmt::format("longer than {:g} s (--limit-judging)", subject_.judging_seconds));
    case Apart::End::kMemoryLimit:
      return limited("more memory than there is for it (--limit-memory, four times)");
    case Apart::End::kInterrupted:
      return {OutcomeKind::kInterrupted, word(OutcomeKind::kInterrupted), "interrupted"};
    case Apart::End::kDone:
      break;
  }
  return outcome_of_bytes(apart.text);
}

}  // namespace circumspect::campaign
