#include "command/output/output.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

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

void Output::text(const std::string& text) const {
  if (wants_text()) fmt::print("{}", on_lines(text));
}

void Output::note(const std::string& note) const { text("note: " + on_one_line(note) + "\n"); }

void Output::error(ExitCode code, const std::string& subject, const std::string& name,
                   const std::string& message) {
  usage_error(message);
  if (wants_json()) json({{subject, name}, {"error", message}});
  exit_with(code);
}

ExitCode Output::finish() const {
  if (wants_json()) {
    const report::Json document = {{"circumspect", 1}, {"results", results_}};
    fmt::print("{}", report::document_text(document));
  }
  if (std::fflush(stdout) != 0) {
    fmt::print(stderr, "circumspect: could not write to standard output\n");
    return ExitCode::kInternalError;
  }
  return code_;
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
