// The options of campaign and minimize that describe the program under test.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command/options/domain_options.hpp"
#include "fuzz/process/process.hpp"
#include "inputs/minimise.hpp"
#include "inputs/relations.hpp"
#include "inputs/untidy.hpp"
#include "inputs/updates.hpp"

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

// The options outlive the command.
void add_subject_options(CLI::App& command, SubjectOptions& options);

}  // namespace circumspect::cli
