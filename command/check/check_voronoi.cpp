#include "command/check/check_voronoi.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/number_list.hpp"
#include "command/options/option_rows.hpp"
#include "oracle/formats/bytes/packed.hpp"
#include "oracle/formats/voronoi_file.hpp"
#include "oracle/judge/voronoi/judge_structure.hpp"
#include "oracle/judge/voronoi/judge_voronoi.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

struct LoadedDiagram {
  VoronoiDiagram diagram;
  Mesh sites;  // for the names of the sites
};

tl::expected<LoadedDiagram, std::string> load_diagram(const std::string& path,
                                                      const InputOptions& input) {
  const auto source = formats::load_unpacked(path);
  if (!source) return tl::unexpected(source.error().to_string());
  auto file = formats::read_voronoi(*source, input.coordinates);
  if (!file) return tl::unexpected(file.error().to_string());
  auto sites = load_points(*input.points, input);
  if (!sites) return tl::unexpected(sites.error());
  LoadedDiagram loaded{{sites->mesh.points}, in_rows(sites->mesh)};
  if (file->dimension != loaded.diagram.sites.ambient_dimension()) {
    return tl::unexpected(fmt::format("{}: expected dimension {}, as that of the sites, found {}",
                                      path, loaded.diagram.sites.ambient_dimension(),
                                      file->dimension));
  }
  loaded.diagram.vertices = std::move(file->vertices);
  loaded.diagram.cells = std::move(file->cells);
  loaded.diagram.neighbors = std::move(file->neighbors);
  loaded.diagram.ridges = std::move(file->ridges);
  return loaded;
}

// "0,0,1,1": the least coordinates, then the largest.
std::optional<JudgedBox> box_of(const std::string& text) {
  const auto numbers = number_list(text);
  if (!numbers) return std::nullopt;
  const auto half = static_cast<std::ptrdiff_t>(numbers->size() / 2);
  if (numbers->size() % 2 != 0 || half < 2) return std::nullopt;
  JudgedBox box{{numbers->begin(), numbers->begin() + half},
                {numbers->begin() + half, numbers->end()}};
  for (std::size_t axis = 0; axis < box.low.size(); ++axis) {
    if (box.low[axis] >= box.high[axis]) return std::nullopt;
  }
  return box;
}

}  // namespace

void add_box_option(CLI::App& command, std::optional<JudgedBox>& box) {
  const auto read = [&box](const std::string& text) {
    box = box_of(text);
    if (box) return std::string();
    return fmt::format("expected X0,Y0,X1,Y1 or X0,Y0,Z0,X1,Y1,Z1 with X0 < X1 and so on, found {}",
                       text);
  };
  add_options(command, {{"--box", "X0,Y0,X1,Y1", read_by(read),
                         "With the claim voronoi: compare cells within this box (default: that of "
                         "the sites, enlarged on each side by half its longest edge). With the "
                         "claim periodic-delaunay: the box that the mesh repeats"}});
}

void check_voronoi(const std::string& path, const VoronoiQuestion& question, Pictures& pictures,
                   Output& output) {
  output.begin("reading " + path);
  auto loaded = load_diagram(path, question.input);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "mesh", path, loaded.error());
    return;
  }
  std::string fault = check::fault_of_diagram(loaded->diagram, question.box);
  if (fault.empty() && question.check.structure) fault = check::fault_of_structure(loaded->diagram);
  if (!fault.empty()) {
    output.error(ExitCode::kInputFault, "mesh", path, path + ": " + fault);
    return;
  }
  output.begin("judging " + path);
  const Distance distance = question.within.value_or(Distance{});
  const Verdict verdict = check::judge_voronoi(
      loaded->diagram, question.box, distance.squared(loaded->diagram.sites.points()),
      question.check.by == check::By::kDefinition, question.check.max_violations,
      question.check.structure);
  output.exit_with(verdict.holds() ? ExitCode::kHolds : ExitCode::kFails);
  if (output.wants_text()) {
    output.text(report::explanation(verdict, loaded->sites));
    output.text(report::verdict_line(verdict, loaded->sites, path) + "\n");
  }
  if (!output.wants_results() && !pictures.are_wanted()) return;
  report::Json result = report::verdict(verdict, loaded->sites, path, question.check.by);
  if (pictures.are_wanted()) {
    pictures.add(verdict, loaded->sites, path, result, nullptr, {}, output);
  }
  if (output.wants_results()) output.json(std::move(result));
}

}  // namespace circumspect::cli
