#include "command/campaign/subject.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/usage_faults.hpp"
#include "fuzz/campaign/input.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/model/printable.hpp"

namespace circumspect::cli {
namespace {

using campaign::mentions;
using campaign::Subject;

bool names_file(const std::string& argument) {
  std::error_code error;
  return std::filesystem::is_regular_file(argument, error);
}

// A path to a file of the user's is found from the folder in which the program runs only if it is
// whole. A word without a slash is not a path: the i of `qdelaunay Qt i` stays so where there is a
// file i. The words of a worker are those of `node adapter.mjs`.
std::string with_whole_path(const std::string& argument, bool is_worker) {
  const bool may_be_path = is_worker || argument.find('/') != std::string::npos;
  if (!may_be_path || !names_file(argument)) return argument;
  return std::filesystem::absolute(argument).string();
}

std::string place_fault(const std::string& name) {
  return name.find('/') == std::string::npos && name != "." && name != ".."
             ? ""
             : fmt::format("expected the name of a file without folders, found {}", name);
}

// What does not go together for a worker; empty if all does.
std::string worker_fault_of(const SubjectOptions& options, const Subject& subject) {
  for (const char* const placeholder : {"{points}", "{domain}", "{mesh}", "{folder}"}) {
    if (!mentions(options.command, placeholder)) continue;
    return fmt::format(
        "expected no {0} in the command of a worker, which reads cases from stdin, found {0}",
        placeholder);
  }
  const std::string mesh = formats::extension(subject.mesh_name);
  const std::string listing = subject.dimension == 3 ? ".tet" : ".off";
  if (mesh != listing && (mesh != ".qhull-i" || subject.is_about_domains())) {
    return fmt::format(
        "expected a name of the mesh of a worker in dimension {} that ends in {}{}, found {}",
        subject.dimension, listing, subject.is_about_domains() ? "" : " or .qhull-i",
        subject.mesh_name);
  }
  if (formats::extension(subject.input_name) != ".case") {
    return fmt::format("expected a name of the input of a worker that ends in .case, found {}",
                       subject.input_name);
  }
  if (options.first_index != 0) return "expected --first-index 0 for a worker, found 1";
  if (!subject.updates.empty() && subject.is_about_domains()) {
    return fmt::format("expected no --updates for the claim {}, which is about domains, found some",
                       name(subject.claim));
  }
  return "";
}

bool is_mesh_extension(const std::string& extension) {
  const formats::Format* const format = formats::format_of(extension);
  return format != nullptr && format->has_mesh();
}

// What does not go together; empty if all does.
std::string fault_of(const SubjectOptions& options, const Subject& subject) {
  const bool domains = subject.is_about_domains();
  const std::string input = formats::extension(subject.input_name);
  const std::string placeholder = domains ? "{domain}" : "{points}";
  const bool has_updates = !subject.updates.empty();
  return first_fault({
      {mentions(options.command, domains ? "{points}" : "{domain}") ||
           !(domains ? options.points_name : options.domain_name).empty(),
       fmt::format("expected {} in the command for the claim {}, found another input", placeholder,
                   name(subject.claim))},
      {!mentions(options.command, placeholder) && !mentions(options.command, "{folder}") &&
           !subject.reads_stdin,
       fmt::format("expected {} in the command, or --stdin, found neither", placeholder)},
      {!mentions(options.command, "{mesh}") && options.mesh_name.empty() && !subject.writes_stdout,
       "expected {mesh} in the command, --mesh NAME or --stdout, found none of them"},
      {!(domains ? campaign::is_domain_extension(input) : campaign::is_points_extension(input)),
       fmt::format("expected a name of the input that ends in {}, found {}",
                   domains ? ".poly, .geo, .off, .obj, .ply, .stl, .msh or .case"
                           : ".node, .qhull, .off, .json, .xyz or .case",
                   subject.input_name)},
      {subject.claim != Claim::kVoronoi &&
           !is_mesh_extension(formats::extension(subject.mesh_name)),
       fmt::format("expected a name of the mesh that ends in one of {}, found {}",
                   formats::endings_of(&formats::Format::has_mesh), subject.mesh_name)},
      {domains && options.dimension != 2 && options.dimension != 3,
       "expected --dimension 2 or 3 for domains"},
      {subject.is_untidy && !domains,
       "expected --untidy with {domain} or --domain, found another input"},
      {!options.said.holes.empty() || !options.said.regions.empty(),
       "expected no --hole and no --region, which are points of one domain, found one: a campaign "
       "has many domains"},
      {!options.is_worker && has_updates,
       "expected --worker with --updates, found none: such a program must go on after each mesh"},
      {subject.claim == Claim::kPeriodicDelaunay,
       fmt::format("expected a claim about meshes, which programs make in campaigns, found {}",
                   name(subject.claim))},
      dependence({options.within.has_value(), "--within"},
                 {subject.claim == Claim::kVoronoi, "--claim voronoi"},
                 "meshes are judged as they are"),
      {subject.claim == Claim::kVoronoi && (options.is_worker || !options.against.empty()),
       "expected neither --worker nor --against beside --claim voronoi, found one: a program "
       "writes "
       "each diagram as qvoronoi o Fv does"},
      {subject.claim == Claim::kVoronoi && options.dimension != 2 && options.dimension != 3,
       "expected --dimension 2 or 3 for Voronoi diagrams"},
      options.is_worker ? worker_fault_of(options, subject) : "",
      {has_updates && !subject.relations.empty(),
       "expected --metamorphic or --updates, found both"},
      place_fault(subject.input_name),
      place_fault(subject.mesh_name),
  });
}

// The names of the files, those that are not given included, and how the program is called.
void settle_files(const SubjectOptions& options, Subject& subject) {
  const bool domains = subject.is_about_domains();
  const std::string& input = domains ? options.domain_name : options.points_name;
  subject.input_name = !input.empty()      ? input
                       : options.is_worker ? "x.case"
                       : domains           ? "x.poly"
                                           : "x.node";
  subject.mesh_name = options.mesh_name;
  if (options.mesh_name.empty()) {
    subject.mesh_name = subject.claim == Claim::kVoronoi ? "x.qvoronoi"
                        : !options.is_worker             ? "x.ele"
                        : !domains                       ? "answer.qhull-i"
                        : options.dimension == 3         ? "answer.tet"
                                                         : "answer.off";
  }
  const std::string mesh = formats::extension(subject.mesh_name);
  subject.first_index = mesh == ".qhull-i" ? 0 : options.first_index;
  subject.reads_stdin = options.reads_stdin || options.is_worker;
  subject.writes_stdout = options.writes_stdout || options.is_worker;
  if (!options.is_worker) return;
  using Form = campaign::Talk::Form;
  const Form form = mesh == ".off" ? Form::kOff : mesh == ".tet" ? Form::kTet : Form::kSimplices;
  subject.talk = {form, options.worker_cases};
}

// The words of a command, the first a program that can be run; nothing if there is no such program.
std::optional<std::vector<std::string>> runnable(const std::vector<std::string>& words,
                                                 bool is_worker) {
  std::vector<std::string> command = {campaign::find_program(words.front())};
  if (command.front().empty()) return std::nullopt;
  for (std::size_t i = 1; i < words.size(); ++i) {
    command.push_back(with_whole_path(words[i], is_worker));
  }
  return command;
}

}  // namespace

std::string note_on_names(const SubjectOptions& options) {
  for (std::size_t i = 1; i < options.command.size() && !options.is_worker; ++i) {
    const std::string& argument = options.command[i];
    if (argument.find('/') != std::string::npos || !names_file(argument)) continue;
    return fmt::format("note: the argument {0} is given as it is; the file is ./{0}\n",
                       on_one_line(argument));
  }
  return "";
}

tl::expected<Subject, std::string> subject_of(const SubjectOptions& options, bool& not_found) {
  Subject subject;
  const bool domain = mentions(options.command, "{domain}") || !options.domain_name.empty();
  subject.claim = options.claim.value_or(domain ? Claim::kSteinerCdt : Claim::kDelaunay);
  settle_files(options, subject);
  subject.updates.insert(options.updates.begin(), options.updates.end());
  subject.relations.insert(options.relations.begin(), options.relations.end());
  subject.about = options.about;
  subject.promise = options.promise;
  subject.is_untidy = !options.untidiness.empty();
  if (options.within) {
    subject.within = options.within->number;
    subject.is_within_relative = options.within->relative;
  }
  subject.dimension = options.dimension;
  subject.fill = options.said.fill.value_or(Fill::kEnclosed);
  subject.merges_coplanar = options.said.merged_slope.has_value();
  subject.full_dimension = options.full_dimension;
  subject.refusal_codes.insert(options.refusal_codes.begin(), options.refusal_codes.end());
  subject.refusal_texts = options.refusal_texts;
  subject.limits = {options.seconds.value_or(10), options.memory, options.output,
                    options.processes};
  subject.containment = options.containment;
  constexpr double kJudging = 10;  // times a run
  subject.judging_seconds = options.judging_seconds.value_or(kJudging * subject.limits.seconds);
  const std::string fault = fault_of(options, subject);
  if (!fault.empty()) return tl::unexpected(fault);
  const std::vector<std::string> against = CLI::detail::split_up(options.against);
  for (const auto& [words, command] :
       {std::pair(&options.command, &subject.command), std::pair(&against, &subject.against)}) {
    if (words->empty()) continue;
    auto found = runnable(*words, options.is_worker);
    if (!found) {
      not_found = true;
      return tl::unexpected(
          fmt::format("{}: expected a program that can be run, found none", words->front()));
    }
    *command = std::move(*found);
  }
  return subject;
}

}  // namespace circumspect::cli
