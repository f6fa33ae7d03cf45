// circumspect inspect INPUT
#include <algorithm>
#include <memory>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/check/certificate_output.hpp"
#include "command/input/input.hpp"
#include "command/inspect/inspect_domain.hpp"
#include "command/inspect/inspect_mesh.hpp"
#include "command/inspect/inspect_points.hpp"
#include "command/inspect/refutation_files.hpp"
#include "command/options/nearest_word.hpp"
#include "command/options/option_rows.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/output.hpp"
#include "command/output/picture_output.hpp"
#include "command/subcommands.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/read_domain.hpp"

namespace circumspect::cli {

namespace {

struct InspectOptions {
  std::vector<std::string> inputs;
  std::vector<std::string> only;  // some of the facts; none means all
  std::string html;               // what is found, to look at; empty: none
  PointsInspection points;
  DomainInspection domain;
  MeshInspection mesh;
  InputOptions input;
  OutputOptions output;
};

// What is wrong with the facts that are asked for; empty if nothing is.
std::string facts_fault(const std::vector<std::string>& only, std::string_view of,
                        const std::vector<std::string>& known) {
  for (const std::string& fact : only) {
    if (std::find(known.begin(), known.end(), fact) != known.end()) continue;
    return fmt::format("expected --only {} for {}, found {}{}", fmt::join(known, "|"), of, fact,
                       nearest_text(fact, known));
  }
  return "";
}

void inspect_one(const std::string& path, const InspectOptions& options, Output& output,
                 picture::Page* page) {
  const bool is_mesh =
      options.mesh.is_asked_for || (!options.domain.is_asked_for && is_mesh_file(path));
  const bool is_domain = !is_mesh && (options.domain.is_asked_for || formats::is_domain_file(path));
  const std::string fault = is_mesh     ? facts_fault(options.only, "a mesh", mesh_facts())
                            : is_domain ? facts_fault(options.only, "a domain", domain_facts())
                                        : facts_fault(options.only, "points", point_facts());
  if (!fault.empty()) {
    output.error(ExitCode::kUsage, is_mesh ? "mesh" : is_domain ? "domain" : "input", path, fault);
  } else if (is_mesh) {
    inspect_mesh(path, options.input, options.only, output, page);
  } else if (is_domain) {
    inspect_domain(path, options.input, options.domain, options.only, output, page);
  } else {
    inspect_points(path, options.input, options.points, options.only, output, page);
  }
}

// What is wrong with the names of the files that are to be written; empty if nothing is.
std::string output_fault(const InspectOptions& options) {
  const std::string& prefix = options.domain.refutations;
  if (!prefix.empty() && options.inputs.size() != 1) {
    return fmt::format("expected one domain beside --refutations, found {} inputs",
                       options.inputs.size());
  }
  std::vector<Written> proofs;
  if (!prefix.empty()) {
    for (const std::string& path : refutation_files(prefix)) proofs.push_back({"the proofs", path});
    for (const std::string& path : impossibility_files(prefix))
      proofs.push_back({"the proofs", path});
  }
  std::vector<std::string> read;
  for (const std::string& input : options.inputs) {
    for (std::string& path : files_of_domain(input)) read.push_back(std::move(path));
  }
  return page_fault(options.html, std::move(proofs), read);
}

ExitCode run(const InspectOptions& options) {
  if (const std::string fault = output_fault(options); !fault.empty()) return usage_error(fault);
  Output output(options.output);
  output.watch("inspect");
  picture::Page page;
  picture::Page* const shown = options.html.empty() ? nullptr : &page;
  for (const std::string& input : options.inputs) inspect_one(input, options, output, shown);
  output.end_watch();
  if (!page.is_empty()) write_page(options.html, page, output);
  return output.finish();
}

}  // namespace

void add_inspect(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<InspectOptions>();
  CLI::App* command = app.add_subcommand(
      "inspect",
      "Print facts about points (dimension, duplicates, genericity, counts), about a mesh "
      "(topology, size, quality) or about a domain (validity, polyhedra, edge-protection, "
      "existence of a CDT)");
  command->footer(
      "Example:\n"
      "  circumspect inspect points.node\n"
      "  circumspect inspect part.1.ele\n"
      "  circumspect inspect part.poly\n"
      "\n"
      "A set is generic if no k+2 of its points lie on one sphere, where k is the dimension "
      "of its\n"
      "affine hull. 'unique' says that there is only one Delaunay triangulation.\n"
      "\n"
      "If a domain is not a piecewise linear complex, inspect lists its breaches and ends "
      "with exit\n"
      "code 3. Otherwise it prints each fact as soon as it is known, and the last line says "
      "whether\n"
      "the domain has a constrained Delaunay triangulation (CDT):\n"
      "  cdt canonical   it has the CDT that the symbolic perturbation selects\n"
      "  cdt another     it has a CDT, but not that one\n"
      "  cdt none        it has no CDT without Steiner points; this is proved\n"
      "  cdt unknown     the search reached a limit (exit code 4 with --decide)\n"
      "\n"
      "Exit codes: 0 inspected, 2 usage, 3 the input is at fault, 4 interrupted, stopped by "
      "--limit or\n"
      "undecided in spite of --decide, 5 internal error.");
  add_options(
      *command,
      {{"input", "", required(options->inputs),
        fmt::format("Points: {}; meshes: .ele, .tet, .npz, .qhull-i, and with --mesh all that "
                    "check reads; domains: {}",
                    formats::endings_in_help(&formats::Format::has_points),
                    formats::endings_in_help(&formats::Format::has_domain))},
       {"--subsets", "N", into(options->points.subsets, whole_number()),
        "Test at most N subsets for genericity (default: 200000; 0: all)"},
       {"--simplex", "VERTICES", into(options->points.simplices),
        "Tell whether this simplex, of any dimension, is Delaunay or strongly Delaunay (\"1 2 "
        "3\")"},
       {"--only", "FACTS", listed(options->only),
        "Find only these facts: for points dimension, genericity, simplices; for a mesh "
        "topology, size, quality; for a domain validity, regions, edge-protection, cdt"},
       {"--mesh", "", flag(options->mesh.is_asked_for),
        "Take the input for a mesh: .msh, .mesh, .vtk, .vtu and .ply may be a domain as well"},
       {"--points", "FILE", into(options->input.points), "The file with the points of the mesh"}});
  add_domain_inspection_options(*command, options->domain);
  add_page_option(*command, options->html, "the facts, and each breach of a domain as a picture");
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_dimension_option(*command, options->input);
  add_limit_option(*command, options->output);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
