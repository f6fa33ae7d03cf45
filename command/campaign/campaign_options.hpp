// The options of campaign and minimize that describe the program under test.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "command/options/domain_options.hpp"
#include "fuzz/campaign/outcome.hpp"
#include "inputs/minimise.hpp"
#include "inputs/untidy.hpp"

namespace CLI {
class App;
}

namespace circumspect::cli {

struct SubjectOptions {
  std::vector<std::string> command;
  std::string points_name;
  std::string domain_name;
  std::string mesh_name;
  bool reads_stdin = false;
  bool writes_stdout = false;
  bool is_worker = false;
  std::size_t worker_cases = 1000;
  std::vector<generators::UpdateKind> updates;
  std::vector<generators::Relation> relations;
  std::string against;
  std::string about;
  std::string promise;
  std::vector<generators::Untidiness> untidiness;
  std::optional<Claim> claim;
  DomainOptions said;  // of every domain
  std::size_t dimension = 3;
  Vertex first_index = 0;
  bool full_dimension = false;
  std::vector<int> refusal_codes;
  std::vector<std::string> refusal_texts;
  std::optional<double> seconds;
  std::uint64_t memory = campaign::Limits{}.memory;
  std::uint64_t output = campaign::Limits{}.output;
  std::size_t processes = campaign::Limits{}.processes;
  std::optional<double> judging_seconds;
  std::optional<campaign::Containment> containment;
  std::optional<double> minimise_seconds;
  std::size_t minimise_tries = generators::MinimiseLimits{}.tries;

  generators::MinimiseLimits minimise() const {
    return {minimise_tries, std::chrono::duration<double>(minimise_seconds.value_or(120))};
  }
};

void add_subject_options(CLI::App& command, SubjectOptions& options);

// Text such as "2G", "512M", "64k" or "0" as bytes: for options. Returns what is wrong with it, or an empty string.
std::string read_bytes(const std::string& text, std::uint64_t& bytes);

// An option whose value is such a text.
void add_duration(CLI::App& command, const std::string& name, std::optional<double>& seconds,
                  const std::string& about);

// A note, for people, on an argument of the command that is also the name of a file; empty if there is none.
std::string note_on_names(const SubjectOptions& options);

// The program as it is to be run. Errors: what is wrong with the options, for people; `not_found` is
// set if it is that there is no such program.
tl::expected<campaign::Subject, std::string> subject_of(const SubjectOptions& options,
                                                        bool& not_found);

}  // namespace circumspect::cli
