// circumspect build delaunay-subdivision INPUT
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/build/points_to_build.hpp"
#include "command/input/input.hpp"
#include "command/options/one_of.hpp"
#include "command/options/option_rows.hpp"
#include "command/output/output.hpp"
#include "command/subcommands.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/gift_wrapping_cells.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::cli {
namespace {

using SubdivisionConstruction = PolyhedralComplex (*)(const PointSet&);

struct SubdivisionOptions {
  std::string points;
  std::string algorithm = "lifted-hull";
  InputOptions input;
  OutputOptions output;
};

const std::map<std::string, SubdivisionConstruction>& subdivisions() {
  static const std::map<std::string, SubdivisionConstruction> table = {
      {"lifted-hull",
       [](const PointSet& points) { return delaunay::delaunay_subdivision(points); }},
      {"by-definition", delaunay::delaunay_subdivision_by_definition},
      {"gift-wrapping-cells", delaunay::gift_wrapping_cells}};
  return table;
}

report::Json cell_labels(const ExactMesh& mesh, const Face& face) {
  report::Json array = report::Json::array();
  for (const Vertex v : face) array.push_back(mesh.label(v));
  return array;
}

// {"input", "dimension", "simplicial", "faces": {"0": […], …, "k": […]}}: every face by all the
// points on it.
report::Json json(const LoadedPoints& input, const PolyhedralComplex& complex) {
  report::Json faces = report::Json::object();
  for (int j = 0; j <= complex.dimension(); ++j) {
    report::Json of_dimension = report::Json::array();
    for (const Face& face : complex.faces(j)) of_dimension.push_back(cell_labels(input.mesh, face));
    faces[std::to_string(j)] = of_dimension;
  }
  return {{"input", input.name},
          {"dimension", complex.dimension()},
          {"simplicial", complex.is_simplicial()},
          {"faces", faces}};
}

std::string text(const LoadedPoints& input, const PolyhedralComplex& complex) {
  std::string out;
  for (const Face& cell : complex.cells()) {
    out += fmt::format("cell {}\n", report::labels(input.mesh, cell));
  }
  return out + fmt::format("built: delaunay-subdivision {} {} {} {}\n", on_one_line(input.name),
                           report::counted(input.mesh.points.size(), "point"),
                           report::counted(complex.cells().size(), "cell"),
                           complex.is_simplicial() ? "simplicial" : "not-simplicial");
}

ExitCode run(const SubdivisionOptions& options) {
  Output output(options.output);
  output.watch("build");
  output.begin("subdividing " + options.points);
  const auto loaded = points_to_build(options.points, options.input, output);
  if (!loaded) return output.finish();
  output.notes(loaded->notes);
  const PolyhedralComplex complex = subdivisions().at(options.algorithm)(loaded->mesh.points);
  if (output.wants_text()) output.text(text(*loaded, complex));
  if (output.wants_json()) output.json(json(*loaded, complex));
  return output.finish();
}

}  // namespace

void add_build_subdivision(CLI::App& build, ExitCode& exit_code) {
  const auto options = std::make_shared<SubdivisionOptions>();
  CLI::App* command = build.add_subcommand(
      "delaunay-subdivision",
      "The Delaunay subdivision, in which cospherical points share a cell: the projected "
      "lower hull of the lifted points");
  command->footer(
      "Example:\n"
      "  circumspect build delaunay-subdivision points.node\n"
      "\n"
      "The text output lists the points of each cell. The JSON output has the faces of all "
      "dimensions.");
  std::vector<std::string> names;
  for (const auto& [name, construction] : subdivisions()) names.push_back(name);
  add_options(
      *command,
      {{"points", "", required(options->points), "Points: .node, .json, .off, or Qhull's form"},
       {"--algorithm", "by-definition|gift-wrapping-cells|lifted-hull",
        into(options->algorithm, one_of_words(names)),
        "The algorithm. All make the same complex (default: lifted-hull)"},
       {"--weighted", "", flag(options->input.weighted),
        "Use the weights: the first attribute of a .node file, or the key weights of "
        "JSON"}});
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_limit_option(*command, options->output);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
