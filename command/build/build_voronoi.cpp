// circumspect build voronoi INPUT
#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/build/points_to_build.hpp"
#include "command/input/input.hpp"
#include "command/options/option_rows.hpp"
#include "command/output/output.hpp"
#include "command/subcommands.hpp"
#include "kernel/complex/circumball.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"
#include "reference/delaunay/lifted_hull.hpp"

namespace circumspect::cli {
namespace {

struct VoronoiOptions {
  std::string points;
  InputOptions input;
  OutputOptions output;
};

// The dual of a Delaunay subdivision: vertices are centres of its cells, ridges its edges. Vertices
// are counted from 1, because qvoronoi has the one at infinity for 0.
struct Dual {
  std::vector<Point> vertices = {};
  std::vector<std::vector<std::size_t>> cells = {};   // of each site, ascending; with 0 unbounded
  std::vector<std::vector<std::size_t>> ridges = {};  // two sites, then vertices, ascending
};

Dual dual_of(const PointSet& sites, const PolyhedralComplex& complex) {
  Dual dual;
  std::map<Face, std::size_t> cells_with;  // for each facet
  for (const Face& cell : complex.cells()) {
    dual.vertices.push_back(circumball(sites, flat_through(sites, cell).basis).centre);
    for (const Face& facet : complex.facets_of(cell)) ++cells_with[facet];
  }
  std::set<Face> of_boundary;
  for (const auto& [facet, count] : cells_with) {
    if (count == 1) of_boundary.insert(facet);
  }
  const auto vertices_around = [&](const Face& face) {
    const auto has_face = [&face](const Face& other) {
      return std::includes(other.begin(), other.end(), face.begin(), face.end());
    };
    std::vector<std::size_t> around;
    if (std::any_of(of_boundary.begin(), of_boundary.end(), has_face)) around.push_back(0);
    const std::vector<Face> cells = complex.cells();
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (has_face(cells[c])) around.push_back(c + 1);
    }
    return around;
  };
  for (const Vertex site : all_vertices(sites)) dual.cells.push_back(vertices_around({site}));
  for (const Face& edge : complex.faces(1)) {
    std::vector<std::size_t> ridge = {static_cast<std::size_t>(edge[0]),
                                      static_cast<std::size_t>(edge[1])};
    for (const std::size_t v : vertices_around(edge)) ridge.push_back(v);
    dual.ridges.push_back(ridge);
  }
  return dual;
}

std::string row(const std::vector<std::size_t>& numbers) {
  return fmt::format("{} {}\n", numbers.size(), fmt::join(numbers, " "));
}

// As `qvoronoi o Fv` writes it.
std::string text(const Dual& dual, std::size_t dimension) {
  std::string out =
      fmt::format("{}\n{} {} 1\n", dimension, dual.vertices.size() + 1, dual.cells.size());
  out += fmt::format("{}\n", fmt::join(std::vector<std::string>(dimension, "-10.101"), " "));
  for (const Point& vertex : dual.vertices) {
    std::vector<std::string> coordinates;
    for (const Rational& x : vertex) coordinates.push_back(to_decimal(x));
    out += fmt::format("{}\n", fmt::join(coordinates, " "));
  }
  for (const auto& cell : dual.cells) out += row(cell);
  out += fmt::format("{}\n", dual.ridges.size());
  for (const auto& ridge : dual.ridges) out += row(ridge);
  return out;
}

// {"input", "vertices": [{"exact": […], "decimal": […]}, …], "cells", "ridges"}, with −1 for the
// vertex at infinity, and vertices and sites counted from 0.
report::Json json(const LoadedPoints& input, const Dual& dual) {
  report::Json vertices = report::Json::array();
  for (const Point& vertex : dual.vertices) {
    report::Json decimals = report::Json::array();
    for (const Rational& x : vertex) decimals.push_back(to_decimal(x));
    vertices.push_back({{"exact", report::point(vertex)}, {"decimal", decimals}});
  }
  const auto from_0 = [](const std::vector<std::size_t>& listed, std::size_t begin) {
    report::Json array = report::Json::array();
    for (std::size_t i = begin; i < listed.size(); ++i) {
      array.push_back(static_cast<std::int64_t>(listed[i]) - 1);
    }
    return array;
  };
  report::Json cells = report::Json::array(), ridges = report::Json::array();
  for (const auto& cell : dual.cells) cells.push_back(from_0(cell, 0));
  for (const auto& ridge : dual.ridges) {
    ridges.push_back({{"sites", {ridge[0], ridge[1]}}, {"vertices", from_0(ridge, 2)}});
  }
  return {{"input", input.name}, {"vertices", vertices}, {"cells", cells}, {"ridges", ridges}};
}

ExitCode run(const VoronoiOptions& options) {
  Output output(options.output);
  output.watch("build");
  output.begin("building the diagram of " + options.points);
  const auto loaded = points_to_build(options.points, options.input, output);
  if (!loaded) return output.finish();
  if (!options.output.quiet) {  // standard output is for what reads diagrams
    for (const std::string& note : loaded->notes) say("note: " + on_one_line(note) + "\n");
  }
  const PointSet& sites = loaded->mesh.points;
  const bool span = sites.dimension() == static_cast<int>(sites.ambient_dimension());
  if (!span || sites.dimension() < 1) {
    output.error(ExitCode::kInputFault, "points", options.points,
                 fmt::format("{}: expected sites that span the space of their {} coordinates, "
                             "found a set of dimension {}: its cells have no corners",
                             options.points, sites.ambient_dimension(), sites.dimension()));
    return output.finish();
  }
  const Dual dual = dual_of(sites, delaunay::delaunay_subdivision(sites));
  if (output.wants_text()) output.text(text(dual, sites.ambient_dimension()));
  if (output.wants_json()) output.json(json(*loaded, dual));
  return output.finish();
}

}  // namespace

void add_build_voronoi(CLI::App& build, ExitCode& exit_code) {
  const auto options = std::make_shared<VoronoiOptions>();
  CLI::App* command =
      build.add_subcommand("voronoi", "The Voronoi diagram: the dual of the Delaunay subdivision");
  command->footer(
      "Example:\n"
      "  circumspect build voronoi points.node\n"
      "\n"
      "The text output is as that of qvoronoi o Fv, which check --claim voronoi reads; each "
      "coordinate is the double next to the exact one. The JSON output has both.");
  add_options(*command, {{"points", "", required(options->points),
                          "Sites: .node, .json, .off, or Qhull's form"}});
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_limit_option(*command, options->output);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
