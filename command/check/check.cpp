// circumspect check MESH…
#include "oracle/judge/points/check.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/check/certificate_output.hpp"
#include "command/check/complex_options.hpp"
#include "command/check/domain_readings.hpp"
#include "command/check/judge_in_parts.hpp"
#include "command/check/judge_loaded.hpp"
#include "command/check/remedy.hpp"
#include "command/check/within_option.hpp"
#include "command/input/domain_input.hpp"
#include "command/input/input.hpp"
#include "command/options/domain_options.hpp"
#include "command/options/one_of.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/expected_time.hpp"
#include "command/output/output.hpp"
#include "command/output/overwriting.hpp"
#include "command/output/picture_output.hpp"
#include "command/subcommands.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

struct CheckOptions {
  std::vector<std::string> meshes;
  std::optional<Claim> claim;
  std::optional<std::string> domain;
  DomainOptions said;  // of the domain
  std::optional<Distance> within;
  std::optional<std::string> certificate;
  PictureOptions picture;
  std::shared_ptr<Pictures> pictures;
  check::Options check;
  ComplexOptions complex;
  InputOptions input;
  OutputOptions output;
  std::uint64_t threads = 0;  // 0: as many as the machine has
  std::optional<std::uint64_t> memory;
};

// What is said of how a mesh was read, at once, and what its verdict may be due to, beside the verdict: before the
// witnesses, of which there may be many, nobody would see that.
struct Notes {
  std::vector<std::string> of_reading;
  std::vector<std::string> of_verdict;

  std::vector<std::string> all() const {
    std::vector<std::string> notes = of_reading;
    notes.insert(notes.end(), of_verdict.begin(), of_verdict.end());
    return notes;
  }
};

// Says what a mesh was found to be.
void report_verdict(const std::string& path, const Verdict& verdict, const Mesh& mesh,
                    const Notes& notes, const CheckOptions& options, const HeldAgainst* against,
                    Output& output) {
  output.exit_with(verdict.holds() ? ExitCode::kHolds : ExitCode::kFails);
  const LoadedDomain* const domain = against == nullptr ? nullptr : &against->loaded;
  const Domain* about = against == nullptr ? nullptr : &against->judged();
  if (output.wants_text()) {
    if (domain != nullptr) {
      output.text(fmt::format("domain: {} {}\n", on_one_line(domain->name), domain->filled));
    }
    output.text(report::explanation(verdict, mesh, about));
    output.notes(notes.of_verdict);
    output.text(report::verdict_line(verdict, mesh, path, about) + "\n");
  }
  if (!output.wants_json() && !options.pictures->are_wanted()) return;
  std::vector<std::string> all_notes;
  if (domain != nullptr) all_notes = domain->file.notes;
  const std::vector<std::string> of_mesh = notes.all();
  all_notes.insert(all_notes.end(), of_mesh.begin(), of_mesh.end());
  report::Json result = report::verdict(verdict, mesh, path, options.check.by, about);
  if (domain != nullptr) {
    result["domain"] = domain->name;
    result["domain_kind"] = word(domain->domain.complex.kind);
    const bool has_more_than_a_kind = options.said.fill == Fill::kEvenOdd ||
                                      options.said.fill == Fill::kWinding ||
                                      !options.said.regions.empty();
    if (has_more_than_a_kind) result["domain_fills"] = domain->filled;
    result["notes"] = all_notes;
  }
  if (options.certificate) result["certificate"] = *options.certificate;
  if (options.pictures->are_wanted()) {
    options.pictures->add(verdict, mesh, path, result, about, all_notes, output);
  }
  if (output.wants_json()) output.json(std::move(result));
}

