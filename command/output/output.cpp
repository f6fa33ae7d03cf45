#include "command/output/output.hpp"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/one_of.hpp"
#include "command/options/quantity.hpp"
#include "oracle/formats/bytes/unfinished_file.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/ci_reports.hpp"
#include "platform/files.hpp"
#include "platform/terminal.hpp"

namespace circumspect::cli {

namespace {

int severity(ExitCode code) {
  switch (code) {
    case ExitCode::kHolds:
      return 0;
    case ExitCode::kUndecided:
      return 1;
    case ExitCode::kFails:
      return 2;
    case ExitCode::kInputFault:
      return 3;
    case ExitCode::kUsage:
      return 4;
    case ExitCode::kInternalError:
      return 5;
  }
  return 5;
}

}  // namespace

ExitCode worse(ExitCode a, ExitCode b) { return severity(a) < severity(b) ? b : a; }

namespace {

int why_not_written = 0;  // errno of what failed first on stdout

void print(const std::string& text) {
  const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
  if (written != text.size() && why_not_written == 0) why_not_written = errno;
}

// The same lines, with the words in colour at which one looks first: those before a colon that say
// whether it holds, and the names of rules, which have a dot. For terminals.
std::string in_colour(const std::string& lines) {
  static const std::map<std::string_view, std::string_view> colours = {
      {"holds", "\x1b[1;32m"},  {"same", "\x1b[1;32m"},      {"fails", "\x1b[1;31m"},
      {"differ", "\x1b[1;31m"}, {"undecided", "\x1b[1;33m"}, {"note", "\x1b[36m"}};
  std::string coloured;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size() - 1) + 1;
    const std::string_view line = std::string_view(lines).substr(begin, end - begin);
    const std::string_view word = line.substr(0, line.find_first_of(": "));
    const bool has_colon = word.size() < line.size() && line[word.size()] == ':';
    const auto found = colours.find(word);
    const bool is_rule = word.find('.') != word.npos;
    if (has_colon && (is_rule || found != colours.end())) {
      coloured += is_rule ? "\x1b[1m" : found->second;
      coloured += word;
      coloured += "\x1b[0m";
      coloured += line.substr(word.size());
    } else {
      coloured += line;
    }
    begin = end;
  }
  return coloured;
}

}  // namespace

void add_output_options(CLI::App& command, OutputOptions& options) {
  const std::map<std::string, OutputFormat> formats = {{"text", OutputFormat::kText},
                                                       {"json", OutputFormat::kJson}};
  command.add_option("--format", options.format, "Print text (default) or one JSON document")
      ->transform(one_of(formats))
      ->option_text("text|json");
  command.add_flag("-q,--quiet", options.quiet, "Print nothing but errors");
  const std::map<std::string, Colour> colours = {
      {"auto", Colour::kAuto}, {"always", Colour::kAlways}, {"never", Colour::kNever}};
  command
      .add_option("--color", options.colour,
                  "Print text in colour on a terminal, unless NO_COLOR is set ('auto', default), "
                  "'always' or 'never'")
      ->transform(one_of(colours))
      ->option_text("auto|always|never");
}

void add_limit_option(CLI::App& command, OutputOptions& options) {
  add_options(command,
              {{"--limit", "TIME", duration(options.limit),
                "Stop after TIME, such as 90s, 15m or 1h, print what is known by then, and end "
                "with exit code 4 (default: never)"}});
}

void add_report_options(CLI::App& command, OutputOptions& options) {
  add_options(command, {{"--junit", "FILE", into(options.junit), "Also write a report for CI"},
                        {"--sarif", "FILE", into(options.sarif),
                         "Also write a report for code scanning (SARIF)"}});
}

void Output::watch(const std::string& command) {
  command_ = command;
  long_work_ =
      std::make_unique<LongWork>(command, options_.limit, !options_.quiet,
                                 [this](const std::string& why) { return last_words(why); });
}

void Output::begin(const std::string& what, std::optional<double> seconds) {
  constexpr double kLongToWait = 10;
  if (seconds && *seconds >= kLongToWait && !options_.quiet) {
    if (long_work_) long_work_->clear();
    say(fmt::format("circumspect: {} may take about {} (--limit TIME ends it)\n", on_one_line(what),
                    about(*seconds)));
  }
  if (long_work_)
    long_work_->begin(what, seconds && *seconds >= kLongToWait ? seconds : std::nullopt);
}

void Output::know(report::Json so_far) {
  const std::lock_guard lock(mutex_);
  known_ = std::move(so_far);
}

void Output::json(report::Json result) {
  const std::lock_guard lock(mutex_);
  results_.push_back(std::move(result));
  known_ = report::Json::object();
}

