// circumspect inspect INPUT
#include <algorithm>
#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/check/certificate_output.hpp"
#include "command/input/input.hpp"
#include "command/inspect/inspect_domain.hpp"
#include "command/inspect/inspect_simplex.hpp"
#include "command/inspect/refutation_files.hpp"
#include "command/options/nearest_word.hpp"
#include "command/options/whole_number.hpp"
#include "command/output/output.hpp"
#include "command/output/overwriting.hpp"
#include "command/subcommands.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/wording.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/simplex_predicates.hpp"
#include "reference/kernel/complex/point_set.hpp"
#include "reference/kernel/exact/number.hpp"

namespace circumspect::cli {
namespace {

struct InspectOptions {
  std::vector<std::string> inputs;
  std::size_t subsets = 200'000;
  std::vector<std::string> simplices;  // "1 2 3", by the user's indices
  std::vector<std::string> only;       // some of the facts; none means all
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

// How many simplices of the highest dimension a triangulation has at most, less than the Upper Bound Theorem
// allows for its lifted points: about half of the facets of a cyclic polytope. And how long it takes to
// make them, about, on a machine of 2023, in dimensions in which that is more than a moment.
std::optional<double> seconds_of_triangulating(std::size_t points, int dimension) {
  if (dimension < 4) return std::nullopt;
  const auto n = static_cast<double>(points);
  const int half = (dimension + 1) / 2;
  double simplices = 1;
  for (int i = 0; i < half; ++i) simplices *= std::max(1.0, n - half - 1 - i) / (i + 1);
  return simplices * 1e-6 * std::pow(dimension, 3);
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

std::string duplicates_text(const ExactMesh& mesh, const std::vector<Duplicate>& duplicates) {
  std::string text;
  for (const Duplicate& duplicate : duplicates) {
    text += fmt::format("duplicate: points {} and {} are equal\n",
                        duplicate.kept + mesh.first_index, duplicate.again + mesh.first_index);
  }
  return text;
}

std::string genericity_text(const ExactMesh& mesh, const Genericity& genericity) {
  if (genericity.answer == Genericity::Answer::kUndecided) {
    return "generic: undecided, more subsets than --subsets; no empty ball has too many points\n";
  }
  if (genericity.cospherical.empty()) return "";
  const Ball ball = common_ball(mesh.points, genericity.cospherical);
  std::string centre;
  for (const Rational& x : ball.centre) centre += " " + to_decimal(x);
  return fmt::format("cospherical: points {} on {} of centre ~{} radius ~ {}\n",
                     report::labels(mesh, genericity.cospherical),
                     genericity.unique ? "a sphere" : "an empty sphere", centre,
                     square_root_to_decimal(ball.squared_radius));
}

report::Json genericity_json(const ExactMesh& mesh, const Genericity& genericity) {
  report::Json object = {{"generic", answer_word(genericity.answer)},
                         {"unique", genericity.unique}};
  if (genericity.cospherical.empty()) return object;
  report::Json vertices = report::Json::array();
  report::Json coordinates = report::Json::object();
  for (const Vertex v : genericity.cospherical) {
    vertices.push_back(mesh.label(v));
    coordinates[std::to_string(mesh.label(v))] = report::point(mesh.points[v]);
  }
  object["cospherical"] = {{"vertices", vertices},
                           {"ball", report::ball(common_ball(mesh.points, genericity.cospherical))},
                           {"coordinates", coordinates}};
  return object;
}

report::Json counts_json(const std::vector<SimplexCount>& counts) {
  report::Json array = report::Json::array();
  for (const SimplexCount& count : counts) {
    report::Json entry = {{"dimension", count.dimension}, {"count", count.count}};
    if (count.bound) entry["bound"] = *count.bound;
    array.push_back(entry);
  }
  return array;
}

constexpr std::string_view kDimension = "dimension", kGenericity = "genericity",
                           kSimplices = "simplices";

std::vector<std::string> point_facts() {
  return {std::string(kDimension), std::string(kGenericity), std::string(kSimplices)};
}

// Prints what is found as soon as it is found, and collects it for JSON and for the last line.
class PointsInspection {
 public:
  PointsInspection(const LoadedPoints& loaded, const std::vector<Duplicate>& repeated,
                   const InspectOptions& options, Output& output)
      : loaded_(loaded), repeated_(repeated), options_(options), output_(output) {}

  void run() {
    add_dimension();
    if (!add_answers()) return;
    if (wants(kGenericity) || wants(kSimplices)) {
      const Triangulation triangulation = triangulated();
      if (wants(kGenericity)) add_genericity(triangulation);
      if (wants(kSimplices)) add_counts(triangulation);
    }
    output_.text(fmt::format("inspected: {} {}\n", on_one_line(loaded_.name), summary_));
    if (output_.wants_json()) output_.json(known_);
  }

 private:
  bool wants(std::string_view fact) const {
    const std::vector<std::string>& only = options_.only;
    return only.empty() || std::find(only.begin(), only.end(), fact) != only.end();
  }
  const ExactMesh& mesh() const { return loaded_.mesh; }
  const PointSet& points() const { return mesh().points; }

  void add_dimension() {
    const std::size_t read = points().size() + repeated_.size();
    const std::string dimension =
        fmt::format("dimension {} of {}", points().dimension(), points().ambient_dimension());
    summary_ = fmt::format("{} {} {}", report::counted(read, "point"),
                           report::counted(repeated_.size(), "duplicate"), dimension);
    output_.text(duplicates_text(mesh(), repeated_) + fmt::format("points: {}\n", summary_));
    report::Json repeated = report::Json::array();
    for (const Duplicate& duplicate : repeated_) {
      repeated.push_back(
          {duplicate.kept + mesh().first_index, duplicate.again + mesh().first_index});
    }
    know({{"input", loaded_.name},
          {"points", read},
          {"duplicates", repeated},
          {"ambient_dimension", points().ambient_dimension()},
          {"dimension", points().dimension()}});
  }

  // What was asked about single simplices. False, and said, if a question has no sense.
  bool add_answers() {
    report::Json answers = report::Json::array();
    for (const std::string& vertices : options_.simplices) {
      const auto answer = inspect_simplex(mesh(), repeated_, vertices);
      if (!answer) {
        output_.error(ExitCode::kUsage, "input", loaded_.name, answer.error());
        return false;
      }
      output_.text(answer->text + "\n");
      answers.push_back(answer->json);
    }
    if (!answers.empty()) know({{"simplices", answers}});
    return true;
  }

  Triangulation triangulated() {
    output_.begin("triangulating " + loaded_.name,
                  seconds_of_triangulating(points().size(), points().dimension()));
    return delaunay::bowyer_watson(
        points(), {delaunay::InsertionOrder::kBrioHilbert, delaunay::PointLocation::kWalking, 0,
                   output_.progress()});
  }

  void add_genericity(const Triangulation& triangulation) {
    output_.begin("deciding whether " + loaded_.name + " is generic");
    const Genericity found = genericity(points(), triangulation, options_.subsets);
    output_.text(genericity_text(mesh(), found));
    summary_ +=
        fmt::format(" {} {}", answer_word(found.answer), found.unique ? "unique" : "not-unique");
    know(genericity_json(mesh(), found));
  }

  void add_counts(const Triangulation& triangulation) {
    output_.begin("counting the simplices of " + loaded_.name);
    const std::vector<SimplexCount> counts = simplex_counts(triangulation, points().size());
    output_.text(counts_text(counts));
    know({{"simplices_of_canonical_triangulation", counts_json(counts)}});
  }

  void know(const report::Json& more) {
    known_.update(more);
    output_.know(known_);
  }

  const LoadedPoints& loaded_;
  const std::vector<Duplicate>& repeated_;
  const InspectOptions& options_;
  Output& output_;
  std::string summary_;
  report::Json known_ = report::Json::object();
};

void inspect_points(const std::string& path, const InspectOptions& options, Output& output) {
  output.begin("reading " + path);
  // Duplicates are one of the facts asked for: they are merged and reported, not rejected.
  InputOptions merging = options.input;
  merging.duplicates = Duplicates::kMerge;
  std::vector<Duplicate> repeated;
  const auto loaded = load_points(path, merging, &repeated);
  if (!loaded) {
    output.error(ExitCode::kInputFault, "input", path, loaded.error());
    return;
  }
  PointsInspection(*loaded, repeated, options, output).run();
}

// What is wrong with the facts that are asked for; empty if nothing is.
std::string facts_fault(const std::vector<std::string>& only, bool of_domain) {
  const std::vector<std::string> known = of_domain ? domain_facts() : point_facts();
  for (const std::string& fact : only) {
    if (std::find(known.begin(), known.end(), fact) != known.end()) continue;
    return fmt::format("expected --only {} for {}, found {}{}", fmt::join(known, "|"),
                       of_domain ? "a domain" : "points", fact, nearest_text(fact, known));
  }
  return "";
}

void inspect_one(const std::string& path, const InspectOptions& options, Output& output) {
  const bool is_domain = options.domain.is_asked_for || formats::is_domain_file(path);
  if (const std::string fault = facts_fault(options.only, is_domain); !fault.empty()) {
    output.error(ExitCode::kUsage, is_domain ? "domain" : "input", path, fault);
  } else if (is_domain) {
    inspect_domain(path, options.input, options.domain, options.only, output);
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
  for (const std::string& path : impossibility_files(prefix))
    proofs.push_back({"the proofs", path});
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
      "Of one that is, each fact is printed as soon as it is known, and the last line says "
      "whether\n"
      "it has a constrained Delaunay triangulation (CDT):\n"
      "  cdt canonical   it has one, by the symbolic perturbation\n"
      "  cdt another     it has one, by other tie-breaks\n"
      "  cdt none        it has none without Steiner points, which is proved\n"
      "  cdt unknown     the search reached a limit (exit code 4 if --decide asks for the "
      "answer)\n\n"
      "Exit codes: 0 inspected, 2 usage, 3 the input is at fault, 4 interrupted, stopped by "
      "--limit "
      "or\n"
      "undecided in spite of --decide, 5 internal error.");
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
  command
      ->add_option(
          "--only", options->only,
          "Find no more than these facts: of points dimension, genericity, simplices; of a "
          "domain validity, regions, edge-protection, cdt")
      ->option_text("FACTS")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_domain_inspection_options(*command, options->domain);
  add_coordinates_option(*command, options->input);
  add_duplicates_option(*command, options->input);
  add_limit_option(*command, options->output);
  add_output_options(*command, options->output);
  command->callback([options, &exit_code] {
    if (const std::string fault = refutations_fault(*options); !fault.empty()) {
      exit_code = usage_error(fault);
      return;
    }
    Output output(options->output);
    output.watch("inspect");
    for (const std::string& input : options->inputs) inspect_one(input, *options, output);
    exit_code = output.finish();
  });
}

}  // namespace circumspect::cli
