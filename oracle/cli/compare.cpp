// circumspect compare A B
#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "oracle/check/difference.hpp"
#include "oracle/cli/input.hpp"
#include "oracle/cli/output.hpp"
#include "oracle/cli/subcommands.hpp"
#include "oracle/cli/whole_number.hpp"
#include "oracle/report/wording.hpp"
#include "reference/exact/write_number.hpp"

namespace circumspect::cli {
namespace {

struct CompareOptions {
  std::string a;
  std::string b;
  std::size_t most = 20;  // differences of each kind that are shown; 0: all
  InputOptions input;
  OutputOptions output;
};

// One of the two meshes, and what the other one lacks.
struct Side {
  const std::string& name;
  const Mesh& mesh;
  const std::vector<Vertex>& points;
  const std::vector<Simplex>& simplices;
};

std::string labelled(const Mesh& mesh, const Simplex& simplex) {
  std::string text;
  for (const Vertex v : simplex) text += fmt::format(" {}", mesh.label(v));
  return text;
}

std::string coordinates_of(const Mesh& mesh, Vertex v) {
  std::string text;
  for (const Rational& x : mesh.points[v])
    text += (text.empty() ? "" : ", ") + to_text_of_double_or_fraction(x);
  if (mesh.points.is_weighted())
    text += "; weight " + to_text_of_double_or_fraction(mesh.points.weight(v));
  return text;
}

std::size_t shown(std::size_t count, std::size_t most) {
  return most == 0 ? count : std::min(count, most);
}

// "and 7 more", where not all are shown.
std::string rest(const Side& side, std::string_view what, std::size_t count, std::size_t most) {
  if (shown(count, most) == count) return "";
  return fmt::format("only in {}: {} more {}; --max-errors 0 shows all\n", side.name,
                     count - shown(count, most), what);
}

std::string text_of(const Side& side, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < shown(side.points.size(), most); ++i) {
    const Vertex v = side.points[i];
    text += fmt::format("only in {}: point {} ({})\n", side.name, side.mesh.label(v),
                        coordinates_of(side.mesh, v));
  }
  text += rest(side, "points", side.points.size(), most);
  for (std::size_t i = 0; i < shown(side.simplices.size(), most); ++i) {
    text +=
        fmt::format("only in {}: simplex{}\n", side.name, labelled(side.mesh, side.simplices[i]));
  }
  return text + rest(side, "simplices", side.simplices.size(), most);
}

report::Json json_of(const Side& side, std::size_t most) {
  report::Json points = report::Json::array();
  for (std::size_t i = 0; i < shown(side.points.size(), most); ++i) {
    const Vertex v = side.points[i];
    points.push_back(
        {{"index", side.mesh.label(v)}, {"coordinates", report::point(side.mesh.points[v])}});
  }
  report::Json simplices = report::Json::array();
  for (std::size_t i = 0; i < shown(side.simplices.size(), most); ++i) {
    Simplex labels = side.simplices[i];
    for (Vertex& v : labels) v = side.mesh.label(v);
    simplices.push_back(labels);
  }
  return {{"point_count", side.points.size()},
          {"simplex_count", side.simplices.size()},
          {"points", points},
          {"simplices", simplices}};
}

std::string counts(const Side& side) {
  return fmt::format("{} {} only in {}", report::counted(side.points.size(), "point"),
                     report::counted(side.simplices.size(), "simplex", "simplices"), side.name);
}

void compare(const CompareOptions& options, Output& output) {
  if (options.a == "-" && options.b == "-") {
    output.error(ExitCode::kUsage, "mesh", "-", "expected one mesh on standard input, found two");
    return;
  }
  const auto a = load_mesh(options.a, options.input);
  if (!a) output.error(ExitCode::kInputFault, "mesh", options.a, a.error());
  const auto b = load_mesh(options.b, options.input);
  if (!b) output.error(ExitCode::kInputFault, "mesh", options.b, b.error());
  if (!a || !b) return;
  const check::Difference found = check::difference(a->mesh, b->mesh);
  const Side only_a{options.a, a->mesh, found.points_only_in_a, found.simplices_only_in_a};
  const Side only_b{options.b, b->mesh, found.points_only_in_b, found.simplices_only_in_b};
  output.exit_with(found.empty() ? ExitCode::kHolds : ExitCode::kFails);
  if (output.wants_text()) {
    output.text(text_of(only_a, options.most) + text_of(only_b, options.most));
    output.text(found.empty()
                    ? fmt::format("same: {} {} {} {}\n", options.a, options.b,
                                  report::counted(a->mesh.points.size(), "point"),
                                  report::counted(a->mesh.simplices.size(), "simplex", "simplices"))
                    : fmt::format("differ: {}, {}\n", counts(only_a), counts(only_b)));
  }
  if (output.wants_json()) {
    output.json({{"a", options.a},
                 {"b", options.b},
                 {"same", found.empty()},
                 {"only_in_a", json_of(only_a, options.most)},
                 {"only_in_b", json_of(only_b, options.most)}});
  }
}

}  // namespace

void add_compare(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<CompareOptions>();
  options->input.faces = true;
  CLI::App* command = app.add_subcommand(
      "compare", "Are two meshes the same complex, up to numbering? If not, what differs");
  command->footer(
      "Example:\n"
      "  circumspect build delaunay points.node -o ours.json\n"
      "  circumspect compare theirs.1.ele ours.json\n\n"
      "Points are matched by their exact coordinates (and weights), simplices as sets of points; "
      "the\n"
      "order of points, simplices and vertices means nothing. Two Delaunay triangulations of "
      "points\n"
      "that are not generic may differ and both be right: `check` tells.\n\n"
      "Exit codes: 0 the same, 1 different, 2 usage, 3 the input is at fault, 5 internal error.");
  command->add_option("a", options->a, "A mesh, in any format that check reads")->required();
  command->add_option("b", options->b, "Another")->required();
  command
      ->add_option("--max-errors", options->most,
                   "How many differences of each kind are shown (default 20; 0: all)")
      ->check(whole_number())
      ->option_text("N");
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_allow_empty_option(*command, options->input);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] {
    Output output(options->output);
    compare(*options, output);
    exit_code = output.finish();
  });
}

}  // namespace circumspect::cli
