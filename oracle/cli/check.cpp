// circumspect check MESH…
#include "oracle/check/check.hpp"

#include <map>
#include <memory>

#include <CLI/CLI.hpp>

#include "oracle/cli/input.hpp"
#include "oracle/cli/output.hpp"
#include "oracle/cli/subcommands.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

struct CheckOptions {
  std::vector<std::string> meshes;
  Claim claim = Claim::kDelaunay;
  check::Options check;
  InputOptions input;
  OutputOptions output;
};

void check_one(const std::string& path, const CheckOptions& options, Output& output) {
  const auto loaded = load_mesh(path, options.input);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "mesh", path, loaded.error());
    return;
  }
  const Verdict verdict = check::judge(options.claim, loaded->mesh, options.check);
  output.exit_with(verdict.holds() ? ExitCode::kHolds : ExitCode::kFails);
  if (output.wants_text()) {
    output.text(report::explanation(verdict, loaded->mesh));
    output.text(report::verdict_line(verdict, loaded->mesh, path) + "\n");
  }
  if (output.wants_json()) {
    output.json(report::verdict(verdict, loaded->mesh, path, options.check.by));
  }
}

}  // namespace

void add_check(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Judge meshes that any program made");
  command->footer(
      "Example:\n"
      "  tetgen points.node                      # TetGen writes points.1.node, points.1.ele\n"
      "  circumspect check points.1.ele          # exit 0: Delaunay; 1: not, with a witness\n\n"
      "Exit codes: 0 the claim holds, 1 it does not, 2 usage, 3 the input is at fault,\n"
      "5 internal error.");
  command
      ->add_option("mesh", options->meshes,
                   "Meshes: .ele (points in the .node beside it), .json, .off, .qhull-i; "
                   "- for JSON on stdin")
      ->required();
  const std::map<std::string, Claim> claims = {{"triangulation", Claim::kTriangulation},
                                               {"delaunay", Claim::kDelaunay},
                                               {"weighted-delaunay", Claim::kWeightedDelaunay}};
  command
      ->add_option("--claim", options->claim,
                   "What is claimed of the mesh (default: delaunay); weights are the first "
                   "attribute of a .node file, as for tetgen -w, or the key weights of JSON")
      ->transform(CLI::CheckedTransformer(claims, CLI::ignore_case).description(""))
      ->option_text("triangulation|delaunay|weighted-delaunay");
  command->add_option("--points", options->input.points, "The file with the points of the mesh")
      ->option_text("FILE");
  const std::map<std::string, check::By> ways = {{"lemma", check::By::kLemma},
                                                 {"definition", check::By::kDefinition}};
  command
      ->add_option("--by", options->check.by,
                   "Judge by the lemmas (default) or, slowly, by the definitions")
      ->transform(CLI::CheckedTransformer(ways, CLI::ignore_case).description(""))
      ->option_text("lemma|definition");
  command->add_flag("--oriented", options->check.oriented,
                    "Demand that all simplices list their vertices with one orientation");
  command->add_flag("--neighbors", options->input.neighbors,
                    "Also hold the .neigh file beside each .ele against the mesh");
  command
      ->add_option("--max-errors", options->check.max_violations,
                   "How many witnesses are kept (default 20; 0: all)")
      ->check(CLI::Validator(CLI::NonNegativeNumber).description(""))
      ->option_text("N");
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] {
    Output output(options->output);
    options->input.weighted = options->claim == Claim::kWeightedDelaunay;
    for (const std::string& mesh : options->meshes) check_one(mesh, *options, output);
    exit_code = output.finish();
  });
}

}  // namespace circumspect::cli
