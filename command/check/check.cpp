// circumspect check MESH…
#include <memory>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/check/certificate_output.hpp"
#include "command/check/check_options.hpp"
#include "command/check/check_voronoi.hpp"
#include "command/check/domain_readings.hpp"
#include "command/check/judge_in_parts.hpp"
#include "command/check/judge_loaded.hpp"
#include "command/check/remedy.hpp"
#include "command/input/domain_input.hpp"
#include "command/input/input.hpp"
#include "command/options/threads.hpp"
#include "command/output/expected_time.hpp"
#include "command/output/output.hpp"
#include "command/subcommands.hpp"
#include "oracle/judge/cause/causes.hpp"
#include "oracle/judge/default_claim.hpp"
#include "oracle/judge/quality/judge_quality.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

// What is said of how a mesh was read, at once, and what its verdict may be due to, beside the
// verdict: before the witnesses, which may be many, nobody would see that.
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
  if (!output.wants_results() && !options.pictures->are_wanted()) return;
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
  if (output.wants_results()) output.json(std::move(result));
}

// Are the requirements about measures that the mesh does not have? Then it says so.
bool misses_measures(const std::string& path, const Mesh& mesh, const CheckOptions& options,
                     const Domain* domain, Output& output) {
  const std::string fault =
      check::fault_of_quality(mesh, options.check.quality, domain, options.within.has_value());
  if (!fault.empty()) output.error(ExitCode::kUsage, "mesh", path, path + ": " + fault);
  return !fault.empty();
}

// What is said of a mended mesh in place of the one that was judged.
std::optional<Verdict> judged_again(Claim claim, const Mesh& mesh, const Domain* domain,
                                    check::Options options) {
  options.max_violations = 1;
  auto verdict = check::judge(claim, mesh, domain, options);
  if (!verdict) return std::nullopt;
  return std::move(*verdict);
}

std::optional<Verdict> judged_again(Claim claim, const Mesh& mesh, const HeldAgainst& against,
                                    const CheckOptions& options) {
  const Domain& domain = against.loaded.domain;
  if (!options.within) return judged_again(claim, mesh, &domain, options.check);
  const check::KnownMesh known(claim, mesh, domain.complex.kind, options.check);
  auto verdict = judged_within(*options.within, claim, known, domain, options.check,
                               against.bent ? &*against.bent : nullptr);
  if (!verdict) return std::nullopt;
  check::judge_quality(mesh, &against.judged(), options.within->squared(domain.complex),
                       options.check, *verdict);
  return std::move(*verdict);
}

void check_alone(const std::string& path, const CheckOptions& options, Output& output) {
  output.begin("reading " + path);
  auto loaded = load_mesh(path, options.input, options.check.threads);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "mesh", path, loaded.error());
    return;
  }
  const Claim claim = options.claim.value_or(check::default_claim(loaded->mesh, nullptr));
  if (claim == Claim::kPeriodicDelaunay) {
    const std::string fault = unfold(*loaded, options.lattice, options.box);
    if (!fault.empty()) {
      output.error(ExitCode::kInputFault, "mesh", path, fault);
      return;
    }
  }
  const std::string fault = fault_of_loaded(claim, *loaded, options.check);
  if (!fault.empty()) {
    output.error(ExitCode::kInputFault, "mesh", path, fault);
    return;
  }
  if (misses_measures(path, loaded->mesh, options, nullptr, output)) return;
  output.begin("judging " + path, seconds_of_judging(loaded->mesh, options.check));
  auto verdict = judge_loaded(claim, *loaded, options.input.duplicates, options.check);
  output.notes(loaded->notes);
  if (!verdict) {
    output.error(ExitCode::kInputFault, "mesh", path, verdict.error());
    return;
  }
  check::Causes causes = check::causes(*verdict, loaded->mesh, [&](const Mesh& mended) {
    return judged_again(verdict->claim(), mended, nullptr, options.check);
  });
  verdict->causes = std::move(causes.found);
  Notes notes{loaded->notes, notes_without_domain(*verdict, loaded->mesh, path)};
  for (const auto& note :
       {note_of_complex(*verdict, path, causes.as_complex), note_of_merging(*loaded)}) {
    if (note) notes.of_verdict.push_back(*note);
  }
  report_verdict(path, *verdict, loaded->mesh, notes, options, nullptr, output);
  if (options.certificate) {
    output.end_watch();
    write_certificate(*options.certificate, path, loaded->mesh, *verdict, output);
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
  Notes notes{{}, notes_without_domain(judged->verdict, judged->named, path)};
  // What is not in memory is not judged as a complex.
  if (const auto note = note_of_complex(judged->verdict, path, std::nullopt)) {
    notes.of_verdict.push_back(*note);
  }
  report_verdict(path, judged->verdict, judged->named, notes, options, nullptr, output);
}