void check_alone(const std::string& path, const CheckOptions& options, Output& output) {
  output.begin("reading " + path);
  auto loaded = load_mesh(path, options.input, options.check.threads);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "mesh", path, loaded.error());
    return;
  }
  if (options.claim == Claim::kComplex) {
    const std::string fault = check::fault_of_demands(loaded->mesh, options.check.complex);
    if (!fault.empty()) {
      output.error(ExitCode::kInputFault, "mesh", path, path + ": " + fault);
      return;
    }
  }
  output.begin("judging " + path, seconds_of_judging(loaded->mesh, options.check));
  const auto verdict = judge_loaded(options.claim.value_or(Claim::kDelaunay), *loaded,
                                    options.input.duplicates, options.check);
  output.notes(loaded->notes);
  if (!verdict) {
    output.error(ExitCode::kInputFault, "mesh", path, verdict.error());
    return;
  }
  Notes notes{loaded->notes, notes_without_domain(*verdict, loaded->mesh, path)};
  if (const auto note = note_of_complex(*verdict, loaded->mesh, path)) {
    notes.of_verdict.push_back(*note);
  }
  report_verdict(path, *verdict, loaded->mesh, notes, options, nullptr, output);
  if (options.certificate) {
    output.end_watch();
    write_certificate(*options.certificate, path, exact(loaded->mesh), *verdict, output);
  }
}

void check_part_after_part(const std::string& path, const CheckOptions& options, Output& output) {
  output.begin("judging " + path);
  const auto judged = judge_in_parts(options.claim.value_or(Claim::kDelaunay), path,
                                     options.input.points, *options.memory, options.check);
  if (!judged) {
    output.error(judged.error().code, "mesh", path, judged.error().message);
    return;
  }
  const Notes notes{{}, notes_without_domain(judged->verdict, judged->named, path)};
  report_verdict(path, judged->verdict, judged->named, notes, options, nullptr, output);
}

void check_with_domain(const std::string& path, const CheckOptions& options,
                       DomainReadings& readings, Output& output) {
  output.begin("reading " + path);
  auto loaded = load_mesh(path, options.input, options.check.threads, readings.frame());
  const HeldAgainst* const fitting = readings.for_mesh(loaded ? &*loaded : nullptr, output);
  if (fitting == nullptr) return;
  const HeldAgainst& against = *fitting;
  const LoadedDomain& domain = against.loaded;
  const std::size_t dimension = domain.domain.complex.ambient_dimension();
  // The claim may depend on which points there are.
  const std::string fault =
      loaded ? settle_equal_points(*loaded, options.input.duplicates) : loaded.error();
  if (loaded) output.notes(loaded->notes);
  if (!fault.empty()) {
    output.error(ExitCode::kInputFault, "mesh", path, fault);
    return;
  }
  const Mesh& mesh = loaded->mesh;
  if (mesh.points() > 0 && mesh.dimension() != dimension) {
    output.error(
        ExitCode::kInputFault, "mesh", path,
        fmt::format("{}: expected points of dimension {}, as those of {}, found dimension {}", path,
                    dimension, domain.name, mesh.dimension()));
    return;
  }
  output.begin("judging " + path, seconds_of_judging(mesh, options.check));
  const Claim claim =
      options.claim.value_or(default_claim(mesh, domain.domain, options.within.has_value()));
  std::optional<Verdict> verdict;
  if (options.within) {
    const std::string equal = settle_equal_points(*loaded, options.input.duplicates);
    if (!equal.empty()) {
      output.error(ExitCode::kInputFault, "mesh", path, equal);
      return;
    }
    const KnownMesh known(claim, mesh, domain.domain.complex.kind, options.check);
    auto judged = judged_within(*options.within, claim, known, domain.domain, options.check,
                                against.bent ? &*against.bent : nullptr,
                                {loaded->face_markers, against.polygon_markers()});
    if (!judged) {
      const auto& [reason, is_input_fault] = judged.error();
      output.error(is_input_fault ? ExitCode::kInputFault : ExitCode::kUndecided, "mesh", path,
                   path + ": " + reason);
      return;
    }
    verdict = std::move(*judged);
  } else {
    auto judged =
        judge_loaded(claim, *loaded, options.input.duplicates, options.check, &domain.domain);
    if (!judged) {
      output.error(ExitCode::kInputFault, "mesh", path, judged.error());
      return;
    }
    verdict = std::move(*judged);
  }
  Notes notes{loaded->notes, {}};
  std::optional<std::string> weaker;
  if (!options.claim) weaker = note_of_weaker_claim(*verdict);
  std::optional<std::string> lone;  // polygons of a bent domain are others
  if (!against.bent) lone = note_of_lone_polygons(*verdict, domain);
  const bool has_merged = options.said.merged_slope.has_value();
  const Judged judged{claim, mesh, domain, options.within, has_merged, loaded->face_markers};
  for (const auto& note : {remedy(*verdict, judged, options.check), lone, weaker}) {
    if (note) notes.of_verdict.push_back(*note);
  }
  report_verdict(path, *verdict, mesh, notes, options, &against, output);
  if (options.certificate) {
    output.end_watch();
    write_domain_certificate(*options.certificate, path, exact(mesh), domain, *verdict, output);
  }
}

