#include "command/campaign/campaign_options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/input/domain_input.hpp"
#include "command/options/one_of.hpp"
#include "command/options/whole_number.hpp"
#include "fuzz/campaign/input.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/model/printable.hpp"

namespace circumspect::cli {
namespace {

using campaign::mentions;
using campaign::Subject;

void add_bytes(CLI::App& command, const std::string& name, std::uint64_t& bytes,
               const std::string& about) {
  command
      .add_option_function<std::string>(
          name,
          [&bytes, name](const std::string& text) {
            const std::string fault = read_bytes(text, bytes);
            if (!fault.empty()) throw CLI::ValidationError(name, fault);
          },
          about)
      ->option_text("SIZE");
}

void add_files(CLI::App& command, SubjectOptions& options) {
  command
      .add_option(
          "--points", options.points_name,
          "The name of the file from which the program reads the points (default: x.node). Its "
          "extension selects the format: .node, .qhull, .off, .json, or .xyz with one line of "
          "coordinates for each point")
      ->option_text("NAME");
  command
      .add_option(
          "--domain", options.domain_name,
          "The name of the file from which the program reads a domain (default: x.poly): "
          ".poly, .geo for Gmsh, or for domains that are surfaces .off, .obj, .ply, .stl or .msh")
      ->option_text("NAME");
  command
      .add_option(
          "--mesh", options.mesh_name,
          "The name of the file to which the program writes the mesh (default: x.ele). {mesh} "
          "stands for this name; if the program chooses the name itself, give that one, such as "
          "x.1.ele for tetgen. Its extension selects the format: " +
              formats::endings_of(&formats::Format::has_mesh))
      ->option_text("NAME");
  command.add_flag("--stdin", options.reads_stdin, "The program reads the input from stdin");
  command.add_flag("--stdout", options.writes_stdout, "The program writes the mesh to stdout");
  command.add_flag(
      "--worker", options.is_worker,
      "The program is a worker: it reads one case after another from stdin, and answers each "
      "on stdout. circumspect adapter LANGUAGE prints one to begin with. For domains, and "
      "with --mesh x.off or x.tet, its answers are such files");
  command
      .add_option("--worker-cases", options.worker_cases,
                  "Start a new worker after N cases (default: 1000)")
      ->check(whole_number(1, 1'000'000'000))
      ->option_text("N");
  using generators::UpdateKind;
  const std::map<std::string, UpdateKind> kinds = {{"insert", UpdateKind::kInsert},
                                                   {"delete", UpdateKind::kDelete},
                                                   {"restore", UpdateKind::kRestore}};
  command
      .add_option(
          "--updates", options.updates,
          "The worker keeps a structure that changes: before it answers, it inserts and deletes "
          "points, and with restore it writes the structure and reads it again. A case then has "
          "a seventh count, the number of updates")
      ->delimiter(',')
      ->transform(one_of(kinds))
      ->option_text("insert,delete,restore");
  command
      .add_option("--first-index", options.first_index, "The index of the first point (default: 0)")
      ->check(whole_number(0, 1))
      ->option_text("0|1");
}

void add_comparisons(CLI::App& command, SubjectOptions& options) {
  using generators::Relation;
  const std::map<std::string, Relation> relations = {{"order", Relation::kOrder},
                                                     {"translation", Relation::kTranslation},
                                                     {"reflection", Relation::kReflection},
                                                     {"scaling", Relation::kScaling},
                                                     {"repetition", Relation::kRepetition}};
  command
      .add_option(
          "--metamorphic", options.relations,
          "Also try each input in a changed form: in another order, moved, reflected or scaled "
          "(all exactly), or with points that come twice. If the program was right, it must be "
          "right again; if it refused the input, it must refuse it again")
      ->delimiter(',')
      ->transform(one_of(relations))
      ->option_text("order,translation,reflection,scaling,repetition");
  using generators::Untidiness;
  const std::map<std::string, Untidiness> kinds = {{"touching", Untidiness::kTouching},
                                                   {"crossing", Untidiness::kCrossing},
                                                   {"overlapping", Untidiness::kOverlapping},
                                                   {"repetition", Untidiness::kRepetition}};
  command
      .add_option(
          "--untidy", options.untidiness,
          "Draw domains whose segments touch, cross, overlap or go through polygons, and whose "
          "vertices come twice. The meshes are judged against the exact arrangement. No polygons "
          "cross")
      ->delimiter(',')
      ->transform(one_of(kinds))
      ->option_text("touching,crossing,overlapping,repetition");
  command
      .add_option(
          "--against", options.against,
          "Another program with its arguments, as one word, which is called in the same way with "
          "the same inputs. Your program fails if it refuses an input that the other gets right, "
          "or makes another mesh where only one is Delaunay")
      ->option_text("COMMAND");
}

void add_claims(CLI::App& command, SubjectOptions& options) {
  add_claim_option(
      command, options.claim,
      "The claim that every mesh must fulfil (default: delaunay; for domains steiner-cdt)");
  add_domain_options(command, options.said);
  command.add_option("--dimension", options.dimension, "The dimension of the points (default: 3)")
      ->check(whole_number(1, 8))
      ->option_text("D");
  command.add_flag("--full-dimension", options.full_dimension,
                   "Skip points that all lie in one hyperplane, and domains with such points");
  command
      .add_option(
          "--refusal-exit-code", options.refusal_codes,
          "The program refuses an input by this exit code, which is not a failure. May be given "
          "several times")
      ->check(whole_number(0, 255))
      ->option_text("N");
  command
      .add_option(
          "--refusal-text", options.refusal_texts,
          "The program refuses an input by this text in its output, which is not a failure. May "
          "be given several times")
      ->option_text("TEXT");
}

bool names_file(const std::string& argument) {
  std::error_code error;
  return std::filesystem::is_regular_file(argument, error);
}

// A path to a file of the user's is found from the folder in which the program runs only if it is whole. A word
// without a slash is no path: the i of `qdelaunay Qt i` stays so where there is a file i. The words of a worker are those of
// `node adapter.mjs`.
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

// What does not go together; empty if all does.
std::string fault_of(const SubjectOptions& options, const Subject& subject) {
  const bool domains = subject.is_about_domains();
  const std::string input = formats::extension(subject.input_name);
  const std::string placeholder = domains ? "{domain}" : "{points}";
  if (mentions(options.command, domains ? "{points}" : "{domain}") ||
      !(domains ? options.points_name : options.domain_name).empty()) {
    return fmt::format("expected {} in the command for the claim {}, found another input",
                       placeholder, name(subject.claim));
  }
  if (!mentions(options.command, placeholder) && !mentions(options.command, "{folder}") &&
      !subject.reads_stdin) {
    return fmt::format("expected {} in the command, or --stdin, found neither", placeholder);
  }
  if (!mentions(options.command, "{mesh}") && options.mesh_name.empty() && !subject.writes_stdout) {
    return "expected {mesh} in the command, --mesh NAME or --stdout, found none of them";
  }
  if (!(domains ? campaign::is_domain_extension(input) : campaign::is_points_extension(input))) {
    return fmt::format("expected a name of the input that ends in {}, found {}",
                       domains ? ".poly, .geo, .off, .obj, .ply, .stl, .msh or .case"
                               : ".node, .qhull, .off, .json, .xyz or .case",
                       subject.input_name);
  }
  const std::string mesh = formats::extension(subject.mesh_name);
  const formats::Format* const format = formats::format_of(mesh);
  if (format == nullptr || !format->has_mesh()) {
    return fmt::format("expected a name of the mesh that ends in one of {}, found {}",
                       formats::endings_of(&formats::Format::has_mesh), subject.mesh_name);
  }
  if (domains && options.dimension != 2 && options.dimension != 3) {
    return "expected --dimension 2 or 3 for domains";
  }
  if (subject.is_untidy && !domains) {
    return "expected --untidy with {domain} or --domain, found another input";
  }
  if (!options.said.holes.empty() || !options.said.regions.empty()) {
    return "expected no --hole and no --region, which are points of one domain, found one: a "
           "campaign has many domains";
  }
  if (!options.is_worker && !subject.updates.empty()) {
    return "expected --worker with --updates, found none: such a program must go on after each "
           "mesh";
  }
  const std::string fault = options.is_worker ? worker_fault_of(options, subject) : "";
  if (!fault.empty()) return fault;
  if (!subject.updates.empty() && !subject.relations.empty()) {
    return "expected --metamorphic or --updates, found both";
  }
  const std::string place = place_fault(subject.input_name);
  return place.empty() ? place_fault(subject.mesh_name) : place;
}

}  // namespace

std::string read_bytes(const std::string& text, std::uint64_t& bytes) {
  const std::map<std::string, int> units = {{"", 0},   {"k", 10}, {"K", 10},
                                            {"M", 20}, {"G", 30}, {"T", 40}};
  std::string unit;
  double number = 0;
  if (!number_and_unit(text, number, unit) || units.count(unit) == 0 || number > 1e6) {
    return fmt::format("expected a size such as 64k, 512M or 2G, found {}", text);
  }
  bytes = static_cast<std::uint64_t>(std::ldexp(number, units.at(unit)));
  return "";
}

void add_duration(CLI::App& command, const std::string& name, std::optional<double>& seconds,
                  const std::string& about) {
  command
      .add_option_function<std::string>(
          name,
          [&seconds, name](const std::string& text) {
            const std::string fault = read_duration(text, seconds.emplace());
            if (!fault.empty()) throw CLI::ValidationError(name, fault);
          },
          about)
      ->option_text("TIME");
}

void add_subject_options(CLI::App& command, SubjectOptions& options) {
  command
      .add_option(
          "command", options.command,
          "The program and its arguments, after --. In them, {points} or {domain} stands for the "
          "input file, {mesh} for the file of the mesh, and {folder} for the folder of both. The "
          "program runs in that folder. A path to a file of yours still works if it has a slash, "
          "such as ./script.py")
      ->required();
  add_files(command, options);
  add_claims(command, options);
  add_comparisons(command, options);
  add_duration(command, "--limit-time", options.seconds,
               "Limit the time of one run (default: 10s)");
  add_bytes(command, "--limit-memory", options.memory,
            "Limit the address space of each process of the program (default: 4G). 0 sets no "
            "limit, which programs built with AddressSanitizer need");
  add_bytes(command, "--limit-output", options.output,
            "Limit the output of the program, in each file and in all together (default: 64M)");
  command
      .add_option("--limit-processes", options.processes,
                  "Limit the number of its processes at a time (default: 256)")
      ->check(whole_number(1, 1'000'000))
      ->option_text("N");
  add_duration(command, "--limit-judging", options.judging_seconds,
               "Limit the time for judging one of its meshes (default: ten times --limit-time)");
  const std::map<std::string, campaign::Containment> ways = {
      {"namespaces", campaign::Containment::kNamespaces},
      {"supervisor", campaign::Containment::kSupervisor}};
  command
      .add_option(
          "--containment", options.containment,
          "Keep the processes of the program together in a process namespace, from which they "
          "see no other process, or by a supervisor that searches for them (default: namespaces "
          "where the system allows them)")
      ->transform(one_of(ways))
      ->option_text("namespaces|supervisor");
  add_duration(command, "--minimize-time", options.minimise_seconds,
               "Stop making an input smaller after this time (default: 120s)");
  command
      .add_option("--minimize-runs", options.minimise_tries,
                  "Stop making an input smaller after N runs (default: 50000)")
      ->check(whole_number())
      ->option_text("N");
}

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
  const std::string& input = subject.is_about_domains() ? options.domain_name : options.points_name;
  subject.input_name = !input.empty()               ? input
                       : options.is_worker          ? "x.case"
                       : subject.is_about_domains() ? "x.poly"
                                                    : "x.node";
  subject.mesh_name = options.mesh_name;
  if (options.mesh_name.empty()) {
    subject.mesh_name = !options.is_worker            ? "x.ele"
                        : !subject.is_about_domains() ? "answer.qhull-i"
                        : options.dimension == 3      ? "answer.tet"
                                                      : "answer.off";
  }
  subject.reads_stdin = options.reads_stdin || options.is_worker;
  subject.writes_stdout = options.writes_stdout || options.is_worker;
  if (options.is_worker) {
    const std::string extension = formats::extension(subject.mesh_name);
    using Form = campaign::Talk::Form;
    const Form form = extension == ".off"   ? Form::kOff
                      : extension == ".tet" ? Form::kTet
                                            : Form::kSimplices;
    subject.talk = {form, options.worker_cases};
  }
  subject.updates.insert(options.updates.begin(), options.updates.end());
  subject.relations.insert(options.relations.begin(), options.relations.end());
  subject.about = options.about;
  subject.promise = options.promise;
  subject.is_untidy = !options.untidiness.empty();
  subject.dimension = options.dimension;
  const bool counts_from_zero = formats::extension(subject.mesh_name) == ".qhull-i";
  subject.first_index = counts_from_zero ? 0 : options.first_index;
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
  const auto found = [&](const std::vector<std::string>& words)
      -> tl::expected<std::vector<std::string>, std::string> {
    const std::string program = campaign::find_program(words.front());
    if (program.empty()) {
      not_found = true;
      return tl::unexpected(
          fmt::format("{}: expected a program that can be run, found none", words.front()));
    }
    std::vector<std::string> command = {program};
    for (std::size_t i = 1; i < words.size(); ++i) {
      command.push_back(with_whole_path(words[i], options.is_worker));
    }
    return command;
  };
  auto command = found(options.command);
  if (!command) return tl::unexpected(command.error());
  subject.command = std::move(*command);
  const std::vector<std::string> against = CLI::detail::split_up(options.against);
  if (!against.empty()) {
    auto other = found(against);
    if (!other) return tl::unexpected(other.error());
    subject.against = std::move(*other);
  }
  return subject;
}

}  // namespace circumspect::cli
