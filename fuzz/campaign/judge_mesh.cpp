#include "fuzz/campaign/judge_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>

#include "fuzz/campaign/judge_diagram.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/piecewise_linear/arrangement.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/domain/coplanar_polygons.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::campaign {
namespace {

Outcome other_points(const std::string& message) {
  return {OutcomeKind::kOtherPoints, word(OutcomeKind::kOtherPoints), message, message + "\n"};
}

std::vector<Point> sorted_set(std::vector<Point> points) {
  keep_each_once(points);
  return points;
}

bool lists_points(const std::string& path) {
  const std::string extension = formats::extension(path);
  return extension != ".ele" && extension != ".qhull-i";
}

check::Options options() { return {.max_violations = kWitnessesOfFinding, .threads = 1}; }

// A mesh without simplices, of points of the input.
Mesh mesh_of_points(const PointsCase& set, std::size_t dimension) {
  Mesh mesh;
  mesh.coordinates = numbers_of(set.points, dimension);
  if (!set.weights.empty()) mesh.weights = numbers_of(set.weights);
  return mesh;
}

// The input's weights for these points, which are in another order. Each of several equal points
// has the weight of the one that counts.
std::vector<Rational> weights_of(const std::vector<Point>& points, const PointsCase& set,
                                 std::size_t dimension) {
  Mesh given = mesh_of_points(set, dimension);
  merge_equal_points(given);
  std::map<Point, Rational> weight_of;
  for (Vertex v = 0; given.names(v); ++v) weight_of[given.point(v)] = given.weight(v);
  std::vector<Rational> weights;
  for (const Point& point : points) weights.push_back(weight_of[point]);
  return weights;
}

// The answer to an input in space is read in space, even if that input is flat.
formats::MeshRequest request_for(const Subject& subject, const std::string& path) {
  formats::MeshRequest request;
  request.mesh = path;
  request.keeps_coordinates = subject.dimension == 3;
  return request;
}

// The mesh in the file, over the points of the input, with their weights if the claim is about
// these.
formats::Result<Mesh> mesh_of(const Subject& subject, const PointsCase& set,
                              const std::string& path) {
  formats::MeshRequest request = request_for(subject, path);
  if (!lists_points(path)) {
    request.own_points.emplace();
    request.own_points->dimension =
        set.points.empty() ? subject.dimension : set.points.front().size();
    request.own_points->points = set.points;
    request.own_points->first_index = subject.first_index;
  }
  auto file = formats::read_mesh(request, 1);
  if (!file) return tl::unexpected(file.error());
  Mesh& mesh = file->mesh;
  const bool weighted = subject.claim == Claim::kWeightedDelaunay && !set.weights.empty();
  if (weighted && !lists_points(path)) mesh.weights = numbers_of(set.weights);
  const std::vector<Point> points = mesh.exact_points();
  const bool are_those = sorted_set(points) == sorted_set(set.points);
  if (weighted && lists_points(path) && are_those) {
    mesh.weights = numbers_of(weights_of(points, set, mesh.dimension()));
  }
  return std::move(mesh);
}

Outcome judged_set(const Subject& subject, const PointsCase& set, const std::string& path) {
  auto mesh = mesh_of(subject, set, path);
  if (!mesh) return unreadable(mesh.error().to_string());
  const std::vector<Point> points = mesh->exact_points();
  if (sorted_set(points) != sorted_set(set.points)) {
    return other_points(subject.mesh_name + ": expected the " + std::to_string(set.points.size()) +
                        " points of the input, found " + std::to_string(points.size()) +
                        ", not the same ones");
  }
  const Verdict verdict = check::judge(subject.claim, check::Merging{*mesh}, nullptr, options());
  return outcome_of(verdict, *mesh, subject, nullptr);
}

formats::Result<formats::MeshFile> mesh_with_own_points(const std::string& path) {
  formats::MeshRequest request;
  request.mesh = path;
  request.with_faces = true;
  return formats::read_mesh(request, 1);
}

// The subject says which part of the domain is filled, and which polygons are joined. Nothing if
// its walls are not consistently oriented. Requires: a valid domain.
std::optional<PiecewiseLinearComplex> held_against(const Subject& subject,
                                                   const ComplexCase& given) {
  const ComplexCase whole = tidy(subject, given);
  PiecewiseLinearComplex complex = whole.complex();
  complex.kind = kind_of(subject.fill);
  if (subject.fill == Fill::kEvenOdd || subject.fill == Fill::kWinding) {
    const auto seeds = seeds_of_unfilled(subject.fill, whole.input, complex, Regions(complex));
    if (!seeds) return std::nullopt;
    complex.hole_seeds.insert(complex.hole_seeds.end(), seeds->begin(), seeds->end());
  }
  if (!subject.merges_coplanar || complex.ambient_dimension() != 3) return complex;
  return coplanar_polygons_joined(whole.input, complex).complex;
}

Outcome judged_domain(const Subject& subject, const ComplexCase& whole, const std::string& path) {
  formats::MeshRequest request = request_for(subject, path);
  request.with_faces = true;
  const auto file = formats::read_mesh(request, 1);
  if (!file) return unreadable(file.error().to_string());
  const Mesh& mesh = file->mesh;
  auto complex = held_against(subject, whole);
  assert(complex);  // otherwise the case would have been skipped
  Domain domain{std::move(*complex), {}, subject.first_index, {}};
  const std::size_t dimension = domain.complex.ambient_dimension();
  if (mesh.points() > 0 && mesh.dimension() != dimension) {
    return unreadable(subject.mesh_name + ": expected points of dimension " +
                      std::to_string(dimension) + ", found dimension " +
                      std::to_string(mesh.dimension()));
  }
  const auto verdict = check::judge(subject.claim, mesh, &domain, options());
  if (verdict) return outcome_of(*verdict, mesh, subject, &domain);
  const Duplicate& first = verdict.error().repeated.front();
  return other_points(subject.mesh_name + ": expected distinct vertices, found vertices " +
                      std::to_string(first.kept + mesh.first_index) + " and " +
                      std::to_string(first.again + mesh.first_index) + " equal");
}

// The mesh for checks that use only its indices. If simplices have a vertex too many for the
// points, it is read as a mesh of points in one dimension more.
formats::Result<Mesh> mesh_of_any_dimension(const Subject& subject, const Input& input,
                                            const std::string& path) {
  const auto set = judged_points(input);
  if (!set) {
    return mesh_with_own_points(path).map(
        [](formats::MeshFile&& file) { return std::move(file.mesh); });
  }
  auto mesh = mesh_of(subject, *set, path);
  if (mesh || lists_points(path)) return mesh;
  PointsCase lifted = *set;
  for (Point& point : lifted.points) point.emplace_back(0);
  return mesh_of(subject, lifted, path);
}

std::string space_of(std::size_t dimension) {
  if (dimension == 2) return "in the plane";
  if (dimension == 3) return "in space";
  return "in dimension " + std::to_string(dimension);
}

// In which dimension all simplices of the mesh are full, if that is not the dimension of the
// inputs. For flat points, meshes have simplices with fewer vertices.
std::string misunderstood_dimension(const Subject& subject, const Input& input, const Mesh& mesh) {
  const std::size_t vertices = mesh.simplices.columns();
  if (vertices < 2 || vertices == subject.dimension + 1 || is_flat(subject, input)) return "";
  return "the inputs are " + space_of(subject.dimension) + ", the program answers " +
         space_of(vertices - 1) + ", with simplices of " + std::to_string(vertices) +
         " vertices; should it be --dimension " + std::to_string(vertices - 1) + "?";
}

// The shift of all indices that makes them name points; 0 if they already do.
Vertex misplaced_by(const Mesh& mesh) {
  const auto points = static_cast<Vertex>(mesh.points());
  Vertex least = points, largest = -1;
  for (const Simplex& simplex : mesh.simplices.lists()) {
    for (const Vertex v : simplex) least = std::min(least, v), largest = std::max(largest, v);
  }
  if (least == 1 && largest == points) return -1;
  if (least == -1 && largest == points - 2) return 1;
  return 0;
}

// Does the mesh hold with its indices shifted by so much? For points it is enough that it is a
// triangulation.
bool holds_when_moved(const Subject& subject, const Input& input, Mesh mesh, Vertex by) {
  std::vector<Simplex> simplices = mesh.simplices.lists();
  for (Simplex& simplex : simplices) {
    for (Vertex& v : simplex) v += by;
  }
  mesh.simplices = IndexLists(std::move(simplices));
  if (judged_points(input)) {
    const bool is_plain = subject.claim == Claim::kDelaunay;
    const Claim claim = is_plain ? Claim::kTriangulation : subject.claim;
    return check::judge(claim, check::Merging{mesh}, nullptr, options()).holds();
  }
  auto complex = held_against(subject, std::get<ComplexCase>(input));
  if (!complex) return false;
  const Domain domain{std::move(*complex), {}, subject.first_index, {}};
  if (mesh.dimension() != domain.complex.ambient_dimension()) return false;
  const auto verdict = check::judge(subject.claim, mesh, &domain, options());
  return verdict && verdict->holds();
}

// The simplices by the coordinates of their vertices, in a canonical order.
std::vector<std::vector<Point>> corners_of(const ExactMesh& mesh) {
  std::vector<std::vector<Point>> all;
  for (const Simplex& simplex : mesh.simplices) {
    std::vector<Point> corners;
    for (const Vertex v : simplex) corners.push_back(mesh.points[static_cast<std::size_t>(v)]);
    std::sort(corners.begin(), corners.end());
    all.push_back(std::move(corners));
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::string reason_to_skip_points(const Subject& subject, const PointsCase& set) {
  for (const Point& point : set.points) {
    if (point.size() != subject.dimension) return "the points have another dimension";
  }
  if (subject.claim == Claim::kVoronoi && (set.points.empty() || !duplicates(set.points).empty())) {
    return "there are no sites, or some are equal";
  }
  const bool asked = subject.full_dimension;
  return asked && is_flat(subject, set) ? "the points lie in a hyperplane" : "";
}

std::string reason_to_skip_updates(const Subject& subject, const UpdatesCase& whole) {
  for (const Point& point : whole.set.points) {
    if (point.size() != subject.dimension) return "the points have another dimension";
  }
  const bool asked = subject.full_dimension;
  return asked && is_flat(subject, whole) ? "the points lie in a hyperplane at some time" : "";
}

std::string reason_to_skip_domain(const Subject& subject, const ComplexCase& whole) {
  if (whole.input.points.empty()) return "the domain is empty";
  if (whole.input.points.front().size() != subject.dimension) return "another dimension";
  if (subject.full_dimension && is_flat(subject, whole)) return "the points lie in a hyperplane";
  PiecewiseLinearInput input = tidy(subject, whole).input;
  if (!is_of_doubles(ComplexCase{whole.family, input})) return "segments cross in no double";
  input.kind = kind_of(subject.fill);
  const auto complex = validated(input, 1);
  if (!complex && subject.is_untidy) {
    return "its arrangement is not valid: " + std::string(meaning(complex.error().front().kind));
  }
  if (!complex) return "the domain is not valid";
  if (input.kind == DomainKind::kEnclosed && Regions(*complex).size() < 2) {
    return "the domain encloses nothing";
  }
  if (!held_against(subject, whole)) return "what its walls wind around is not said";
  return "";
}

}  // namespace

Outcome unreadable(const std::string& message) {
  return {OutcomeKind::kUnreadable, word(OutcomeKind::kUnreadable), message, message + "\n"};
}

Outcome outcome_of(const Verdict& verdict, const Mesh& mesh, const Subject& subject,
                   const Domain* domain) {
  if (verdict.holds()) return {OutcomeKind::kHolds};
  Outcome outcome;
  outcome.kind = OutcomeKind::kFails;
  const auto& [rule, tally] = *verdict.tallies().begin();
  outcome.signature = identifier(rule);
  if (tally.worst_margin && *tally.worst_margin < exact_value(kRounding)) {
    outcome.signature += "-rounding";
  }
  outcome.text = report::verdict_line(verdict, mesh, subject.mesh_name, domain);
  outcome.explanation = report::explanation(verdict, mesh, domain);
  outcome.verdict = report::verdict(verdict, mesh, subject.mesh_name, check::By::kLemma, domain);
  return outcome;
}

ComplexCase tidy(const Subject& subject, const ComplexCase& whole) {
  return subject.is_untidy ? ComplexCase{whole.family, arranged(whole.input)} : whole;
}

Outcome judged(const Subject& subject, const Input& input, const std::string& path) {
  if (const auto set = judged_points(input)) {
    return subject.claim == Claim::kVoronoi ? judged_diagram(subject, *set, path)
                                            : judged_set(subject, *set, path);
  }
  return judged_domain(subject, std::get<ComplexCase>(input), path);
}

std::string misunderstanding(const Subject& subject, const Input& input, const std::string& path) {
  auto mesh = mesh_of_any_dimension(subject, input, path);
  if (!mesh) return "";
  const std::string dimension = misunderstood_dimension(subject, input, *mesh);
  if (!dimension.empty()) return dimension;
  const Vertex by = misplaced_by(*mesh);
  if (by == 0 || !holds_when_moved(subject, input, std::move(*mesh), by)) return "";
  const std::string extension = formats::extension(path);
  const bool counts_from_1 = extension == ".mesh" || extension == ".msh";
  const bool leaves_choice = extension == ".ele";
  const Vertex expected = leaves_choice ? subject.first_index : counts_from_1 ? 1 : 0;
  const Vertex found = expected - by;
  return "its indices seem to begin at " + std::to_string(found) + ", and not at " +
         std::to_string(expected) + ", for so its meshes are right" +
         (leaves_choice && (found == 0 || found == 1)
              ? "; should it be --first-index " + std::to_string(found) + "?"
              : "");
}

Comparison compared(const Subject& subject, const Input& input, const std::string& one,
                    const std::string& other) {
  const auto set = judged_points(input);
  Comparison comparison;
  std::vector<std::vector<std::vector<Point>>> simplices;
  for (const std::string& path : {one, other}) {
    const formats::MeshRequest request = request_for(subject, path);
    auto mesh = set ? mesh_of(subject, *set, path)
                    : formats::read_mesh(request, 1).map([](formats::MeshFile&& file) {
                        return std::move(file.mesh);
                      });
    if (!mesh) return comparison;
    merge_equal_points(*mesh);
    simplices.push_back(corners_of(exact(*mesh)));
    const bool is_plain = set && subject.claim == Claim::kTriangulation;
    const Claim claim = is_plain ? Claim::kDelaunay : subject.claim;
    if (!set && subject.claim != Claim::kCdt) continue;
    std::optional<Domain> domain;
    if (!set) {
      auto complex = held_against(subject, std::get<ComplexCase>(input));
      if (!complex) return comparison;
      domain = Domain{std::move(*complex), {}, subject.first_index, {}};
    }
    const Verdict verdict =
        check::judge(claim, check::Merging{*mesh}, domain ? &*domain : nullptr, options());
    comparison.is_unique = comparison.is_unique || verdict.unique.value_or(false);
  }
  comparison.are_same = simplices.front() == simplices.back();
  return comparison;
}

bool is_flat(const Subject& subject, const Input& input) {
  if (const auto* const whole = std::get_if<UpdatesCase>(&input)) {
    return is_ever_flat(*whole, subject.dimension);
  }
  const auto* const set = std::get_if<PointsCase>(&input);
  const std::vector<Point>& points =
      set != nullptr ? set->points : std::get<ComplexCase>(input).input.points;
  return affine_hull(points).dimension < static_cast<int>(subject.dimension);
}

std::string reason_to_skip(const Subject& subject, const Input& input) {
  if (!is_of_doubles(input)) return "a number is not a double";
  if (const auto* const set = std::get_if<PointsCase>(&input)) {
    return reason_to_skip_points(subject, *set);
  }
  if (const auto* const whole = std::get_if<UpdatesCase>(&input)) {
    return reason_to_skip_updates(subject, *whole);
  }
  return reason_to_skip_domain(subject, std::get<ComplexCase>(input));
}

}  // namespace circumspect::campaign
