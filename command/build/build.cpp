// circumspect build WHAT INPUT: one triangulation. What is more than that has files of its own.
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/build/mesh_output.hpp"
#include "command/build/point_constructions.hpp"
#include "command/input/input.hpp"
#include "command/options/one_of.hpp"
#include "command/options/option_rows.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/expected_time.hpp"
#include "command/output/output.hpp"
#include "command/output/picture_output.hpp"
#include "command/subcommands.hpp"
#include "construct/delaunay.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"
#include "reference/delaunay/genericity.hpp"
#include "reference/delaunay/lexicographic.hpp"

namespace circumspect::cli {
namespace {

struct BuildOptions {
  std::string what;  // delaunay, weighted-delaunay, lexicographic
  std::string points;
  std::string output_file;
  std::string neighbors_file;
  std::string html;            // the steps and the numbers, to look at; empty: none
  std::string algorithm = {};  // of the book; empty: none was asked for
  delaunay::BowyerWatsonOptions bowyer_watson = {delaunay::InsertionOrder::kBrioHilbert,
                                                 delaunay::PointLocation::kWalking, 0};
  bool statistics = false;
  bool is_about_insertion = false;  // --order, --location or --seed is given
  InputOptions input;
  OutputOptions output;
};

constexpr std::string_view kByInsertion = "bowyer-watson";

std::string algorithm_of_the_book(const BuildOptions& options) {
  return options.algorithm.empty() ? std::string(kByInsertion) : options.algorithm;
}

std::string statistics_text(const BuildOptions& options, const delaunay::Statistics& statistics) {
  if (options.what == "lexicographic" || algorithm_of_the_book(options) != kByInsertion) {
    return "statistics: counted by --algorithm bowyer-watson alone\n";
  }
  return fmt::format(
      "created: {} solid and {} ghost simplices\n"
      "deleted: {} solid and {} ghost simplices\n"
      "point location: {} filed, {}\n"
      "conflict tests: {}\n",
      statistics.solid_simplices_created, statistics.ghost_simplices_created,
      statistics.solid_simplices_deleted, statistics.ghost_simplices_deleted,
      report::counted(statistics.conflicts_created, "conflict"),
      report::counted(statistics.walk_steps, "walk step"), statistics.conflict_tests);
}

// A triangulation whose simplices are those of the mesh, and what is known of it.
struct Built {
  int dimension = -1;
  std::optional<bool> is_unique = {};  // of a Delaunay triangulation
  report::Json steps = {};             // how it was made, if that was asked
};

// The points of a weighted set that are not vertices: submerged, or on the lower hull without being
// extreme.
std::string not_vertices_text(const Mesh& mesh) {
  std::vector<bool> is_used(mesh.points());
  mesh.simplices.visit([&]<class Lists>(const Lists& lists) {
    if constexpr (!std::is_same_v<Lists, std::vector<Simplex>>) {
      for (const auto v : lists.values()) is_used[static_cast<std::size_t>(v)] = true;
    }
  });
  std::vector<Vertex> unused;
  for (Vertex v = 0; mesh.names(v); ++v) {
    if (!is_used[static_cast<std::size_t>(v)]) unused.push_back(v);
  }
  return unused.empty() ? "" : "not vertices: " + report::labels(mesh, unused) + "\n";
}

// "unique canonical" and the like: what is known of the triangulation beside its size.
std::string facts(const Built& built) {
  if (!built.is_unique) return "";
  return *built.is_unique ? " unique canonical" : " not-unique canonical";
}

// By the fast construction; nothing if it leaves the points to the book.
std::optional<Built> build_fast(const BuildOptions& options, Mesh& mesh, Output& output) {
  output.begin("triangulating " + options.points);
  auto fast = construct::canonical_delaunay(mesh.coordinates, mesh.weights, output.progress());
  if (!fast) return std::nullopt;
  const bool is_unique = fast->is_unique;
  mesh.simplices = IndexLists(std::move(fast->simplices));
  return Built{static_cast<int>(mesh.dimension()), is_unique};
}

Triangulation construct_triangulation(const BuildOptions& options, const PointSet& points,
                                      const Progress& progress, delaunay::Statistics& statistics,
                                      Steps* steps) {
  if (options.what == "lexicographic") return delaunay::lexicographic(points);
  delaunay::BowyerWatsonOptions how = options.bowyer_watson;
  how.progress = progress;
  return constructions().at(algorithm_of_the_book(options))(points, {how, &statistics, steps});
}

Built build_by_the_book(const BuildOptions& options, Mesh& mesh, bool has_steps,
                        delaunay::Statistics& statistics, Output& output) {
  const ExactMesh exact_mesh = exact(mesh);
  const PointSet& points = exact_mesh.points;
  output.begin("triangulating " + options.points,
               seconds_of_triangulating(points.size(), points.dimension()));
  Steps steps(exact_mesh);
  const Triangulation triangulation = construct_triangulation(
      options, points, output.progress(), statistics, has_steps ? &steps : nullptr);
  std::vector<Simplex> simplices = triangulation.simplices();
  for (Simplex& simplex : simplices) simplex = positively_oriented(points, std::move(simplex));
  mesh.simplices = IndexLists(std::move(simplices));
  Built built{triangulation.dimension()};
  if (options.what == "delaunay") {
    built.is_unique = !delaunay::cospherical_points_of_an_empty_ball(points, triangulation);
  } else if (options.what == "weighted-delaunay") {
    built.is_unique =
        check::judge_points(Claim::kWeightedDelaunay, {points, triangulation.simplices()}).unique;
  }
  if (has_steps) {
    steps.done(triangulation.simplices());
    built.steps = steps.json();
  }
  return built;
}

// Writes the files asked for; false if one could not be written.
bool write_files(const BuildOptions& options, const LoadedMesh& loaded, Output& output) {
  const Mesh& mesh = loaded.mesh;
  const auto write_mesh = [&](std::ostream& stream) {
    if (formats::extension(options.output_file) == ".json") {
      formats::write_json(stream, json_file(mesh));
    } else {
      formats::write_ele(stream, simplex_file(mesh));
    }
  };
  const auto write = [&](const std::string& path, const auto& writer) {
    if (path.empty()) return true;
    const std::string failure = write_file(path, writer);
    if (!failure.empty()) output.error(ExitCode::kUsage, "points", options.points, failure);
    return failure.empty();
  };
  return write(options.output_file, write_mesh) &&
         write(points_beside(options.output_file, options.points),
               [&](std::ostream& stream) {
                 formats::write_node(stream, point_file(mesh, loaded.merged));
               }) &&
         write(options.neighbors_file,
               [&](std::ostream& stream) { formats::write_neigh(stream, neighbor_file(mesh)); });
}

void build_triangulation(const BuildOptions& options, Output& output) {
  output.begin("reading " + options.points);
  auto loaded = load_point_rows(options.points, options.input);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "points", options.points, loaded.error());
    return;
  }
  output.notes(loaded->notes);
  if (const auto merging = note_of_merging(*loaded)) output.notes({*merging});
  Mesh& mesh = loaded->mesh;
  const bool has_steps = !options.html.empty() && mesh.points() <= kMostStepPoints;
  const bool asks_the_book = has_steps || options.what == "lexicographic" || options.statistics ||
                             options.is_about_insertion || !options.algorithm.empty();
  delaunay::Statistics statistics;
  std::optional<Built> built;
  if (!asks_the_book) built = build_fast(options, mesh, output);
  if (!built) built = build_by_the_book(options, mesh, has_steps, statistics, output);
  output.end_watch();
  if (!write_files(options, *loaded, output)) return;
  if (output.wants_json()) formats::write_json(std::cout, json_file(mesh));
  if (!output.wants_text() && options.html.empty()) return;
  picture::Facts told;
  told.heading = loaded->name;
  if (options.statistics) told.text += statistics_text(options, statistics);
  if (mesh.is_weighted()) told.text += not_vertices_text(mesh);
  told.line = fmt::format("built: {} {} {} {}{}", options.what, on_one_line(loaded->name),
                          report::counted(mesh.points(), "point"),
                          report::counted_simplices(mesh.simplices.size(), built->dimension),
                          facts(*built));
  output.text(told.text + told.line + "\n");
  if (options.html.empty()) return;
  if (has_steps) {
    told.steps = std::move(built->steps);
  } else {
    told.text += fmt::format("steps: none are shown of more than {} points\n", kMostStepPoints);
  }
  picture::Page page;
  page.add_facts(std::move(told), {});
  write_page(options.html, page, output);
}