void check_against_domain(const CheckOptions& options, Output& output) {
  DomainReadings readings(
      {*options.domain, options.input, options.said, options.within, options.check.max_violations});
  if (!readings.load(output)) return;
  for (const std::string& mesh : options.meshes) {
    check_with_domain(mesh, options, readings, output);
  }
}

// What a claim needs and did not get, or got and does not need; empty if all is well.
std::string usage_fault(CheckOptions& options) {
  std::string of_complex = settle_complex_options(options.complex, options.claim, options.check);
  if (!of_complex.empty()) return of_complex;
  if (options.claim == Claim::kComplex) {
    for (const auto& [is_given, word] : std::initializer_list<std::pair<bool, const char*>>{
             {options.certificate.has_value(), "--certificate"},
             {options.input.neighbors, "--neighbors"},
             {options.memory.has_value(), "--memory"}}) {
      if (is_given) return fmt::format("expected no {} beside the claim complex, found it", word);
    }
  }
  const bool about_domain = options.claim && is_about_a_domain(*options.claim);
  if (options.certificate && options.within) {
    return "expected no --within beside --certificate, found it: nothing is proved of it";
  }
  if (options.certificate) {
    if (std::string fault = certificate_fault(options.said); !fault.empty()) return fault;
  }
  if (about_domain && !options.domain) {
    return fmt::format("expected --domain FILE for the claim {}, found none", name(*options.claim));
  }
  if (options.claim && !about_domain && options.domain) {
    return fmt::format("expected no --domain for the claim {}, found one", name(*options.claim));
  }
  if (options.within && !options.domain) {
    return "expected --domain FILE beside --within, found none";
  }
  if (options.said.is_given() && !options.domain) {
    return "expected --domain FILE beside --fill, --hole, --region or --merge-coplanar, found none";
  }
  if (options.said.merges_bent() && !options.within) {
    return "expected --within DISTANCE beside --merge-coplanar with an angle, found none: say how "
           "far vertices may be from one plane";
  }
  if (std::string fault = domain_options_fault(options.said); !fault.empty()) return fault;
  if (options.input.neighbors && !options.input.kept_labels.empty()) {
    return "expected no --neighbors beside --keep-label, found it: a .neigh file is about all "
           "cells";
  }
  if (options.certificate && !options.input.kept_labels.empty()) {
    return "expected no --certificate beside --keep-label, found one: a certificate is about all "
           "cells of a file";
  }
  if (options.certificate && options.meshes.size() != 1) {
    return fmt::format("expected one mesh beside --certificate, found {}", options.meshes.size());
  }
  if (options.certificate == "-") {
    return "expected a file for --certificate, found -; circumspect certify writes to standard "
           "output";
  }
  if (options.memory) {
    for (const auto& [is_given, word] : std::initializer_list<std::pair<bool, const char*>>{
             {options.domain.has_value(), "--domain"},
             {options.check.by == check::By::kDefinition, "--by definition"},
             {options.check.oriented, "--oriented"},
             {options.input.neighbors, "--neighbors"},
             {!options.input.kept_labels.empty(), "--keep-label"},
             {options.input.allow_empty, "--allow-empty"},
             {options.input.duplicates == Duplicates::kMerge, "--duplicates merge"},
             {options.input.coordinates != NumberReading::kDouble, "--coordinates decimal"},
             {options.certificate.has_value(), "--certificate"},
             {!picture_files(options.picture).empty(), "pictures"}}) {
      if (!is_given) continue;
      return fmt::format(
          "expected no {} beside --memory, found it: this needs the whole mesh in memory", word);
    }
  }
  const std::string fault = picture_fault(options.picture, options.meshes.size());
  if (!fault.empty()) return fault;
  std::vector<Written> written = picture_files(options.picture);
  if (options.certificate) written.push_back({"the certificate", *options.certificate});
  if (written.empty()) return "";
  std::vector<std::string> read;
  for (const std::string& mesh : options.meshes) {
    const std::vector<std::string> files = files_of_mesh(mesh);
    read.insert(read.end(), files.begin(), files.end());
  }
  if (options.domain) {
    const std::vector<std::string> files = files_of_domain(*options.domain);
    read.insert(read.end(), files.begin(), files.end());
  }
  if (options.input.points) read.push_back(*options.input.points);
  return overwriting_fault(written, read);
}

