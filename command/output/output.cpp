#include "command/output/output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <unistd.h>

#include "command/options/one_of.hpp"
#include "oracle/formats/unfinished_file.hpp"
#include "oracle/model/printable.hpp"

namespace circumspect::cli {
namespace {

int why_not_written = 0;  // errno of what failed first on stdout

void print(const std::string& text) {
  const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
  if (written != text.size() && why_not_written == 0) why_not_written = errno;
}

}  // namespace

void add_output_options(CLI::App& command, OutputOptions& options) {
  const std::map<std::string, OutputFormat> formats = {{"text", OutputFormat::kText},
                                                       {"json", OutputFormat::kJson}};
  command.add_option("--format", options.format, "Print text (default) or one JSON document")
      ->transform(one_of(formats))
      ->option_text("text|json");
  command.add_flag("--quiet", options.quiet, "Print nothing but errors");
}

void Output::text(const std::string& text) const {
  if (wants_text()) print(on_lines(text));
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
    print(report::document_text(document));
  }
  return code_;
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

void keep_standard_files_apart() {
  for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(file, F_GETFD) >= 0 || errno != EBADF) continue;
    // The wrong way round, so that who reads or writes it still hears that it cannot be.
    const int opened = open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    if (opened >= 0 && opened != file) close(opened);
  }
}

ExitCode usage_error(const std::string& message) {
  say("circumspect: " + on_one_line(message) + "\n");
  return ExitCode::kUsage;
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
  std::error_code error;
  const std::filesystem::file_status there = std::filesystem::status(path, error);
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there) &&
      !std::filesystem::is_directory(there)) {
    // A device or a pipe must not be replaced by a file.
    errno = 0;
    std::ofstream stream(path, std::ios::binary);
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
