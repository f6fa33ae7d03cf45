// circumspect certify MESH -o CERT
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/check/certificate_output.hpp"
#include "command/check/judge_loaded.hpp"
#include "command/input/input.hpp"
#include "command/options/one_of.hpp"
#include "command/options/threads_option.hpp"
#include "command/output/output.hpp"
#include "command/output/overwriting.hpp"
#include "command/subcommands.hpp"
#include "oracle/judge/points/check.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

struct CertifyOptions {
  std::string mesh;
  std::string certificate;
  std::optional<Claim> asked;
  std::optional<std::string> domain;       // understood, so that the answer says why there is none
  std::optional<std::string> domain_kind;  // likewise
  InputOptions input;
  OutputOptions output;
  std::uint64_t threads = 0;  // 0: as many as the machine has

  Claim claim() const { return asked.value_or(Claim::kDelaunay); }
};

void certify(const CertifyOptions& options, Output& output) {
  const unsigned threads = thread_count(options.threads);
  auto loaded = load_mesh(options.mesh, options.input, threads);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "mesh", options.mesh, loaded.error());
    return;
  }
  const auto verdict =
      judge_loaded(options.claim(), *loaded, options.input.duplicates, {.threads = threads});
  if (!verdict) {
    output.error(ExitCode::kInputFault, "mesh", options.mesh, verdict.error());
    return;
  }
  for (const std::string& note : loaded->notes) output.note(note);
  const Mesh& mesh = loaded->mesh;
  if (!write_certificate(options.certificate, options.mesh, exact(mesh), *verdict, output)) return;
  output.exit_with(verdict->holds() ? ExitCode::kHolds : ExitCode::kFails);
  output.text(report::verdict_line(*verdict, mesh, options.mesh) + "\n");
  if (output.wants_json()) {
    report::Json result = report::verdict(*verdict, mesh, options.mesh, check::By::kLemma);
    result["certificate"] = options.certificate;
    output.json(std::move(result));
  }
}

// What was asked for that certificates are not about; empty if nothing was.
std::string usage_fault(const CertifyOptions& options) {
  const std::string about =
      ": certificates are about the claims triangulation, delaunay and weighted-delaunay, of a "
      "mesh "
      "without a domain; circumspect check judges the others";
  if (options.domain || options.domain_kind) {
    return fmt::format("expected no {} for certify, found one{}",
                       options.domain ? "--domain" : "--domain-kind", about);
  }
  if (is_about_a_domain(options.claim())) {
    return fmt::format("expected a claim without a domain, found {}{}", name(options.claim()),
                       about);
  }
  return "";
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
  const std::string fault = overwriting_fault({{"the certificate", options.certificate}}, read);
  if (!fault.empty()) return usage_error(fault);
  options.input.weighted = options.claim() == Claim::kWeightedDelaunay;
  Output output(spoken);
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
      "  circumspect-verified points.cert        # trusts nothing that stands above\n\n"
      "If the claim holds, a certificate is written, and otherwise a refutation.\n"
      "proofs/CERTIFICATE.md describes both and says what follows from them.\n\n"
      "Exit codes: 0 the claim holds, 1 it does not, 2 usage, or points that do not span the\n"
      "plane or space, 3 the input is at fault, 5 internal error.");
  command->add_option("mesh", options->mesh, "A mesh, in any format that check reads")->required();
  command
      ->add_option("-o,--output", options->certificate,
                   "The file for the certificate or the refutation; - is stdout, which then holds "
                   "nothing else")
      ->option_text("FILE")
      ->required();
  // The other claims are understood, so that the answer says why there is no certificate of them.
  add_claim_option(*command, options->asked,
                   "The claim to judge (default: delaunay); weights are read as by check")
      ->option_text("triangulation|delaunay|weighted-delaunay");
  command->add_option("--domain", options->domain)->group("");
  command->add_option("--domain-kind", options->domain_kind)->group("");
  command->add_option("--points", options->input.points, "The file with the points of the mesh")
      ->option_text("FILE");
  add_threads_option(*command, options->threads);
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
