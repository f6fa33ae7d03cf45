// circumspect build WHAT INPUT
#include <iostream>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>

#include "oracle/cli/input.hpp"
#include "oracle/cli/output.hpp"
#include "oracle/cli/subcommands.hpp"
#include "oracle/formats/ele.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/neigh.hpp"
#include "oracle/report/wording.hpp"
#include "reference/complex/facets.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/by_definition.hpp"
#include "reference/delaunay/genericity.hpp"

namespace circumspect::cli {
namespace {

using Construction = Triangulation (*)(const PointSet&);

struct BuildOptions {
  std::string points;
  std::string output_file;
  std::string neighbors_file;
  std::string algorithm = "bowyer-watson";
  InputOptions input;
  OutputOptions output;
};

const std::map<std::string, Construction>& constructions() {
  static const std::map<std::string, Construction> table = {
      {"bowyer-watson", delaunay::bowyer_watson}, {"by-definition", delaunay::by_definition}};
  return table;
}

// The empty set has no simplices, but a file of them still says how many vertices each has.
std::size_t vertices_of_each(const Triangulation& triangulation) {
  return static_cast<std::size_t>(std::max(triangulation.dimension(), 0) + 1);
}

// Positively oriented, so that programs that care find det[p_0 − p_d; …] > 0; vertices by the
// user's own indices.
formats::SimplexFile simplex_file(const Mesh& mesh, const Triangulation& triangulation) {
  formats::SimplexFile file;
  file.first_index = mesh.first_index;
  file.vertices_per_simplex = vertices_of_each(triangulation);
  for (const Simplex& simplex : triangulation.simplices()) {
    Simplex own = positively_oriented(mesh.points, simplex);
    for (Vertex& v : own) v = mesh.label(v);
    file.simplices.push_back(own);
  }
  return file;
}

// neighbors[s][i]: the simplex across the facet opposite vertex i of simplex s, in the order in
// which simplex_file lists both; −1 on the hull.
formats::NeighborFile neighbor_file(const Mesh& mesh, const Triangulation& triangulation) {
  std::vector<Simplex> simplices;
  for (const Simplex& simplex : triangulation.simplices()) {
    simplices.push_back(positively_oriented(mesh.points, simplex));
  }
  formats::NeighborFile file;
  file.first_index = mesh.first_index;
  file.neighbors_per_simplex = vertices_of_each(triangulation);
  for (const Simplex& simplex : simplices) file.neighbors.emplace_back(simplex.size(), -1);
  for_each_facet(facet_uses(simplices), [&](std::span<const FacetUse> group) {
    if (group.size() != 2) return;
    const auto link = [&](const FacetUse& from, const FacetUse& to) {
      file.neighbors[from.simplex][from.opposite] =
          static_cast<Vertex>(to.simplex) + mesh.first_index;
    };
    link(group[0], group[1]);
    link(group[1], group[0]);
  });
  return file;
}

// The document lists the points itself, without those that were merged, so that vertices are counted
// among these.
formats::JsonFile json_file(const Mesh& mesh, const Triangulation& triangulation) {
  formats::JsonFile file;
  file.points.dimension = std::max<std::size_t>(mesh.points.ambient_dimension(), 1);
  file.points.points = mesh.points.points();
  file.points.first_index = mesh.first_index;
  file.has_simplices = true;
  file.simplices = simplex_file({mesh.points, {}, {}, mesh.first_index}, triangulation);
  return file;
}

void build_delaunay(const BuildOptions& options, Output& output) {
  const auto loaded = load_points(options.points, options.input);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "points", options.points, loaded.error());
    return;
  }
  const Mesh& mesh = loaded->mesh;
  const Triangulation triangulation = constructions().at(options.algorithm)(mesh.points);
  const auto write = [&](const std::string& path, const auto& writer) {
    const std::string failure = write_file(path, writer);
    if (!failure.empty()) output.error(ExitCode::kUsage, "points", options.points, failure);
    return failure.empty();
  };
  if (!options.output_file.empty() && !write(options.output_file, [&](std::ostream& stream) {
        formats::write_ele(stream, simplex_file(mesh, triangulation));
      })) {
    return;
  }
  if (!options.neighbors_file.empty() && !write(options.neighbors_file, [&](std::ostream& stream) {
        formats::write_neigh(stream, neighbor_file(mesh, triangulation));
      })) {
    return;
  }
  if (output.wants_json()) {
    formats::write_json(std::cout, json_file(mesh, triangulation));
    std::cout.flush();
    return;
  }
  const bool unique =
      !delaunay::cospherical_points_of_an_empty_ball(mesh.points, triangulation).has_value();
  output.text(fmt::format("built: delaunay {} {} points {} {} {} canonical\n", loaded->name,
                          mesh.points.size(), triangulation.simplices().size(),
                          report::simplices_noun(triangulation.dimension()),
                          unique ? "unique" : "not-unique"));
}

ExitCode run(const BuildOptions& options) {
  if (options.output_file.empty() && options.output.format == OutputFormat::kText) {
    fmt::print(stderr, "circumspect: expected -o OUT.ele or --format json, found neither\n");
    return ExitCode::kUsage;
  }
  if (options.output_file == "-" && options.output.format == OutputFormat::kJson) {
    fmt::print(stderr,
               "circumspect: expected one thing for standard output, found two: "
               "-o - and --format json\n");
    return ExitCode::kUsage;
  }
  OutputOptions spoken = options.output;
  // The mesh itself goes to stdout: then nothing else does.
  if (options.output_file == "-" || options.neighbors_file == "-") spoken.quiet = true;
  Output output(spoken);
  build_delaunay(options, output);
  // Where the mesh is the JSON document, only an error needs another one.
  return output.exit_code() == ExitCode::kHolds ? ExitCode::kHolds : output.finish();
}

}  // namespace

void add_build(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<BuildOptions>();
  CLI::App* build = app.add_subcommand("build", "Make a reference");
  build->require_subcommand(1);
  CLI::App* command = build->add_subcommand(
      "delaunay", "The canonical Delaunay triangulation of a point set of any dimension");
  command->footer(
      "Example:\n"
      "  circumspect build delaunay points.node -o reference.ele\n\n"
      "Writes one simplex a line with k+1 vertices, k the dimension of the points' affine hull,\n"
      "positively oriented, indices as in the input.");
  command->add_option("points", options->points, "Points: .node, .json, .off, or Qhull's form")
      ->required();
  command->add_option("-o,--output", options->output_file, "Where to write the .ele file; - stdout")
      ->option_text("OUT.ele");
  command->add_option("--neighbors", options->neighbors_file, "Also write the .neigh file")
      ->option_text("OUT.neigh");
  command
      ->add_option("--algorithm", options->algorithm,
                   "All give the same set of simplices (default: bowyer-watson)")
      ->check(CLI::IsMember({"bowyer-watson", "by-definition"}).description(""))
      ->option_text("bowyer-watson|by-definition");
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
