// circumspect compare A B
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/compare/comparison.hpp"
#include "command/input/input.hpp"
#include "command/options/option_rows.hpp"
#include "command/options/threads.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/output.hpp"
#include "command/output/overwriting.hpp"
#include "command/output/picture_output.hpp"
#include "command/subcommands.hpp"
#include "kernel/exact/number.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/plane.hpp"
#include "oracle/judge/mesh_difference.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::cli {
namespace {

struct CompareOptions {
  std::string a;
  std::string b;
  std::optional<std::string> points_of_a;
  std::optional<std::string> points_of_b;
  std::string output_file;  // for what differs; empty: none
  std::string html;         // likewise, to look at
  std::size_t most = 20;    // differences of each kind that are shown; 0: all
  InputOptions input;
  OutputOptions output;
};

void report_comparison(const CompareOptions& options, const Comparison& comparison,
                       const std::vector<std::string>& notes, Output& output) {
  output.exit_with(comparison.is_same() ? ExitCode::kHolds : ExitCode::kFails);
  output.notes(notes);
  if (output.wants_text()) {
    output.text(text_of(comparison) + line_of({options.a, options.b}, comparison) + "\n");
  }
  if (output.wants_json()) output.json(json_of({options.a, options.b}, comparison, notes));
}

// The simplices that only one of the meshes has: labelled 1 those of a, 2 those of b. Requires: the
// plane or space, in both the same.
formats::ElementFile elements_of(const Mesh& a, const Mesh& b, const check::Difference& found) {
  formats::ElementFile file;
  file.points.dimension = a.dimension();
  file.points.points = a.exact_points();
  const std::vector<Point> more = b.exact_points();
  for (const Point& point : more) file.points.points.push_back(point);
  const auto add = [&file](const std::vector<Simplex>& simplices, Vertex first, Vertex label) {
    for (Simplex simplex : simplices) {
      for (Vertex& v : simplex) v += first;
      const auto shape = simplex.size() == 2   ? formats::ElementShape::kPolyline
                         : simplex.size() == 3 ? formats::ElementShape::kPolygon
                                               : formats::ElementShape::kTetrahedron;
      if (simplex.size() < 2 || simplex.size() > 4) continue;
      formats::add_element(file, shape, simplex, "", 0, label);
    }
  };
  add(found.simplices_only_in_a, 0, 1);
  add(found.simplices_only_in_b, static_cast<Vertex>(a.points()), 2);
  formats::finish_elements(file);
  return file;
}

formats::ElementWriter writer_of_difference(const std::string& path) {
  return formats::writer_of(formats::extension(path));
}

// Why the difference of these meshes is not a file for viewers; empty if it is one.
std::string dimension_fault(const std::string& path, const Mesh& a, const Mesh& b) {
  const std::size_t dimension = a.dimension();
  if (dimension == b.dimension() && dimension >= 2 && dimension <= 3) return "";
  return fmt::format(
      "{}: expected two meshes of the plane or two of space, found dimensions {} "
      "and {}: nothing else can be viewed",
      path, dimension, b.dimension());
}

// How they were read, and what ought to be known where only one has weights or they have other
// dimensions.
std::vector<std::string> notes_of(const LoadedMesh& a, const LoadedMesh& b) {
  std::vector<std::string> notes = a.notes;
  notes.insert(notes.end(), b.notes.begin(), b.notes.end());
  for (const LoadedMesh* const mesh : {&a, &b}) {
    const auto note = note_of_merging(*mesh);  // both may have one file of points
    if (note && std::find(notes.begin(), notes.end(), *note) == notes.end()) notes.push_back(*note);
  }
  if (a.mesh.is_weighted() != b.mesh.is_weighted()) {
    const bool first = a.mesh.is_weighted();
    notes.push_back(fmt::format(
        "{} has weights and {} has none; --weighted takes the first attributes of a .node file for "
        "weights",
        (first ? a : b).name, (first ? b : a).name));
  }
  if (a.mesh.points() > 0 && b.mesh.points() > 0 && a.mesh.dimension() != b.mesh.dimension()) {
    notes.push_back(
        fmt::format("{} has points of dimension {} and {} of dimension {}: no point is "
                    "in both",
                    a.name, a.mesh.dimension(), b.name, b.mesh.dimension()));
  }
  return notes;
}

// Meshes of the plane are compared there, unless one has points in space that are not in the plane
// of the other.
void settle_dimensions(LoadedMesh& a, LoadedMesh& b) {
  const auto fits = [](const LoadedMesh& one, const LoadedMesh& other) {
    return !one.height || other.mesh.points() == 0 ||
           (other.height ? other.height == one.height : other.mesh.dimension() == 2);
  };
  if (fits(a, b) && fits(b, a)) return;
  for (LoadedMesh* const mesh : {&a, &b}) {
    if (!mesh->height) continue;
    formats::put_back_height(mesh->mesh, *mesh->height);
    std::erase(mesh->notes, formats::note_of_height(mesh->points_name, *mesh->height));
    mesh->height.reset();
  }
}

InputOptions input_of(const CompareOptions& options, const std::optional<std::string>& points,
                      const char* points_option) {
  InputOptions input = options.input;
  input.points = points;
  input.points_option = points_option;
  return input;
}

// False, and said, if there are equal points and they are refused.
bool settle(LoadedMesh& input, const CompareOptions& options, Output& output) {
  const std::string fault = settle_equal_points(input, options.input.duplicates);
  if (!fault.empty()) output.error(ExitCode::kInputFault, "mesh", input.name, fault);
  return fault.empty();
}

// False, with an error, if one of the simplices that only this mesh has names a point that the file
// does not have: it cannot be compared, not even with itself.
bool names_points(const LoadedMesh& input, const std::vector<Simplex>& simplices, Output& output) {
  for (const Simplex& simplex : simplices) {
    Simplex labels = simplex;
    for (Vertex& v : labels) v = input.mesh.label(v);
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if (input.mesh.names(simplex[i])) continue;
      output.error(
          ExitCode::kInputFault, "mesh", input.name,
          fmt::format("{}: expected simplices that name points of the mesh, found simplex {}: "
                      "there is no point {}",
                      input.name, fmt::join(labels, " "), labels[i]));
      return false;
    }
  }
  return true;
}

