// circumspect inspect INPUT
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/input/input.hpp"
#include "command/inspect/inspect_counts.hpp"
#include "command/inspect/inspect_domain.hpp"
#include "command/inspect/inspect_simplex.hpp"
#include "command/inspect/refutation_files.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/output.hpp"
#include "command/output/overwriting.hpp"
#include "command/subcommands.hpp"
#include "oracle/formats/domain_files.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/wording.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/genericity.hpp"
#include "reference/kernel/complex/circumball.hpp"
#include "reference/kernel/exact/number_text.hpp"

namespace circumspect::cli {
namespace {

struct InspectOptions {
  std::vector<std::string> inputs;
  std::size_t subsets = 200'000;
  std::vector<std::string> simplices;  // "1 2 3", by the user's indices
  DomainInspection domain;
  InputOptions input;
  OutputOptions output;
};

// What Definition 4.2 says of a set, as far as it was looked at.
struct Genericity {
  enum class Answer { kGeneric, kNotGeneric, kUndecided } answer;
  Simplex cospherical = {};  // k+2 points on one sphere, if not generic
  bool unique = true;        // is there only one Delaunay triangulation?
};

// (n choose r), or `cap` if that is less.
std::size_t binomial(std::size_t n, std::size_t r, std::size_t cap) {
  if (r > n) return 0;
  std::size_t result = 1;
  for (std::size_t i = 1; i <= r; ++i) {
    result = result * (n - r + i) / i;
    if (result > cap) return cap;
  }
  return result;
}

// An empty ball with k+2 points on it is found from the Delaunay triangulation, whatever the size of
// the set; the other balls take a look at every (k+2)-subset.
Genericity genericity(const PointSet& points, const Triangulation& triangulation,
                      std::size_t subsets) {
  const auto empty_ball = delaunay::cospherical_points_of_an_empty_ball(points, triangulation);
  if (empty_ball) return {Genericity::Answer::kNotGeneric, *empty_ball, false};
  const auto size = static_cast<std::size_t>(points.dimension() + 2);
  if (subsets != 0 && binomial(points.size(), size, subsets + 1) > subsets) {
    return {Genericity::Answer::kUndecided};
  }
  const auto any_ball = delaunay::cospherical_points(points);
  if (any_ball) return {Genericity::Answer::kNotGeneric, *any_ball};
  return {Genericity::Answer::kGeneric};
}

// The ball whose sphere the cospherical points share: that of an affine basis of them.
Ball common_ball(const PointSet& points, const Simplex& cospherical) {
  Simplex basis;
  for (const std::size_t i : affine_hull(coordinates(points, cospherical)).basis) {
    basis.push_back(cospherical[i]);
  }
  return circumball(points, basis);
}

std::string_view answer_word(Genericity::Answer answer) {
  switch (answer) {
    case Genericity::Answer::kGeneric:
      return "generic";
    case Genericity::Answer::kNotGeneric:
      return "not-generic";
    case Genericity::Answer::kUndecided:
      return "generic-undecided";
  }
  return "";
}

struct Facts {
  const LoadedPoints& input;
  std::size_t points_read;
  std::vector<Duplicate> duplicates;
  Genericity genericity;
  std::vector<SimplexCount> counts;
};

// "simplices: 19 of at most 28 edges, 18 of at most 40 triangles, 6 of at most 19 tetrahedra"
std::string counts_text(const std::vector<SimplexCount>& counts) {
  std::string text;
  for (const SimplexCount& count : counts) {
    const std::string noun =
        report::simplices_noun(count.dimension, count.bound.value_or(count.count));
    text += fmt::format("{}{}{} {}{}", text.empty() ? "simplices: " : ", ", count.count,
                        count.bound ? fmt::format(" of at most {}", *count.bound) : "",
                        count.dimension > 3 ? fmt::format("{}-", count.dimension) : "", noun);
  }
  return text.empty() ? "" : text + "\n";
}

std::string text(const Facts& facts) {
  const ExactMesh& mesh = facts.input.mesh;
  std::string out;
  for (const Duplicate& duplicate : facts.duplicates) {
    out += fmt::format("duplicate: points {} and {} are equal\n", duplicate.kept + mesh.first_index,
                       duplicate.again + mesh.first_index);
  }
  const Genericity& genericity = facts.genericity;
  if (!genericity.cospherical.empty()) {
    const Ball ball = common_ball(mesh.points, genericity.cospherical);
    std::string centre;
    for (const Rational& x : ball.centre) centre += " " + to_decimal(x);
    out += fmt::format("cospherical: points {} on {} of centre ~{} radius ~ {}\n",
                       report::labels(mesh, genericity.cospherical),
                       genericity.unique ? "a sphere" : "an empty sphere", centre,
                       square_root_to_decimal(ball.squared_radius));
  }
  if (genericity.answer == Genericity::Answer::kUndecided) {
    out += "generic: undecided, more subsets than --subsets; no empty ball has too many points\n";
  }
  out += counts_text(facts.counts);
  return out +
         fmt::format("inspected: {} {} {} dimension {} of {} {} {}\n",
                     on_one_line(facts.input.name), report::counted(facts.points_read, "point"),
                     report::counted(facts.duplicates.size(), "duplicate"), mesh.points.dimension(),
                     mesh.points.ambient_dimension(), answer_word(genericity.answer),
                     genericity.unique ? "unique" : "not-unique");
}

report::Json json(const Facts& facts) {
  const ExactMesh& mesh = facts.input.mesh;
  report::Json repeated = report::Json::array();
  for (const Duplicate& duplicate : facts.duplicates) {
    repeated.push_back({duplicate.kept + mesh.first_index, duplicate.again + mesh.first_index});
  }
  report::Json object = {{"input", facts.input.name},
                         {"points", facts.points_read},
                         {"duplicates", repeated},
                         {"ambient_dimension", mesh.points.ambient_dimension()},
                         {"dimension", mesh.points.dimension()},
                         {"generic", answer_word(facts.genericity.answer)},
                         {"unique", facts.genericity.unique}};
  report::Json counts = report::Json::array();
  for (const SimplexCount& count : facts.counts) {
    report::Json entry = {{"dimension", count.dimension}, {"count", count.count}};
    if (count.bound) entry["bound"] = *count.bound;
    counts.push_back(entry);
  }
  object["simplices_of_canonical_triangulation"] = counts;
  if (!facts.genericity.cospherical.empty()) {
    report::Json vertices = report::Json::array();
    report::Json coordinates = report::Json::object();
    for (const Vertex v : facts.genericity.cospherical) {
      vertices.push_back(mesh.label(v));
      coordinates[std::to_string(mesh.label(v))] = report::point(mesh.points[v]);
    }
    object["cospherical"] = {
        {"vertices", vertices},
        {"ball", report::ball(common_ball(mesh.points, facts.genericity.cospherical))},
        {"coordinates", coordinates}};
  }
  return object;
}

void inspect_points(const std::string& path, const InspectOptions& options, Output& output) {
  // Duplicates are one of the facts asked for: they are merged and reported, not rejected.
  InputOptions merging = options.input;
  merging.duplicates = Duplicates::kMerge;
  std::vector<Duplicate> repeated;
  const auto loaded = load_points(path, merging, &repeated);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "input", path, loaded.error());
    return;
  }
  const PointSet& points = loaded->mesh.points;
  const Triangulation triangulation = delaunay::bowyer_watson(
      points, {delaunay::InsertionOrder::kBrioHilbert, delaunay::PointLocation::kWalking, 0});
  const Facts facts{*loaded, points.size() + repeated.size(), repeated,
                    genericity(points, triangulation, options.subsets),
                    simplex_counts(triangulation, points.size())};
  report::Json answers = report::Json::array();
  for (const std::string& vertices : options.simplices) {
    const auto answer = inspect_simplex(loaded->mesh, repeated, vertices);
    if (!answer) {
      output.error(ExitCode::kUsage, "input", path, answer.error());
      return;
    }
    output.text(answer->text + "\n");
    answers.push_back(answer->json);
  }
  if (output.wants_text()) output.text(text(facts));
  if (!output.wants_json()) return;
  report::Json result = json(facts);
  if (!answers.empty()) result["simplices"] = answers;
  output.json(result);
}