void Output::exit_with(ExitCode code) {
  const std::lock_guard lock(mutex_);
  code_ = worse(code_, code);
}

// Who is stuck in printing, to a pipe that nobody reads, holds the lock for ever.
int Output::last_words(const std::string& why) {
  const std::unique_lock lock(mutex_, std::chrono::milliseconds(500));
  const ExitCode code = worse(code_, ExitCode::kUndecided);
  if (!lock.owns_lock()) return static_cast<int>(code);
  if (wants_text()) {
    const std::string line = fmt::format("undecided: {} {}\n", command_, why);
    print(wants_colour() ? in_colour(line) : line);
  }
  known_["undecided"] = command_ + " " + why;
  results_.push_back(known_);
  print_document();
  write_reports();
  return static_cast<int>(when_written(code));
}

// As no-color.org has it.
bool Output::wants_colour() const {
  if (options_.colour != Colour::kAuto) return options_.colour == Colour::kAlways;
  const char* const no_colour = std::getenv("NO_COLOR");
  return (no_colour == nullptr || *no_colour == '\0') &&
         platform::shows_colours(platform::kStandardOutput);
}

void Output::text(const std::string& text) const {
  if (!wants_text()) return;
  std::string lines = on_lines(text);
  if (wants_colour()) lines = in_colour(lines);
  if (long_work_) long_work_->clear();
  const std::lock_guard lock(mutex_);
  print(lines);
  // What is known is there to read at once, while the work goes on.
  if (long_work_) std::fflush(stdout);
}

void Output::note(const std::string& note) const { text("note: " + on_one_line(note) + "\n"); }

void Output::notes(const std::vector<std::string>& notes) const {
  for (const std::string& one : notes) note(one);
}

void Output::error(ExitCode code, const std::string& subject, const std::string& name,
                   const std::string& message) {
  if (long_work_) long_work_->clear();
  usage_error(message);
  if (wants_results()) json({{subject, name}, {"error", message}});
  exit_with(code);
}

ExitCode Output::finish() {
  end_watch();
  print_document();
  write_reports();
  return code_;
}

void Output::write_reports() {
  const auto write = [this](const std::string& path, const std::string& text) {
    if (path.empty()) return;
    const std::string fault = write_file(path, [&](std::ostream& out) { out << text; });
    if (fault.empty()) return;
    usage_error(fault);
    code_ = worse(code_, ExitCode::kUsage);
  };
  if (!options_.junit.empty()) write(options_.junit, report::junit_of_check(results_));
  if (!options_.sarif.empty()) {
    write(options_.sarif,
          report::document_text(report::sarif_of_check(results_, CIRCUMSPECT_VERSION)));
  }
}

void Output::print_document() const {
  if (!wants_json()) return;
  const report::Json document = {{"circumspect", 1}, {"results", results_}};
  print(report::document_text(document));
}

void say(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

ExitCode when_written(ExitCode code) {
  std::cout.flush();
  if (std::fflush(stdout) != 0 || (std::ferror(stdout) != 0 && why_not_written == 0)) {
    why_not_written = why_not_written == 0 ? errno : why_not_written;
  }
  if (why_not_written == 0 && std::cout) return code;
  const std::string reason = why_not_written == 0 ? "" : std::strerror(why_not_written);
  say("circumspect: could not write to standard output" + (reason.empty() ? "" : ": " + reason) +
      "\n");
  return ExitCode::kInternalError;
}

ExitCode usage_error(const std::string& message) {
  say("circumspect: " + on_one_line(message) + "\n");
  return ExitCode::kUsage;
}

bool is_device_or_pipe(const std::string& path) {
  const auto there = platform::status_of(path);
  return there &&
         (there->kind == platform::FileKind::kDevice || there->kind == platform::FileKind::kPipe);
}

std::string write_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (path == "-") {
    write(std::cout);
    std::cout.flush();
    if (!std::cout && why_not_written == 0) why_not_written = errno;
    return "";
  }
  const auto failure = [&path](const std::string& reason) {
    return path + ": expected a place that can be written to, found: " + reason;
  };
  if (is_device_or_pipe(path)) {
    errno = 0;
    std::ofstream stream(platform::path_of(path), std::ios::binary);
    if (stream) write(stream);
    stream.close();
    return stream ? "" : failure(errno == 0 ? "an error" : std::strerror(errno));
  }
  formats::UnfinishedFile file(path);
  if (file.stream()) write(file.stream());
  const int reason = file.finish();
  return reason == 0 ? "" : failure(std::strerror(reason));
}

}  // namespace circumspect::cli
