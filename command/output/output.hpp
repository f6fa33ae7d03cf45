// The output of subcommands: results on stdout, errors on stderr, files complete or not at all, and
// exit codes.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <ostream>
#include <string>

#include "command/output/long_work.hpp"
#include "oracle/report/json.hpp"

namespace circumspect::cli {

// What the command answers to the shell.
enum class ExitCode {
  kHolds = 0,
  kFails = 1,
  kUsage = 2,
  kInputFault = 3,
  kUndecided = 4,
  kInternalError = 5,
};

// Of several answers the worst, in the order 5, 2, 3, 1, 4, 0.
ExitCode worse(ExitCode a, ExitCode b);

}  // namespace circumspect::cli

namespace CLI {
class App;
}

namespace circumspect::cli {

enum class OutputFormat { kText, kJson };
enum class Colour { kAuto, kAlways, kNever };

struct OutputOptions {
  OutputFormat format = OutputFormat::kText;
  bool quiet = false;  // nothing but errors
  Colour colour = Colour::kAuto;
  std::optional<double> limit = {};  // how many seconds the command may take
  std::string junit = {};            // files for CI, of the same results; empty: none
  std::string sarif = {};
};

void add_output_options(CLI::App& command, OutputOptions& options);
// --limit TIME, for commands that call Output::watch.
void add_limit_option(CLI::App& command, OutputOptions& options);
// --junit FILE and --sarif FILE, for commands whose results are those of `check`.
void add_report_options(CLI::App& command, OutputOptions& options);

// Collects what a run says: text as it comes, or one JSON document {"circumspect": 1, "results":
// […]} at the end; and the worst exit code so far.
class Output {
 public:
  explicit Output(const OutputOptions& options) : options_(options) {}

  // From now on long work is shown, and an interrupt or the limit ends the command, with what is
  // known and a last line, "undecided: …", that says what it was at (see long_work.hpp); until the
  // end, or until files are written, which are to be whole or not at all.
  void watch(const std::string& command);
  void end_watch() { long_work_.reset(); }
  // What is being done: "judging part.1.ele". If it is expected to take long, that is said
  // beforehand.
  void begin(const std::string& what, std::optional<double> seconds = {});
  Progress progress() const { return long_work_ ? long_work_->progress() : Progress(); }
  // What is known, in JSON, of what is not done yet: it is part of the last words.
  void know(report::Json so_far);

  bool wants_text() const { return options_.format == OutputFormat::kText && !options_.quiet; }
  bool wants_json() const { return options_.format == OutputFormat::kJson && !options_.quiet; }
  // The same for whatever is made of them: a document or a report.
  bool wants_results() const {
    return wants_json() || !options_.junit.empty() || !options_.sarif.empty();
  }

  // Lines, in colour where that is wanted; what would move a cursor is escaped. Names in them have
  // been put on one line (printable.hpp).
  void text(const std::string& text) const;
  // One line: what was read otherwise than it stands there.
  void note(const std::string& note) const;
  void notes(const std::vector<std::string>& notes) const;
  void json(report::Json result);
  // One line on stderr, and in JSON {subject: name, "error": message}.
  void error(ExitCode code, const std::string& subject, const std::string& name,
             const std::string& message);
  void exit_with(ExitCode code);

  ExitCode exit_code() const { return code_; }

  // Prints the JSON document and writes reports, if these are wanted, and says with what to exit.
  ExitCode finish();

 private:
  int last_words(const std::string& why);
  void print_document() const;
  void write_reports();
  bool wants_colour() const;

  OutputOptions options_;
  std::string command_;
  mutable std::timed_mutex mutex_;  // of what follows, and of standard output
  report::Json results_ = report::Json::array();
  report::Json known_ = report::Json::object();
  ExitCode code_ = ExitCode::kHolds;
  std::unique_ptr<LongWork> long_work_;  // the last: it ends first
};

// Says what is wrong with a command line, in one line on stderr.
ExitCode usage_error(const std::string& message);

// To stderr, at once; where nobody can be told, nobody is.
void say(const std::string& text);

// What to exit with, after all that stands on stdout has been written: kInternalError, with a line
// on stderr, if that was not possible. The last call of every command, whatever it has written and
// how.
ExitCode when_written(ExitCode code);

// Is there something else than a file, or a folder, which must not be replaced by a file?
bool is_device_or_pipe(const std::string& path);

// Writes a file whole or not at all (unfinished_file.hpp); "-" is stdout. Returns an error message,
// or an empty string (about stdout always: when_written says it).
std::string write_file(const std::string& path, const std::function<void(std::ostream&)>& write);

}  // namespace circumspect::cli