void inspect_one(const std::string& path, const InspectOptions& options, Output& output) {
  if (options.domain.is_asked_for || formats::is_domain_file(path)) {
    inspect_domain(path, options.input, options.domain, output);
  } else {
    inspect_points(path, options, output);
  }
}

// What is wrong with the names of the proofs that are to be written; empty if nothing is.
std::string refutations_fault(const InspectOptions& options) {
  const std::string& prefix = options.domain.refutations;
  if (prefix.empty()) return "";
  if (options.inputs.size() != 1) {
    return fmt::format("expected one domain beside --refutations, found {} inputs",
                       options.inputs.size());
  }
  std::vector<Written> proofs;
  for (const std::string& path : refutation_files(prefix)) proofs.push_back({"the proofs", path});
  return overwriting_fault(proofs, files_of_domain(options.inputs.front()));
}

}  // namespace

void add_inspect(CLI::App& app, ExitCode& exit_code) {
  const auto options = std::make_shared<InspectOptions>();
  CLI::App* command = app.add_subcommand(
      "inspect",
      "Facts about a point set: dimension, duplicates, genericity with a witness, counts; or about "
      "a domain: validity, polyhedra, edge-protection, whether it has a CDT");
  command->footer(
      "Example:\n"
      "  circumspect inspect points.node\n"
      "  circumspect inspect part.poly\n\n"
      "A set is generic if no k+2 of its points lie on one sphere (k the dimension of its affine\n"
      "hull). 'unique' says that there is only one Delaunay triangulation.\n\n"
      "A domain that is no piecewise linear complex gets exit code 3, and its breaches are "
      "listed.\n"
      "Of one that is, the last line says whether it has a constrained Delaunay triangulation "
      "(CDT):\n"
      "  cdt canonical   it has one, by the symbolic perturbation\n"
      "  cdt another     it has one, by other tie-breaks\n"
      "  cdt none        it has none without Steiner points, which is proved\n"
      "  cdt unknown     the search reached a limit (exit code 4)\n\n"
      "Exit codes: 0 inspected, 2 usage, 3 the input is at fault, 4 undecided within a limit,\n"
      "5 internal error.");
  command
      ->add_option("input", options->inputs,
                   "Points: .node, .json, .off, .xyz, .csv, or Qhull's form; domains: .poly, "
                   ".smesh, .stl, .ply, "
                   ".obj, .mesh, .msh, .vtk, .vtu, .vtp")
      ->required();
  command
      ->add_option("--subsets", options->subsets,
                   "Look at no more than N subsets for genericity (default: 200000; 0: all)")
      ->check(whole_number())
      ->option_text("N");
  command
      ->add_option("--simplex", options->simplices,
                   "Tell whether this simplex, of any dimension, is Delaunay or strongly Delaunay "
                   "(\"1 2 3\")")
      ->option_text("VERTICES")
      ->allow_extra_args(false);
  add_domain_inspection_options(*command, options->domain);
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] {
    if (const std::string fault = refutations_fault(*options); !fault.empty()) {
      exit_code = usage_error(fault);
      return;
    }
    Output output(options->output);
    for (const std::string& input : options->inputs) inspect_one(input, *options, output);
    exit_code = output.finish();
  });
}

}  // namespace circumspect::cli