// What is wrong with the names of the files that are to be written; empty if nothing is.
std::string output_fault(const BuildOptions& options) {
  std::vector<Written> written;
  if (!options.output_file.empty()) written.push_back({"the mesh", options.output_file});
  const std::string points = points_beside(options.output_file, options.points);
  if (!points.empty()) written.push_back({"the points", points});
  if (!options.neighbors_file.empty()) {
    written.push_back({"the neighbours", options.neighbors_file});
  }
  std::string fault = page_fault(options.html, written, {options.points});
  if (!fault.empty() || options.output_file.empty()) return fault;
  return output_name_fault(options.output_file, {".ele", ".json"});
}

ExitCode run(const BuildOptions& options) {
  if (options.output_file.empty() && options.html.empty() &&
      options.output.format == OutputFormat::kText) {
    return usage_error(
        "expected -o OUT.ele, -o OUT.json, --format json or --html FILE, found none");
  }
  if (const std::string fault = output_fault(options); !fault.empty()) {
    return usage_error(fault);
  }
  const int on_stdout = (options.output_file == "-" ? 1 : 0) +
                        (options.neighbors_file == "-" ? 1 : 0) +
                        (options.output.format == OutputFormat::kJson ? 1 : 0);
  if (on_stdout > 1) {
    return usage_error(fmt::format(
        "expected one thing for standard output, found {} of -o -, --neighbors - and --format json",
        on_stdout));
  }
  OutputOptions spoken = options.output;
  // The mesh itself goes to stdout: then nothing else does.
  if (options.output_file == "-" || options.neighbors_file == "-") spoken.quiet = true;
  Output output(spoken);
  output.watch("build");
  build_triangulation(options, output);
  // Where the mesh is the JSON document, only an error needs another one.
  return output.exit_code() == ExitCode::kHolds ? ExitCode::kHolds : output.finish();
}

