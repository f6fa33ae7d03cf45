// circumspect certify MESH -o CERT
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "oracle/check/check.hpp"
#include "oracle/cli/certificate_output.hpp"
#include "oracle/cli/input.hpp"
#include "oracle/cli/judge_file.hpp"
#include "oracle/cli/one_of.hpp"
#include "oracle/cli/output.hpp"
#include "oracle/cli/subcommands.hpp"
#include "oracle/cli/threads_option.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

struct CertifyOptions {
  std::string mesh;
  std::string certificate;
  Claim claim = Claim::kDelaunay;
  InputOptions input;
  OutputOptions output;
  std::uint64_t threads = 0;  // 0: as many as the machine has
};

void certify(const CertifyOptions& options, Output& output) {
  const JudgeFileOptions judging{{}, options.input, true, thread_count(options.threads)};
  const auto judged = judge_file(options.mesh, options.claim, judging);
  if (!judged) {
    output.error(ExitCode::kInputFault, "mesh", options.mesh, judged.error());
    return;
  }
  for (const std::string& note : judged->notes) output.text("note: " + note + "\n");
  const Mesh& mesh = judged->mesh;
  const Verdict& verdict = judged->verdict;
  if (!write_certificate(options.certificate, options.mesh, mesh, verdict, output)) return;
  output.exit_with(verdict.holds() ? ExitCode::kHolds : ExitCode::kFails);
  output.text(report::verdict_line(verdict, mesh, options.mesh) + "\n");
  if (output.wants_json()) {
    report::Json result = report::verdict(verdict, mesh, options.mesh, check::By::kLemma);
    result["certificate"] = options.certificate;
    output.json(std::move(result));
  }
}

ExitCode run(CertifyOptions& options) {
  OutputOptions spoken = options.output;
  if (options.certificate == "-") {
    if (spoken.format == OutputFormat::kJson) {
      fmt::print(stderr, "circumspect: expected one of -o - and --format json, found both\n");
      return ExitCode::kUsage;
    }
    spoken.quiet = true;
  }
  options.input.weighted = options.claim == Claim::kWeightedDelaunay;
  Output output(spoken);
  certify(options, output);
  return output.finish();
}

}  // namespace

void add_certify(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<CertifyOptions>();
  CLI::App* command = app.add_subcommand(
      "certify", "Judge a mesh, and write what proves the verdict to a checker that is proved");
  command->footer(
      "Example:\n"
      "  circumspect certify points.1.ele -o points.cert\n"
      "  circumspect-verified points.cert        # trusts nothing that stands above\n\n"
      "Of a claim that holds a certificate is written, else a refutation. What either has to\n"
      "fulfil, and what follows from it, is in proofs/CERTIFICATE.md.\n\n"
      "Exit codes: 0 the claim holds, 1 it does not, 2 usage, or points that do not span the\n"
      "plane or space, 3 the input is at fault, 5 internal error.");
  command->add_option("mesh", options->mesh, "A mesh, in any format that check reads")->required();
  command
      ->add_option("-o,--output", options->certificate,
                   "Where the certificate or the refutation goes; - for stdout, which then holds "
                   "nothing else")
      ->option_text("FILE")
      ->required();
  const std::map<std::string, Claim> claims = {{"triangulation", Claim::kTriangulation},
                                               {"delaunay", Claim::kDelaunay},
                                               {"weighted-delaunay", Claim::kWeightedDelaunay}};
  command
      ->add_option("--claim", options->claim,
                   "What is claimed of the mesh (default: delaunay); weights as for check")
      ->transform(one_of(claims))
      ->option_text("triangulation|delaunay|weighted-delaunay");
  command->add_option("--points", options->input.points, "The file with the points of the mesh")
      ->option_text("FILE");
  add_threads_option(*command, options->threads);
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