// What is wrong with the names of the files to be written; empty if nothing is.
std::string output_fault(const CompareOptions& options) {
  std::vector<Written> written;
  if (!options.output_file.empty()) written.push_back({"what differs", options.output_file});
  if (!written.empty() && writer_of_difference(options.output_file) == nullptr) {
    return fmt::format("expected -o OUT{}, found {}",
                       fmt::join(formats::written_endings(), ", OUT"), options.output_file);
  }
  std::vector<std::string> read = files_of_mesh(options.a);
  for (std::string& path : files_of_mesh(options.b)) read.push_back(std::move(path));
  for (const auto& points : {options.points_of_a, options.points_of_b}) {
    if (points) read.push_back(*points);
  }
  return page_fault(options.html, written, read);
}

// False, and said, if the files cannot be read and written as is asked.
bool may_begin(const CompareOptions& options, Output& output) {
  if (const std::string fault = output_fault(options); !fault.empty()) {
    output.error(ExitCode::kUsage, "file",
                 options.output_file.empty() ? options.html : options.output_file, fault);
    return false;
  }
  const auto streams = (options.a == "-") + (options.b == "-") + (options.points_of_a == "-") +
                       (options.points_of_b == "-");
  if (streams <= 1) return true;
  const bool are_meshes = options.a == "-" && options.b == "-";
  output.error(ExitCode::kUsage, "mesh", "-",
               are_meshes ? "expected one mesh on standard input, found two"
                          : "expected one of the files on standard input, found several");
  return false;
}