void add_algorithm_options(CLI::App& command, BuildOptions& options) {
  using delaunay::InsertionOrder;
  using delaunay::PointLocation;
  std::vector<std::string> names;
  for (const auto& [name, construction] : constructions()) names.push_back(name);
  const std::map<std::string, InsertionOrder> orders = {
      {"as-given", InsertionOrder::kAsGiven},
      {"random", InsertionOrder::kRandom},
      {"brio-hilbert", InsertionOrder::kBrioHilbert},
      {"brio-z-order", InsertionOrder::kBrioZOrder}};
  const std::map<std::string, PointLocation> locations = {
      {"linear-scan", PointLocation::kLinearScan},
      {"conflict-graph", PointLocation::kConflictGraph},
      {"walking", PointLocation::kWalking}};
  add_options(command,
              {{"--algorithm", construction_names(), into(options.algorithm, one_of_words(names)),
                "One of the book's algorithms. All make the same set of simplices, and so does the "
                "default, a fast construction whose answer is proved; bowyer-watson makes what it "
                "cannot: points of a flat or of other dimensions than 2 and 3, and numbers that "
                "are not doubles"},
               {"--order", "as-given|random|brio-hilbert|brio-z-order",
                into(options.bowyer_watson.order, one_of(orders)),
                "The order in which Bowyer-Watson inserts points (default: brio-hilbert)"},
               {"--location", "linear-scan|conflict-graph|walking",
                into(options.bowyer_watson.location, one_of(locations)),
                "How Bowyer-Watson locates points (default: walking)"},
               {"--seed", "N", into(options.bowyer_watson.seed, whole_number()),
                "The seed of the random orders (default: 0)"},
               {"--statistics", "", flag(options.statistics),
                "Print how many simplices Bowyer-Watson created and deleted, and how many steps "
                "and tests it took"}});
}