ExitCode run(CheckOptions& options) {
  if (const std::string fault = usage_fault(options); !fault.empty()) {
    return usage_error(fault);
  }
  Output output(options.output);
  output.watch("check");
  options.input.weighted = options.claim == Claim::kWeightedDelaunay;
  options.input.faces = options.domain.has_value();
  options.input.for_certificate = options.certificate.has_value();
  options.check.threads = thread_count(options.threads);
  options.pictures = std::make_shared<Pictures>(options.picture);
  if (options.domain) {
    check_against_domain(options, output);
  } else {
    for (const std::string& mesh : options.meshes) {
      options.memory ? check_part_after_part(mesh, options, output)
                     : check_alone(mesh, options, output);
    }
  }
  options.pictures->finish(output);
  return output.finish();
}

}  // namespace

void add_check(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Judge meshes that any program made");
  command->footer(
      "Example:\n"
      "  tetgen points.node                      # TetGen writes points.1.node, "
      "points.1.ele\n"
      "  circumspect check points.1.ele          # exit 0: it is Delaunay; 1: it is not, and "
      "a witness shows it\n"
      "  tetgen -pq part.poly                    # part.1.node, part.1.ele, part.1.face\n"
      "  circumspect check part.1.ele --domain part.poly\n"
      "\n"
      "Exit codes: 0 the claim holds, 1 it does not, 2 usage, 3 the input is at fault (also "
      "if it\n"
      "has neither points nor simplices), 4 interrupted or stopped by --limit, 5 internal "
      "error.");
  command
      ->add_option("mesh", options->meshes,
                   fmt::format("Meshes: {}; - for standard input, in any of these formats",
                               formats::endings_in_help(&formats::Format::has_mesh)))
      ->required();
  add_claim_option(*command, options->claim,
                   "The claim to judge (default: delaunay; with a domain cdt, or steiner-cdt if "
                   "the mesh has more vertices than the domain). Weights are the first attribute "
                   "of a .node file, as for tetgen -w, or the key weights of JSON");
  command
      ->add_option(
          "--domain", options->domain,
          fmt::format("The domain that the mesh must fill: {}. The dangling triangles and edges of "
                      "the mesh are read from the .face and the .edge file beside the .ele",
                      formats::endings_in_help(&formats::Format::has_domain)))
      ->option_text("FILE");
  add_domain_options(*command, options->said, true);
  add_within_option(*command, options->within);
  command->add_option("--points", options->input.points, "The file with the points of the mesh")
      ->option_text("FILE");
  const std::map<std::string, check::By> ways = {{"lemma", check::By::kLemma},
                                                 {"definition", check::By::kDefinition}};
  command
      ->add_option("--by", options->check.by,
                   "Judge by the lemmas (default) or, slowly, by the definitions")
      ->transform(one_of(ways))
      ->option_text("lemma|definition");
  command
      ->add_option("--certificate", options->certificate,
                   "Also write a certificate or a refutation, as circumspect certify does")
      ->option_text("FILE");
  add_picture_options(*command, options->picture);
  add_complex_options(*command, options->complex);
  command->add_flag("--neighbors", options->input.neighbors,
                    "Also judge the .neigh file beside each .ele");
  command
      ->add_option("--max-errors", options->check.max_violations,
                   "Report at most N witnesses (default: 20; 0: all)")
      ->check(whole_number())
      ->option_text("N");
  add_threads_option(*command, options->threads);
  add_memory_option(*command, options->memory);
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_keep_label_option(*command, options->input);
  add_allow_empty_option(*command, options->input);
  add_limit_option(*command, options->output);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
