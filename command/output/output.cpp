#include "command/output/output.hpp"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/campaign/campaign_options.hpp"
#include "command/options/one_of.hpp"
#include "command/output/unfinished_file.hpp"
#include "oracle/model/printable.hpp"

namespace circumspect::cli {

void add_output_options(CLI::App& command, OutputOptions& options) {
  const std::map<std::string, OutputFormat> formats = {{"text", OutputFormat::kText},
                                                       {"json", OutputFormat::kJson}};
  command.add_option("--format", options.format, "Print text (default) or one JSON document")
      ->transform(one_of(formats))
      ->option_text("text|json");
  command.add_flag("--quiet", options.quiet, "Print nothing but errors");
}

void add_limit_option(CLI::App& command, OutputOptions& options) {
  command
      .add_option_function<std::string>(
          "--limit",
          [&options](const std::string& text) {
            double seconds = 0;
            const std::string fault = read_duration(text, seconds);
            if (!fault.empty()) throw CLI::ValidationError(fault);
            options.limit = seconds;
          },
          "End after so long, with what is known by then and exit code 4: 90s, 15m, 1h (default: "
          "never)")
      ->option_text("TIME");
}

void Output::watch(const std::string& command) {
  command_ = command;
  long_work_ =
      std::make_unique<LongWork>(command, options_.limit, !options_.quiet,
                                 [this](const std::string& why) { return last_words(why); });
}

void Output::begin(const std::string& what, std::optional<double> seconds) {
  constexpr double kLong = 10;
  if (seconds && *seconds >= kLong && !options_.quiet) {
    if (long_work_) long_work_->clear();
    fmt::print(stderr, "circumspect: {} may take about {} (--limit TIME ends it)\n",
               on_one_line(what), about(*seconds));
  }
  if (long_work_) long_work_->begin(what, seconds && *seconds >= kLong ? seconds : std::nullopt);
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
  if (wants_text()) fmt::print("undecided: {} {}\n", command_, why);
  known_["undecided"] = command_ + " " + why;
  results_.push_back(known_);
  return static_cast<int>(worse(code, print_document()));
}

void Output::text(const std::string& text) const {
  if (!wants_text()) return;
  const std::string lines = on_lines(text);
  if (long_work_) long_work_->clear();
  const std::lock_guard lock(mutex_);
  fmt::print("{}", lines);
  // What is known is there to read at once, while the work goes on.
  if (long_work_) std::fflush(stdout);
}

void Output::note(const std::string& note) const { text("note: " + on_one_line(note) + "\n"); }

void Output::error(ExitCode code, const std::string& subject, const std::string& name,
                   const std::string& message) {
  if (long_work_) long_work_->clear();
  usage_error(message);
  if (wants_json()) json({{subject, name}, {"error", message}});
  exit_with(code);
}

ExitCode Output::finish() {
  end_watch();
  return worse(code_, print_document());
}

ExitCode Output::print_document() const {
  if (wants_json()) {
    const report::Json document = {{"circumspect", 1}, {"results", results_}};
    fmt::print("{}", report::document_text(document));
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    fmt::print(stderr, "circumspect: could not write to standard output\n");
    return ExitCode::kInternalError;
  }
  return ExitCode::kHolds;
}

ExitCode usage_error(const std::string& message) {
  fmt::print(stderr, "circumspect: {}\n", on_one_line(message));
  return ExitCode::kUsage;
}

std::string write_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (path == "-") {
    write(std::cout);
    std::cout.flush();
    return std::cout ? "" : "could not write to standard output";
  }
  const std::string failure = fmt::format("{}: expected a place that can be written to", path);
  std::error_code error;
  const std::filesystem::file_status there = std::filesystem::status(path, error);
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there) &&
      !std::filesystem::is_directory(there)) {
    // A device or a pipe must not be replaced by a file.
    std::ofstream stream(path, std::ios::binary);
    if (stream) write(stream);
    stream.close();
    return stream ? "" : failure;
  }
  UnfinishedFile file(path);
  if (file.stream()) write(file.stream());
  return file.finish() ? "" : failure;
}

}  // namespace circumspect::cli
