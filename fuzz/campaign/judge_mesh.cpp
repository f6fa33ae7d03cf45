#include "fuzz/campaign/judge_mesh.hpp"

#include <algorithm>
#include <map>

#include "oracle/formats/mesh_files.hpp"
#include "oracle/judge/domain/judge_domain.hpp"
#include "oracle/model/merged_points.hpp"
#include "oracle/report/text.hpp"
#include "reference/kernel/piecewise_linear/regions.hpp"
#include "reference/kernel/piecewise_linear/validity.hpp"

namespace circumspect::campaign {
namespace {

// How many witnesses a finding carries.
constexpr std::size_t kWitnesses = 3;

// The mesh of these points, equal ones as one; simplices counted from 0.
Mesh mesh_of(const PointsCase& set, Vertex first_index, std::vector<Simplex> simplices,
             bool weighted) {
  return mesh_of_merged(set.points, weighted ? set.weights : std::vector<Rational>(),
                        duplicates(set.points), first_index, std::move(simplices));
}

Outcome unreadable(const std::string& message) {
  return {OutcomeKind::kUnreadable, word(OutcomeKind::kUnreadable), message, message + "\n"};
}

Outcome other_points(const std::string& message) {
  return {OutcomeKind::kOtherPoints, word(OutcomeKind::kOtherPoints), message, message + "\n"};
}

Outcome outcome_of(const Verdict& verdict, const Mesh& mesh, const Subject& subject,
                   const Domain* domain) {
  if (verdict.holds()) return {OutcomeKind::kHolds};
  Outcome outcome;
  outcome.kind = OutcomeKind::kFails;
  outcome.signature = identifier(verdict.tallies().begin()->first);
  outcome.text = report::verdict_line(verdict, mesh, subject.mesh_name, domain);
  outcome.explanation = report::explanation(verdict, mesh, domain);
  outcome.verdict = report::verdict(verdict, mesh, subject.mesh_name, check::By::kLemma, domain);
  return outcome;
}

std::vector<Point> sorted_set(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

bool lists_points(const std::string& path) {
  const std::string extension = formats::extension(path);
  return extension != ".ele" && extension != ".qhull-i";
}

check::Options options() { return {check::By::kLemma, false, kWitnesses}; }

// The weights that the input gives to the points of the mesh, which are in another order.
PointsCase with_weights_of(const PointsCase& set, std::vector<Point> points) {
  PointsCase own{std::move(points), {}};
  if (set.weights.empty()) return own;
  const PointSet given = mesh_of(set, 0, {}, true).points;
  std::map<Point, Rational> weight_of;
  for (Vertex v = 0; given.names(v); ++v) weight_of[given[v]] = given.weight(v);
  for (const Point& point : own.points) own.weights.push_back(weight_of[point]);
  return own;
}

Outcome judged_points(const Subject& subject, const PointsCase& set, const std::string& path) {
  formats::MeshRequest request;
  request.mesh = path;
  const bool own = lists_points(path);
  if (!own) {
    // What is asked of the points is how many coordinates they have, and from where they are counted.
    request.own_points.emplace();
    request.own_points->dimension =
        set.points.empty() ? subject.dimension : set.points.front().size();
    request.own_points->first_index = subject.first_index;
  }
  auto raw = formats::read_mesh(request);
  if (!raw) return unreadable(raw.error().to_string());
  const bool weighted = subject.claim == Claim::kWeightedDelaunay;
  PointsCase points = set;
  if (own) {
    if (sorted_set(raw->points.points) != sorted_set(set.points)) {
      return other_points(subject.mesh_name + ": expected the " +
                          std::to_string(set.points.size()) + " points of the input, found " +
                          std::to_string(raw->points.points.size()) + ", not the same ones");
    }
    points = with_weights_of(set, std::move(raw->points.points));
  }
  const Mesh mesh =
      mesh_of(points, raw->first_index, std::move(raw->simplices.simplices), weighted);
  return outcome_of(check::judge(subject.claim, mesh, options()), mesh, subject, nullptr);
}

// Triangles and edges listed beside the simplices of full dimension.
std::vector<Simplex> proper_faces(std::vector<Simplex> faces, std::size_t dimension) {
  std::erase_if(faces, [dimension](const Simplex& face) { return face.size() > dimension; });
  return faces;
}

Outcome judged_domain(const Subject& subject, const ComplexCase& whole, const std::string& path) {
  formats::MeshRequest request;
  request.mesh = path;
  request.with_faces = true;
  auto raw = formats::read_mesh(request);
  if (!raw) return unreadable(raw.error().to_string());
  Domain domain{whole.complex(), {}, subject.first_index, {}};
  domain.complex.kind = subject.domain_kind;
  const std::size_t dimension = domain.complex.ambient_dimension();
  if (!raw->points.points.empty() && raw->points.dimension != dimension) {
    return unreadable(subject.mesh_name + ": expected points of dimension " +
                      std::to_string(dimension) + ", found dimension " +
                      std::to_string(raw->points.dimension));
  }
  if (const auto repeated = duplicates(raw->points.points); !repeated.empty()) {
    return other_points(subject.mesh_name + ": expected distinct vertices, found vertices " +
                        std::to_string(repeated.front().kept + raw->first_index) + " and " +
                        std::to_string(repeated.front().again + raw->first_index) + " equal");
  }
  const Mesh mesh{PointSet(std::move(raw->points.points)),
                  std::move(raw->simplices.simplices),
                  {},
                  raw->first_index,
                  {},
                  proper_faces(std::move(raw->faces), dimension)};
  return outcome_of(check::judge_domain(subject.claim, mesh, domain, options()), mesh, subject,
                    &domain);
}

std::string reason_to_skip_points(const Subject& subject, const PointsCase& set) {
  for (const Point& point : set.points) {
    if (point.size() != subject.dimension) return "the points have another dimension";
  }
  const bool asked = subject.full_dimension;
  return asked && is_flat(subject, set) ? "the points lie in a hyperplane" : "";
}

std::string reason_to_skip_domain(const Subject& subject, const ComplexCase& whole) {
  if (whole.input.points.empty()) return "the domain is empty";
  if (whole.input.points.front().size() != subject.dimension) return "another dimension";
  PiecewiseLinearInput input = whole.input;
  input.kind = subject.domain_kind;
  const auto complex = validated(input, 1);
  if (!complex) return "the domain is not valid";
  if (input.kind == DomainKind::kEnclosed && Regions(*complex).size() < 2) {
    return "the domain encloses nothing";
  }
  return "";
}

}  // namespace

Outcome judged(const Subject& subject, const Input& input, const std::string& path) {
  if (const auto* const set = std::get_if<PointsCase>(&input)) {
    return judged_points(subject, *set, path);
  }
  return judged_domain(subject, std::get<ComplexCase>(input), path);
}

bool is_flat(const Subject& subject, const Input& input) {
  const auto* const set = std::get_if<PointsCase>(&input);
  if (set == nullptr) return false;
  return mesh_of(*set, 0, {}, false).points.dimension() < static_cast<int>(subject.dimension);
}

std::string reason_to_skip(const Subject& subject, const Input& input) {
  if (!is_of_doubles(input)) return "a number is not a double";
  if (const auto* const set = std::get_if<PointsCase>(&input)) {
    return reason_to_skip_points(subject, *set);
  }
  return reason_to_skip_domain(subject, std::get<ComplexCase>(input));
}

}  // namespace circumspect::campaign
