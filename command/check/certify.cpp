// circumspect certify MESH -o CERT
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/check/certificate_output.hpp"
#include "command/check/check_voronoi.hpp"
#include "command/check/complex_options.hpp"
#include "command/check/judge_loaded.hpp"
#include "command/check/periodic_mesh.hpp"
#include "command/input/domain_input.hpp"
#include "command/input/input.hpp"
#include "command/options/one_of.hpp"
#include "command/options/option_rows.hpp"
#include "command/options/threads.hpp"
#include "command/options/usage_faults.hpp"
#include "command/output/expected_time.hpp"
#include "command/output/output.hpp"
#include "command/output/overwriting.hpp"
#include "command/subcommands.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/plane.hpp"
#include "oracle/formats/read_domain.hpp"
#include "oracle/judge/default_claim.hpp"
#include "oracle/model/options.hpp"
#include "oracle/model/verdict.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

struct CertifyOptions {
  std::string mesh;
  std::string certificate;
  std::optional<Claim> asked;
  std::optional<std::string> domain;
  DomainOptions said;
  std::optional<JudgedBox> box;  // that a mesh repeats
  LatticeOption lattice;
  InputOptions input;
  OutputOptions output;
  check::By by = check::By::kLemma;
  bool allow_unused = false;
  std::uint64_t threads = 0;          // 0: as many as the machine has
  std::vector<std::string> required;  // refused
};

void report(const CertifyOptions& options, const Verdict& verdict, const Mesh& mesh,
            const Domain* domain, Output& output) {
  output.exit_with(verdict.holds() ? ExitCode::kHolds : ExitCode::kFails);
  output.text(report::verdict_line(verdict, mesh, options.mesh, domain) + "\n");
  if (output.wants_json()) {
    report::Json result = report::verdict(verdict, mesh, options.mesh, options.by, domain);
    result["certificate"] = options.certificate;
    output.json(std::move(result));
  }
}

// circumspect-verified reads .poly and .smesh as they stand.
tl::expected<LoadedDomain, DomainFault> domain_for_certificate(const CertifyOptions& options) {
  auto file = formats::read_domain(*options.domain, options.input.coordinates);
  if (!file) return tl::unexpected(DomainFault{file.error().to_string()});
  const std::string end = formats::extension(*options.domain);
  if (end == ".poly" || end == ".smesh") file = formats::as_it_stands(std::move(*file));
  return load_domain(std::move(*file), *options.domain, options.input, options.said);
}

// Empty if mesh and domain have points of one dimension. check judges a mesh of the plane against a
// domain in a plane of space; a certificate is compared with the files as they stand.
std::string dimension_fault(const std::string& path, const Mesh& mesh, const Domain& domain) {
  const std::size_t expected = domain.complex.ambient_dimension();
  if (mesh.dimension() == expected) return "";
  return fmt::format(
      "{}: expected points of dimension {}, as the domain has them, found dimension {}: "
      "circumspect-verified compares the certificate with the files as they stand",
      path, expected, mesh.dimension());
}

void certify(const CertifyOptions& options, Output& output) {
  const unsigned threads = thread_count(options.threads);
  std::optional<LoadedDomain> domain;
  if (options.domain) {
    output.begin("reading " + *options.domain);
    auto read = domain_for_certificate(options);
    if (!read) {
      output.notes(read.error().file.notes);
      output.error(ExitCode::kInputFault, "domain", *options.domain, read.error().message);
      return;
    }
    domain = std::move(*read);
    output.notes(domain->file.notes);
  }
  output.begin("reading " + options.mesh);
  auto loaded = domain ? load_mesh(options.mesh, options.input, threads, frame_of(*domain))
                       : load_mesh(options.mesh, options.input, threads);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "mesh", options.mesh, loaded.error());
    return;
  }
  const Domain* about = domain ? &domain->domain : nullptr;
  // The claim may depend on which points there are.
  std::string fault = about ? dimension_fault(options.mesh, loaded->mesh, *about) : std::string();
  if (domain && fault.empty()) fault = settle_equal_points(*loaded, options.input.duplicates);
  if (!fault.empty()) {
    output.error(ExitCode::kInputFault, "mesh", options.mesh, fault);
    return;
  }
  const Claim claim = options.asked ? *options.asked : check::default_claim(loaded->mesh, about);
  check::Options judging = {.by = options.by, .threads = threads};
  judging.complex.allow_unused = options.allow_unused;
  if (claim == Claim::kPeriodicDelaunay) fault = unfold(*loaded, options.lattice, options.box);
  if (fault.empty()) fault = fault_of_loaded(claim, *loaded, judging);
  if (!fault.empty()) {
    output.error(ExitCode::kInputFault, "mesh", options.mesh, fault);
    return;
  }
  output.begin("judging " + options.mesh, seconds_of_judging(loaded->mesh, judging));
  const auto verdict = judge_loaded(claim, *loaded, options.input.duplicates, judging, about);
  if (!verdict) {
    output.error(ExitCode::kInputFault, "mesh", options.mesh, verdict.error());
    return;
  }
  output.notes(loaded->notes);
  output.begin("certifying " + options.mesh);
  const bool written =
      about == nullptr
          ? write_certificate(options.certificate, options.mesh, loaded->mesh, *verdict, output)
          : write_domain_certificate(options.certificate, options.mesh, exact(loaded->mesh),
                                     *domain, *verdict, output);
  if (const auto note = note_of_merging(*loaded)) output.notes({*note});
  if (written) report(options, *verdict, loaded->mesh, about, output);
}

