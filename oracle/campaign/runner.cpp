#include "oracle/campaign/runner.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "oracle/campaign/judge_mesh.hpp"
#include "oracle/formats/mesh_files.hpp"

namespace circumspect::campaign {
namespace {

namespace fs = std::filesystem;

// A file system in memory is faster, and wears nothing out. A container may have a very small one.
fs::path place_for_scratch(const Limits& limits) {
  const fs::path memory = "/dev/shm";
  std::error_code error;
  const fs::space_info space = fs::space(memory, error);
  const bool has_room = !error && space.available / 32 >= limits.output;
  const bool chosen = std::getenv("TMPDIR") != nullptr;
  return has_room && !chosen && access(memory.c_str(), W_OK) == 0 ? memory
                                                                  : fs::temp_directory_path();
}

std::string new_scratch_folder(const Limits& limits) {
  std::string path = (place_for_scratch(limits) / "circumspect-campaign-XXXXXX").string();
  if (mkdtemp(path.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), path);
  }
  return path;
}

// The beginning of a file, as much of it as a person reads.
std::string beginning_of(const std::string& path) {
  constexpr std::size_t kBytes = 4000;
  std::string text(kBytes, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(kBytes));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return text;
}

// Is it a file, and not a pipe or a link that would lead a reader astray?
bool is_plain_file(const std::string& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

std::string signal_name(int number) {
  const char* const name = sigabbrev_np(number);
  return name == nullptr ? std::to_string(number) : std::string("SIG") + name;
}

// The line that says most: the first that speaks of an error, else the last.
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

// Deletes the files in a folder; false if it is no folder any more, or holds anything that stays.
bool emptied(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(folder, error))) return false;
  std::vector<std::string> paths;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    paths.push_back(entry->path().string());
  }
  return !error && std::all_of(paths.begin(), paths.end(), [](const std::string& path) {
    return unlink(path.c_str()) == 0;
  }) && chmod(folder.c_str(), 0700) == 0;
}

// Removes a folder, even if its folders may not be written to.
bool removed_by_force(const std::string& folder) {
  std::error_code error;
  chmod(folder.c_str(), 0700);
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code gone;
    const bool is_folder = fs::is_directory(entry->symlink_status(gone));
    if (is_folder) chmod(entry->path().c_str(), 0700);
  }
  fs::remove_all(folder, error);
  return !error && !fs::exists(fs::symlink_status(folder, error));
}

}  // namespace

Runner::Runner(const Subject& subject, Gate* gate)
    : subject_(subject),
      gate_(gate),
      scratch_(new_scratch_folder(subject.limits)),
      supervisor_(scratch_) {}

Runner::~Runner() = default;

std::string Runner::mesh_file() const {
  const std::string path = (subject_.writes_stdout ? scratch_ : work_) + "/" + subject_.mesh_name;
  return is_plain_file(path) ? path : "";
}

std::string Runner::said() const {
  const std::string out = subject_.writes_stdout ? "" : beginning_of(scratch_ + "/" + "stdout");
  return out + beginning_of(scratch_ + "/stderr");
}

// The folder of the last run may resist; then it is left, and the next one has another.
void Runner::empty_work_folder() {
  if (!work_.empty() && (emptied(work_) || removed_by_force(work_))) {
    fs::create_directory(work_);
    return;
  }
  work_ = scratch_ + "/work" + (folders_ == 0 ? "" : std::to_string(folders_));
  ++folders_;
  fs::create_directory(work_);
}

Outcome Runner::run(const Input& input) {
  const std::string reason = reason_to_skip(subject_, input);
  if (!reason.empty()) return {OutcomeKind::kSkipped, "skipped", reason};
  const auto text = file_text(input, formats::extension(subject_.input_name), subject_.first_index,
                              subject_.dimension);
  if (!text) return {OutcomeKind::kSkipped, "skipped", "the format has no way to say this input"};
  empty_work_folder();
  Paths paths{work_, work_ + "/" + subject_.input_name, work_ + "/" + subject_.mesh_name};
  std::ofstream(paths.input, std::ios::binary) << *text;
  Request request;
  request.command = filled_in(subject_, paths);
  request.folder = work_;
  if (subject_.reads_stdin) request.stdin_file = paths.input;
  request.stdout_file = scratch_ + "/" + (subject_.writes_stdout ? subject_.mesh_name : "stdout");
  request.stderr_file = scratch_ + "/stderr";
  if (gate_ != nullptr) gate_->acquire();
  const Ended ended = supervisor_.run(request, subject_.limits);
  if (gate_ != nullptr) gate_->release();
  Outcome outcome = outcome_of(ended, input);
  const bool breaks_rule = outcome.kind == OutcomeKind::kFails;
  if (is_finding(outcome.kind) && !breaks_rule && is_flat(subject_, input)) {
    outcome.signature += "-flat";
  }
  return outcome;
}

Outcome Runner::outcome_of(const Ended& ended, const Input& input) const {
  const auto named = [&](OutcomeKind kind, const std::string& detail, const std::string& text) {
    const std::string what = said();
    return Outcome{kind, word(kind) + detail, text, what};
  };
  switch (ended.ending) {
    case Ending::kInterrupted:
      return named(OutcomeKind::kInterrupted, "", "interrupted");
    case Ending::kNotStarted:
      return named(OutcomeKind::kNotRun, "",
                   subject_.command.front() + ": could not be run: " + std::strerror(ended.code));
    case Ending::kTimeLimit:
      return named(OutcomeKind::kHang, "", "it ran longer than allowed, and was killed");
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
  return judged(subject_, input, mesh, scratch_ + "/own.node");
}

}  // namespace circumspect::campaign