CLI::App* add_triangulation(CLI::App& build, const std::string& what,
                            const std::string& description, ExitCode& exit_code) {
  const auto options = std::make_shared<BuildOptions>();
  options->what = what;
  options->input.weighted = what == "weighted-delaunay";
  CLI::App* command = build.add_subcommand(what, description);
  command->footer(fmt::format(
      "Example:\n"
      "  circumspect build {} points.node -o reference.ele\n\n"
      "Each line is a simplex of k+1 vertices, where k is the dimension of the points' "
      "affine hull.\n"
      "Simplices are positively oriented, and indices are those of the input. The points are\n"
      "written to the .node beside the .ele, unless they come from there.",
      what));
  add_options(*command, {{"points", "", required(options->points),
                          "Points: .node, .json, .off, .xyz, .csv, .ply, or Qhull's form"},
                         {"-o,--output", "OUT.ele", into(options->output_file),
                          "The file to write: .ele or .json; - writes the .ele to stdout"},
                         {"--neighbors", "OUT.neigh", into(options->neighbors_file),
                          "Also write the .neigh file"}});
  if (what != "lexicographic") add_algorithm_options(*command, *options);
  const std::string steps =
      what == "lexicographic"
          ? "the triangulation, if it has few points"
          : "the triangulation and, if it has few points, how the algorithm makes it step by step";
  add_page_option(*command, options->html, steps);
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_dimension_option(*command, options->input);
  add_limit_option(*command, options->output);
  add_output_options(*command, options->output);
  command->callback([options, command, &exit_code] {
    for (const char* const name : {"--order", "--location", "--seed"}) {
      const CLI::Option* const option = command->get_option_no_throw(name);
      if (option != nullptr && option->count() > 0) options->is_about_insertion = true;
    }
    exit_code = run(*options);
  });
  return command;
}

}  // namespace

void add_build(CLI::App& app, ExitCode& exit_code) {
  CLI::App* build =
      app.add_subcommand("build", "Build a reference triangulation of points or of a domain");
  build->footer(
      "Examples:\n"
      "  circumspect build delaunay points.node -o reference.ele\n"
      "  circumspect build cdt part.poly -o part.1.ele\n"
      "  circumspect build cdt --help            # options, input and output of cdt\n"
      "\n"
      "Exit codes: 0 built, 1 the domain has no such triangulation, and the output says why, "
      "2 usage,\n"
      "3 the input is at fault, 4 not found within a limit or by this algorithm, 5 internal "
      "error.");
  build->require_subcommand(1);
  add_triangulation(*build, "delaunay",
                    "The canonical Delaunay triangulation of a point set of any dimension",
                    exit_code);
  add_triangulation(*build, "weighted-delaunay",
                    "The canonical weighted Delaunay triangulation; weights are the first "
                    "attribute of a .node file, as for tetgen -w, or the key weights of JSON",
                    exit_code);
  add_triangulation(*build, "lexicographic",
                    "The lexicographic triangulation, which is not Delaunay in general", exit_code);
  add_build_subdivision(*build, exit_code);
  add_build_voronoi(*build, exit_code);
  add_build_all_triangulations(*build, exit_code);
  add_build_constrained(*build, exit_code);
}

}  // namespace circumspect::cli
