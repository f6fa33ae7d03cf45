// circumspect build planar-cdt|cdt|steiner-cdt|conforming-delaunay INPUT
#include <algorithm>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/build/constrained_constructions.hpp"
#include "command/build/domain_mesh_output.hpp"
#include "command/build/mesh_output.hpp"
#include "command/build/steps.hpp"
#include "command/input/breach_text.hpp"
#include "command/input/domain_input.hpp"
#include "command/options/option_rows.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/output.hpp"
#include "command/output/picture_output.hpp"
#include "command/subcommands.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"

namespace circumspect::cli {
namespace {

struct ConstrainedOptions {
  std::string what;
  std::string input_file;
  std::string output_file;
  std::string html;  // the steps, to look at; empty: none
  std::optional<std::string> algorithm;
  DomainOptions said;  // of the domain
  SearchLimits search;
  std::size_t most_steiner_points = 10'000;
  InputOptions input;
  OutputOptions output;
};

// What is wrong with the algorithm asked for; empty if nothing is.
std::string algorithm_fault(const ConstrainedOptions& options, std::size_t dimension) {
  if (!options.algorithm) return "";
  const std::vector<std::string> known = algorithms_for(options.what, dimension);
  if (std::find(known.begin(), known.end(), *options.algorithm) != known.end()) return "";
  return fmt::format("expected --algorithm {} for {} in dimension {}, found {}",
                     fmt::join(known, "|"), options.what, dimension, *options.algorithm);
}

bool has_steiner_points(const std::string& what) {
  return what == "steiner-cdt" || what == "conforming-delaunay";
}

std::string built_line(const ConstrainedOptions& options, const DomainMesh& mesh) {
  const auto& simplices = mesh.triangulation.simplices;
  const std::size_t size =
      simplices.empty() ? mesh.points.ambient_dimension() + 1 : simplices.front().size();
  std::string line =
      fmt::format("built: {} {} {} {}", options.what, on_one_line(options.input_file),
                  report::counted(mesh.points.size(), "point"),
                  report::counted_simplices(simplices.size(), static_cast<int>(size) - 1));
  // Vertices that belong to nothing are among the points.
  const auto dangling =
      std::count_if(mesh.triangulation.dangling.begin(), mesh.triangulation.dangling.end(),
                    [](const Simplex& simplex) { return simplex.size() > 1; });
  if (dangling > 0) line += fmt::format(" {} dangling", dangling);
  if (has_steiner_points(options.what)) {
    return line + " " + report::counted(mesh.steiner_points.size(), "steiner-point") + "\n";
  }
  return line + (mesh.not_canonical ? " not-canonical\n" : " canonical\n");
}

// "steiner point 9 on segment 1 2 at (0.5, 0, 0)", a line each.
std::string steiner_text(const DomainMesh& mesh, Vertex first_index) {
  const auto count = static_cast<Vertex>(mesh.steiner_points.size());
  const auto first = static_cast<Vertex>(mesh.points.size()) - count;
  std::string text;
  for (Vertex i = 0; i < count; ++i) {
    text += fmt::format("steiner point {} {} at {}\n", first + i + first_index,
                        mesh.steiner_points[static_cast<std::size_t>(i)],
                        point_text(mesh.as_given(first + i)));
  }
  return text;
}

// Exit code 1: there is none; 4: this algorithm cannot tell.
void say_no_mesh(const ConstrainedOptions& options, const NoMesh& none, Output& output) {
  output.exit_with(none.is_proved ? ExitCode::kFails : ExitCode::kUndecided);
  const std::string answer = none.is_proved ? "impossible" : "undecided";
  output.text(fmt::format("{}: {} {}: {}\n", answer, options.what, on_one_line(options.input_file),
                          none.reason));
  if (output.wants_json()) {
    output.json({{"domain", options.input_file},
                 {"what", options.what},
                 {"answer", answer},
                 {"reason", none.reason}});
  }
}

// Writes the files asked for. Returns an error message, or an empty string.
std::string write(const ConstrainedOptions& options, const std::string& points_name,
                  const DomainMesh& mesh, Vertex first_index) {
  std::vector<Written> written;
  if (!options.output_file.empty()) {
    for (const std::string& path : files_of_domain_mesh(options.output_file, mesh)) {
      written.push_back({"the mesh", path});
    }
  }
  std::string fault = page_fault(options.html, written, {options.input_file, points_name});
  if (options.output_file.empty()) return fault;
  if (fault.empty()) fault = domain_mesh_fault(options.output_file, mesh);
  return fault.empty() ? write_domain_mesh(options.output_file, mesh, first_index) : fault;
}

// How flips insert the polygons into the Delaunay triangulation of the vertices. Book: Section 5.8.
void add_polygon_flips(const Domain& domain, Steps& steps) {
  std::vector<constrained::PolygonFlips> runs;
  const auto cdt = constrained::cdt_by_polygon_insertion(domain.complex, {}, &runs);
  steps.begun(delaunay::bowyer_watson(domain.complex.points).simplices(),
              "It begins with the Delaunay triangulation of the vertices.");
  for (std::size_t polygon = 0; polygon < runs.size(); ++polygon) {
    for (const constrained::TimedFlip& flip : runs[polygon].flips) {
      steps.flipped(domain.polygon_name(polygon), flip);
    }
  }
}

void write_steps(const ConstrainedOptions& options, const Domain& domain, const DomainMesh& mesh,
                 const std::string& text, Output& output) {
  const ExactMesh points{mesh.points, {}, {}, domain.first_index};
  picture::Facts facts;
  facts.heading = options.input_file;
  const std::size_t last = text.rfind('\n', text.size() - 2);
  const std::size_t end = last == std::string::npos ? 0 : last + 1;
  facts.line = text.substr(end, text.size() - end - 1);
  facts.text = text.substr(0, end);
  if (mesh.points.size() <= kMostStepPoints) {
    Steps steps(points);
    const bool by_flips = options.what == "cdt" && options.algorithm == "polygon-flips";
    if (by_flips && domain.complex.ambient_dimension() == 3) add_polygon_flips(domain, steps);
    steps.done(mesh.triangulation.simplices);
    facts.steps = steps.json();
  } else {
    facts.text += fmt::format("steps: none are shown of more than {} points\n", kMostStepPoints);
  }
  picture::Page page;
  page.add_facts(std::move(facts), {});
  write_page(options.html, page, output);
}

// Standard output holds the mesh alone, as a JSON document or, for "-", as an .ele.
void say_note(const ConstrainedOptions& options, const std::string& note, Output& output) {
  if (output.wants_json() || (options.output_file == "-" && !options.output.quiet)) {
    say("note: " + on_one_line(note) + "\n");
  }
  output.note(note);
}

void build(const ConstrainedOptions& options, Output& output) {
  output.begin("reading " + options.input_file);
  const auto loaded = load_domain(options.input_file, options.input, options.said, kBreachLimit,
                                  Leak::kRefused, {.progress = output.progress()});
  if (!loaded) {
    for (const std::string& note : loaded.error().file.notes) say_note(options, note, output);
    output.error(ExitCode::kInputFault, "domain", options.input_file, loaded.error().message);
    return;
  }
  for (const std::string& note : loaded->file.notes) say_note(options, note, output);
  const Domain& domain = loaded->domain;
  const std::string fault = algorithm_fault(options, domain.complex.ambient_dimension());
  if (!fault.empty()) {
    output.error(ExitCode::kUsage, "domain", options.input_file, fault);
    return;
  }
  auto mesh =
      construct({options.what, options.algorithm, options.search, options.most_steiner_points},
                domain, options.input_file, output);
  output.end_watch();
  if (!mesh) {
    say_no_mesh(options, mesh.error(), output);
    return;
  }
  if (loaded->file.flat) mesh->height = loaded->file.flat->height;
  if (const std::string full = numbering_fault(*mesh, domain.first_index); !full.empty()) {
    output.error(ExitCode::kInputFault, "domain", options.input_file,
                 options.input_file + ": " + full);
    return;
  }
  if (!options.output_file.empty() || !options.html.empty()) {
    const std::string failure = write(options, loaded->file.points_name, *mesh, domain.first_index);
    if (!failure.empty()) {
      output.error(ExitCode::kUsage, "domain", options.input_file, failure);
      return;
    }
  }
  if (mesh->not_canonical) {
    say_note(options,
             "there is no canonical CDT, for " + *mesh->not_canonical + "; this is another one",
             output);
  }
  if (output.wants_json()) {
    formats::write_json(std::cout, json_file(*mesh, domain.first_index));
  }
  const std::string text = steiner_text(*mesh, domain.first_index) + built_line(options, *mesh);
  output.text(text);
  if (!options.html.empty()) write_steps(options, domain, *mesh, text, output);
}

ExitCode run(const ConstrainedOptions& options) {
  if (const std::string fault = domain_options_fault(options.said); !fault.empty()) {
    return usage_error(fault);
  }
  const bool to_json = options.output.format == OutputFormat::kJson;
  if (options.output_file.empty() && options.html.empty() && !to_json) {
    return usage_error(fmt::format("expected -o OUT{}, --format json or --html FILE, found none",
                                   fmt::join(endings_of_domain_meshes(), ", OUT")));
  }
  const std::string name_fault = output_name_fault(options.output_file, endings_of_domain_meshes());
  if (!options.output_file.empty() && !name_fault.empty()) {
    return usage_error(name_fault);
  }
  if (options.output_file == "-" && to_json) {
    return usage_error("expected one thing for standard output, found two");
  }
  OutputOptions spoken = options.output;
  if (options.output_file == "-") spoken.quiet = true;
  Output output(spoken);
  output.watch("build");
  build(options, output);
  // Where the mesh is the JSON document, only an error needs another one.
  return output.exit_code() == ExitCode::kHolds ? ExitCode::kHolds : output.finish();
}

std::string usual_algorithm(const std::string& what) {
  if (what == "planar-cdt") return "gift-wrapping";
  if (what == "steiner-cdt") return "polygon-flips; in the plane, gift-wrapping";
  return fmt::format("gift-wrapping; for more than {} vertices in space, polygon-flips",
                     reference::kFewVertices);
}

const std::string kOfPolygons =
    "The mesh of a domain in the plane is its CDT. The mesh of a domain in space has only the\n"
    "triangles of its polygons and the segments in none of them. That is a CDT of the domain only\n"
    "if nothing is to be filled, because all of the domain lies in one plane.\n\n";

const std::string kOfAnother =
    "If vertices are cospherical, a domain may have no canonical CDT, but another one. "
    "Without\n"
    "--algorithm, build cdt then makes that one, and calls it not-canonical. Exit code 1 "
    "means that\n"
    "there is no CDT, which is proved. A search that reaches its limit ends with exit code "
    "4.\n"
    "\n";

std::string footer(const std::string& what) {
  const bool is_planar = what == "planar-cdt";
  const std::string part = is_planar ? "plan" : "part";
  return fmt::format(
      "Example:\n"
      "  circumspect build {0} {1}.poly -o {1}.1.ele\n"
      "  circumspect check {1}.1.ele --domain {1}.poly --claim {2}\n"
      "\n"
      "{3}OUT.ele has the simplices and OUT.node the points, of which Steiner points come "
      "last. OUT.face\n"
      "and OUT.edge have the dangling triangles and edges, which are faces of no larger "
      "simplex.\n"
      "OUT.mesh, OUT.msh, OUT.vtu and OUT.json have all of this in one file. OUT.obj and "
      "OUT.ply have\n"
      "the surface: the boundary, and the dangling triangles and edges.\n"
      "\n"
      "Exit codes: 0 built, {4}2 usage,\n"
      "3 the input is at fault, 4 a limit was reached or this algorithm cannot tell, 5 "
      "internal error.",
      what, part, is_planar ? "cdt" : what,
      is_planar       ? kOfPolygons
      : what == "cdt" ? kOfAnother
                      : "",
      what == "cdt" ? "1 there is no CDT, and the output says why, " : "");
}

void add_one(CLI::App& build, const std::string& what, const std::string& description,
             const std::string& algorithms, ExitCode& exit_code) {
  const auto options = std::make_shared<ConstrainedOptions>();
  options->what = what;
  CLI::App* command = build.add_subcommand(what, description);
  command->footer(footer(what));
  add_options(
      *command,
      {{"domain", "", required(options->input_file),
        "The domain: .poly, .smesh, .off, .stl, .ply, .obj, .mesh, .msh, .vtk, .vtu, .vtp"},
       {"-o,--output", "OUT.ele", into(options->output_file),
        fmt::format("The file to write: {}; .obj and .ply have the surface, for viewers. - writes "
                    "the .ele to stdout, if there are neither dangling faces nor Steiner points",
                    fmt::join(endings_of_domain_meshes(), ", "))}});
  if (!algorithms.empty()) {
    add_options(*command, {{"--algorithm", algorithms, into(options->algorithm),
                            "The algorithm. All that succeed make the same mesh, the canonical "
                            "one (default: " +
                                usual_algorithm(what) + ")"}});
  }
  add_page_option(
      *command, options->html,
      what == "cdt" ? "the mesh and, if it has few points, how polygon-flips makes it step by step"
                    : "the mesh, if it has few points");
  if (what == "cdt") add_search_options(*command, options->search);
  if (has_steiner_points(what)) {
    add_options(*command,
                {{"--steiner-points", "N", into(options->most_steiner_points, whole_number()),
                  "Give up, with exit code 4, when more than N are needed (default: 10000)"}});
  }
  add_domain_options(*command, options->said);
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_limit_option(*command, options->output);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace

void add_build_constrained(CLI::App& build, ExitCode& exit_code) {
  add_one(build, "planar-cdt",
          "The canonical constrained Delaunay triangulation of a domain in the plane, or of each "
          "polygon of a domain in space",
          "gift-wrapping|segment-insertion", exit_code);
  add_one(build, "cdt",
          "The canonical constrained Delaunay triangulation of a domain without Steiner points, "
          "or another one if there is no canonical one",
          "gift-wrapping|polygon-flips|polygon-cavities (in the plane gift-wrapping|"
          "segment-insertion)",
          exit_code);
  add_one(build, "steiner-cdt",
          "A Steiner CDT of any domain: the canonical CDT of the domain with Steiner points on "
          "its segments, which make it edge-protected",
          "gift-wrapping|polygon-flips|polygon-cavities (in the plane gift-wrapping|"
          "segment-insertion)",
          exit_code);
  add_one(build, "conforming-delaunay",
          "A Delaunay triangulation of the domain's vertices and of Steiner points in which every "
          "segment and every polygon is a union of faces",
          "", exit_code);
}

}  // namespace circumspect::cli