// What was left out or does not go together; empty if all is well.
std::string usage_fault(const CertifyOptions& options) {
  const Asked periodic{options.asked == Claim::kPeriodicDelaunay, "--claim periodic-delaunay"};
  const Asked box{options.box.has_value(), "--box"};
  const Asked lattice{options.lattice.is_given(), "--lattice"};
  return first_fault(
      {{!options.required.empty(),
        "expected no --require of a certificate, found it: nothing is proved of the shape of "
        "simplices; circumspect check judges it"},
       domain_options_fault(options.said, options.asked, options.domain.has_value()),
       certificate_fault(options.asked, options.said),
       dependence(box, periodic),
       dependence(lattice, periodic),
       dependence({options.allow_unused, "--allow-unused"},
                  {options.asked == Claim::kComplex, "--claim complex"}),
       contradiction(lattice, box),
       dependence(periodic, {box.is_given || lattice.is_given, "--lattice or --box"},
                  "say how the mesh repeats")});
}

ExitCode run(CertifyOptions& options) {
  if (const std::string fault = usage_fault(options); !fault.empty()) {
    return usage_error(fault);
  }
  OutputOptions spoken = options.output;
  if (options.certificate == "-") {
    if (spoken.format == OutputFormat::kJson) {
      return usage_error("expected one of -o - and --format json, found both");
    }
    spoken.quiet = true;
  }
  std::vector<std::string> read = files_of_mesh(options.mesh);
  if (options.input.points) read.push_back(*options.input.points);
  if (options.domain) read.push_back(*options.domain);
  const std::string fault = overwriting_fault({{"the certificate", options.certificate}}, read);
  if (!fault.empty()) return usage_error(fault);
  options.input.weighted = options.asked == Claim::kWeightedDelaunay;
  options.input.faces = options.domain.has_value();
  options.input.for_certificate = true;
  Output output(spoken);
  output.watch("certify");
  certify(options, output);
  return output.finish();
}

}  // namespace

void add_certify(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<CertifyOptions>();
  CLI::App* command = app.add_subcommand(
      "certify", "Judge a mesh, and write a certificate or a refutation for circumspect-verified");
  command->footer(
      "Example:\n"
      "  circumspect certify points.1.ele -o points.cert\n"
      "  circumspect-verified points.cert        # checks it without trusting circumspect\n"
      "\n"
      "If the claim holds, certify writes a certificate, and otherwise a refutation. Some "
      "failures of\n"
      "claims about domains have no refutation. proofs/CERTIFICATE.md describes both, and "
      "says what\n"
      "they prove.\n"
      "\n"
      "Exit codes: 0 the claim holds, 1 it does not, 2 usage, or there is no certificate or "
      "refutation,\n"
      "3 the input is at fault, 4 interrupted or stopped by --limit, 5\n"
      "internal error.");
  add_options(*command,
              {{"mesh", "", required(options->mesh), "A mesh, in any format that check reads"},
               {"-o,--output", "FILE", required(options->certificate),
                "The file for the certificate or the refutation. With -, it goes to "
                "stdout, and nothing else does"}});
  add_claim_option(
      *command, options->asked,
      "The claim to judge (default: that of check). Weights are read as check reads them")
      ->option_text("CLAIM");
  add_options(*command,
              {{"--domain", "FILE", into(options->domain), "The domain that the mesh must fill"}});
  add_domain_options(*command, options->said);
  add_box_option(*command, options->box);
  add_lattice_option(*command, options->lattice);
  add_allow_unused_option(*command, options->allow_unused);
  const std::map<std::string, check::By> manners = {{"lemma", check::By::kLemma},
                                                    {"definition", check::By::kDefinition}};
  add_options(*command, {{"--points", "FILE", into(options->input.points),
                          "The file with the points of the mesh"},
                         {"--by", "lemma|definition", into(options->by, one_of(manners)),
                          "Judge by the lemmas (default) or, slowly, by the definitions"}});
  command->add_option("--require", options->required, "Refused: nothing is proved of it")
      ->group("");
  add_threads_option(*command, options->threads);
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_limit_option(*command, options->output);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