void compare(const CompareOptions& options, Output& output) {
  if (!may_begin(options, output)) return;
  output.begin("reading " + options.a);
  auto a =
      load_mesh(options.a, input_of(options, options.points_of_a, "--points-a"), thread_count(0));
  if (!a) output.error(ExitCode::kInputFault, "mesh", options.a, a.error());
  output.begin("reading " + options.b);
  auto b =
      load_mesh(options.b, input_of(options, options.points_of_b, "--points-b"), thread_count(0));
  if (!b) output.error(ExitCode::kInputFault, "mesh", options.b, b.error());
  if (!a || !b) return;
  settle_dimensions(*a, *b);
  output.begin("comparing " + options.a + " and " + options.b);
  std::optional<check::Difference> found = check::difference(a->mesh, b->mesh);
  if (!found) {
    const bool are_settled = settle(*a, options, output) && settle(*b, options, output);
    if (!are_settled) return;
    found = check::difference(a->mesh, b->mesh);
  }
  const bool are_known = names_points(*a, found->simplices_only_in_a, output);
  if (!names_points(*b, found->simplices_only_in_b, output) || !are_known) return;
  // Whatever is to be written is made first, since an interrupt ends that at once, and what is
  // being written would stay behind, unfinished.
  formats::ElementFile elements;
  std::string fault;
  if (!options.output_file.empty()) {
    fault = dimension_fault(options.output_file, a->mesh, b->mesh);
    if (fault.empty()) elements = elements_of(a->mesh, b->mesh, found.value());
  }
  const Comparison comparison = compared(*a, *b, found.value(), options.most);
  const std::vector<std::string> notes = notes_of(*a, *b);
  picture::Page page;
  if (fault.empty() && !options.html.empty()) {
    page.add_difference(a->mesh, b->mesh, found.value(),
                        json_of({options.a, options.b}, comparison, notes),
                        line_of({options.a, options.b}, comparison));
  }
  output.end_watch();
  if (fault.empty() && !options.output_file.empty()) {
    fault = write_file(options.output_file, [&](std::ostream& out) {
      writer_of_difference(options.output_file)(out, elements);
    });
  }
  if (!fault.empty()) {
    output.error(ExitCode::kUsage, "file", options.output_file, fault);
    return;
  }
  write_page(options.html, page, output);
  report_comparison(options, comparison, notes, output);
}

}  // namespace

void add_compare(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<CompareOptions>();
  options->input.faces = true;
  options->input.listed_weights = true;
  CLI::App* command = app.add_subcommand(
      "compare", "Tell whether two meshes are the same complex, up to numbering, and what differs");
  command->footer(
      "Example:\n"
      "  circumspect build delaunay points.node -o ours.json\n"
      "  circumspect compare theirs.1.ele ours.json\n"
      "\n"
      "Points are matched by their exact coordinates and weights, and simplices as sets of\n"
      "points. The order of points, simplices and vertices means nothing. Weights are read "
      "from\n"
      "the key weights of JSON and, with --weighted, from the first attribute in a .node "
      "file; a point\n"
      "without one has weight 0. If the points are not generic, two Delaunay triangulations "
      "may differ\n"
      "and both be right; check tells whether they are.\n"
      "\n"
      "Exit codes: 0 the same, 1 different, 2 usage, 3 the input is at fault, 4 interrupted "
      "or\n"
      "stopped by --limit, 5 internal error.");
  add_options(
      *command,
      {{"a", "", required(options->a), "A mesh, in any format that check reads"},
       {"b", "", required(options->b), "The other mesh"},
       {"--points-a", "FILE", into(options->points_of_a),
        "The file with the points of the first mesh, where they are not in it or beside it"},
       {"--points-b", "FILE", into(options->points_of_b), "The same for the other mesh"},
       {"-o,--output", "OUT.vtu", into(options->output_file),
        fmt::format("Also write the simplices that only one of the meshes has, for viewers: {}. "
                    "Where the format has labels, those of A have the label 1 and those of B the "
                    "label 2; .obj and .ply have their surfaces",
                    fmt::join(formats::written_endings(), ", "))}});
  add_page_option(*command, options->html,
                  "the simplices that differ, those of A in one colour and those of B in another");
  add_options(
      *command,
      {{"--max-errors", "N", into(options->most, whole_number()),
        "Show at most N differences of each kind (default: 20; 0: all)"},
       {"--weighted", "", flag(options->input.weighted),
        "Both meshes have weights: the first attribute of a .node file, as for check --claim "
        "weighted-delaunay, or the key weights of JSON. Without this option, only the weights of "
        "JSON count"}});
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_keep_label_option(*command, options->input);
  add_allow_empty_option(*command, options->input);
  add_limit_option(*command, options->output);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] {
    Output output(options->output);
    output.watch("compare");
    compare(*options, output);
    exit_code = output.finish();
  });
}

}  // namespace circumspect::cli
