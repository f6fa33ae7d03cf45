// circumspect build all-triangulations INPUT
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/build/points_to_build.hpp"
#include "command/input/input.hpp"
#include "command/options/option_rows.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/output.hpp"
#include "command/subcommands.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"
#include "reference/optimality/all_triangulations.hpp"

namespace circumspect::cli {
namespace {

struct AllTriangulationsOptions {
  std::string points;
  std::size_t max_points = 9;
  bool some_points = false;
  InputOptions input;
  OutputOptions output;
};

struct Listed {
  Triangulation triangulation;
  bool is_delaunay;
  bool is_regular;
};

std::vector<Listed> list_all(const PointSet& points, optimality::VertexUse use) {
  std::vector<Listed> all;
  for (const Triangulation& triangulation : optimality::all_triangulations(points, use)) {
    all.push_back(
        {triangulation,
         check::judge_points(Claim::kDelaunay, {points, triangulation.simplices()}).holds(),
         optimality::heights_of_regular(points, triangulation).has_value()});
  }
  return all;
}

std::string text(const LoadedPoints& input, const std::vector<Listed>& all) {
  std::string out;
  std::size_t delaunay_ones = 0;
  std::size_t regular_ones = 0;
  for (const Listed& listed : all) {
    delaunay_ones += listed.is_delaunay ? 1u : 0u;
    regular_ones += listed.is_regular ? 1u : 0u;
    std::string line;
    for (const Simplex& simplex : listed.triangulation.simplices()) {
      line += (line.empty() ? "" : ", ") + report::labels(input.mesh, simplex);
    }
    out += fmt::format("{}{}{}\n", line, listed.is_delaunay ? " delaunay" : "",
                       listed.is_regular ? " regular" : "");
  }
  return out +
         fmt::format("built: all-triangulations {} {} {} {} regular {} delaunay\n",
                     on_one_line(input.name), report::counted(input.mesh.points.size(), "point"),
                     report::counted(all.size(), "triangulation"), regular_ones, delaunay_ones);
}

report::Json json(const LoadedPoints& input, const std::vector<Listed>& all) {
  report::Json triangulations = report::Json::array();
  for (const Listed& listed : all) {
    report::Json simplices = report::Json::array();
    for (const Simplex& simplex : listed.triangulation.simplices()) {
      report::Json vertices = report::Json::array();
      for (const Vertex v : simplex) vertices.push_back(input.mesh.label(v));
      simplices.push_back(vertices);
    }
    triangulations.push_back({{"simplices", simplices},
                              {"delaunay", listed.is_delaunay},
                              {"regular", listed.is_regular}});
  }
  return {{"input", input.name}, {"triangulations", triangulations}};
}

ExitCode run(const AllTriangulationsOptions& options) {
  Output output(options.output);
  output.watch("build");
  output.begin("listing all triangulations of " + options.points);
  const auto loaded = points_to_build(options.points, options.input, output);
  if (!loaded) return output.finish();
  output.notes(loaded->notes);
  const PointSet& points = loaded->mesh.points;
  if (options.max_points != 0 && points.size() > options.max_points) {
    output.error(
        ExitCode::kUndecided, "points", options.points,
        fmt::format("{}: expected at most {}, found {}; --max-points N allows "
                    "more, and takes exponential time",
                    options.points, report::counted(options.max_points, "point"), points.size()));
    return output.finish();
  }
  const auto all = list_all(points, options.some_points ? optimality::VertexUse::kSomePoints
                                                        : optimality::VertexUse::kAllPoints);
  if (output.wants_text()) output.text(text(*loaded, all));
  if (output.wants_json()) output.json(json(*loaded, all));
  return output.finish();
}

}  // namespace

void add_build_all_triangulations(CLI::App& build, ExitCode& exit_code) {
  const auto options = std::make_shared<AllTriangulationsOptions>();
  CLI::App* command = build.add_subcommand(
      "all-triangulations",
      "All triangulations of a small point set, with a mark on those that are Delaunay or "
      "regular");
  command->footer(
      "Example:\n"
      "  circumspect build all-triangulations cube.node\n"
      "\n"
      "Exit code 4 means that the set has more points than --max-points.");
  add_options(*command, {{"points", "", required(options->points),
                          "Points: .node, .json, .off, or Qhull's form"},
                         {"--max-points", "N", into(options->max_points, whole_number()),
                          "Refuse sets of more than N points (default 9; 0: none)"},
                         {"--some-points", "", flag(options->some_points),
                          "Also list triangulations that leave out points, as flips of weighted "
                          "triangulations do"}});
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_limit_option(*command, options->output);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace circumspect::cli