// Nothing, and said, if it is not judged. Requires: no equal points.
std::optional<Verdict> judged_against(const std::string& path, Claim claim,
                                      const check::KnownMesh& mesh,
                                      const std::map<Simplex, Vertex>& of_triangles,
                                      const HeldAgainst& against, const CheckOptions& options,
                                      Output& output) {
  const Domain& domain = against.loaded.domain;
  if (!options.within) return check::judge(claim, mesh, domain, options.check);
  auto judged = judged_within(*options.within, claim, mesh, domain, options.check,
                              against.bent ? &*against.bent : nullptr,
                              {of_triangles, against.polygon_markers()});
  if (judged) {
    check::judge_quality(mesh.mesh(), &against.judged(), options.within->squared(domain.complex),
                         options.check, *judged);
    return std::move(*judged);
  }
  const auto& [reason, is_input_fault] = judged.error();
  output.error(is_input_fault ? ExitCode::kInputFault : ExitCode::kUndecided, "mesh", path,
               path + ": " + reason);
  return std::nullopt;
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
  if (misses_measures(path, mesh, options, &domain.domain, output)) return;
  output.begin("judging " + path, seconds_of_judging(mesh, options.check));
  const Claim claim = options.claim
                          ? *options.claim
                          : check::default_claim(mesh, &domain.domain, options.within.has_value());
  const check::KnownMesh known(claim, mesh, domain.domain.complex.kind, options.check);
  auto verdict = judged_against(path, claim, known, loaded->face_markers, against, options, output);
  if (!verdict) return;
  check::Causes causes = check::causes(
      *verdict, mesh,
      [&](const Mesh& mended) { return judged_again(claim, mended, against, options); },
      known.known());
  verdict->causes = std::move(causes.found);
  Notes notes{loaded->notes, {}};
  std::optional<std::string> weaker;
  if (!options.claim) weaker = note_of_weaker_claim(*verdict);
  std::optional<std::string> lone;  // polygons of a bent domain are others
  if (!against.bent) lone = note_of_lone_polygons(*verdict, domain);
  const bool has_merged = options.said.merged_slope.has_value();
  const Judged judged{claim, known, domain, options.within, has_merged, loaded->face_markers};
  for (const auto& note :
       {remedy(*verdict, judged, options.check), lone, weaker, note_of_merging(*loaded)}) {
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

ExitCode run(CheckOptions& options) {
  if (const std::string fault = usage_fault(options); !fault.empty()) {
    return usage_error(fault);
  }
  Output output(options.output);
  output.watch("check");
  options.input.weighted = options.claim == Claim::kWeightedDelaunay;
  options.input.faces = options.domain.has_value() || options.check.complex.faces;
  options.input.for_certificate = options.certificate.has_value();
  options.check.threads = thread_count(options.threads);
  options.pictures = std::make_shared<Pictures>(options.picture);
  if (options.domain) {
    check_against_domain(options, output);
  } else if (options.claim == Claim::kVoronoi) {
    const VoronoiQuestion question{options.input, options.within, options.box, options.check};
    for (const std::string& cells : options.meshes) {
      check_voronoi(cells, question, *options.pictures, output);
    }
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
  add_check_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
