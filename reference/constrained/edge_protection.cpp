#include "reference/constrained/edge_protection.hpp"

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

#include "kernel/complex/circumball.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::constrained {
namespace {

using delaunay::Delaunayhood;
using delaunay::SimplexDelaunayhood;

// The vertices of the link of an edge.
Simplex link_vertices(const std::vector<Simplex>& star, const Simplex& edge) {
  std::set<Vertex> vertices;
  for (const Simplex& simplex : star) vertices.insert(simplex.begin(), simplex.end());
  for (const Vertex end : edge) vertices.erase(end);
  return {vertices.begin(), vertices.end()};
}

// Is the closed diametral ball of the edge free of these vertices?
bool is_diametral_ball_clear_of(const PointSet& points, const Simplex& edge,
                                const Simplex& others) {
  return std::all_of(others.begin(), others.end(), [&](Vertex q) {
    return sign(inner_product(points[edge[0]] - points[q], points[edge[1]] - points[q])) > 0;
  });
}

// The link of an edge of the triangulation decides whether it is strongly Delaunay. Let a
// hyperplane through the two lifted ends pass (strictly) below the lifted vertices of the link.
// Then it passes (strictly) below the lifted simplices of the star, which are the lower hull near
// the edge; and as the lower hull is convex, it passes (strictly) below all of it. In the second
// case it touches only the edge: a point of contact off the edge would be joined to the middle of
// the edge by points of contact.
SimplexDelaunayhood of_present_edge(const PointSet& points, const std::vector<Simplex>& star,
                                    const Simplex& edge) {
  const Simplex link = link_vertices(star, edge);
  if (is_diametral_ball_clear_of(points, edge, link)) {
    return {Delaunayhood::kStronglyDelaunay, circumball(points, edge), std::nullopt};
  }
  Simplex names = edge;
  names.insert(names.end(), link.begin(), link.end());
  SimplexDelaunayhood answer = delaunay::delaunayhood(PointSet(coordinates(points, names)), {0, 1});
  assert(answer.delaunayhood != Delaunayhood::kNotDelaunay);
  if (answer.obstruction) {
    for (Vertex& v : answer.obstruction->points) v = names[static_cast<std::size_t>(v)];
  }
  return answer;
}

// The coefficients of a vector in the directions from a vertex of the simplex to the others, which
// are a basis of the space that the points span.
std::vector<Rational> in_directions(const PointSet& points, Vertex from, const Simplex& others,
                                    const Point& vector) {
  RationalMatrix matrix;
  std::vector<Rational> right_side;
  for (const std::size_t axis : points.configuration().axes()) {
    matrix.emplace_back();
    for (const Vertex v : others) matrix.back().push_back(points[v][axis] - points[from][axis]);
    right_side.push_back(vector[axis]);
  }
  auto solution = solve(std::move(matrix), std::move(right_side));
  assert(solution.has_value());
  return *std::move(solution);
}

// The simplex of the star of a into which the segment ab sets out, with the coefficients of b − a.
std::pair<Simplex, std::vector<Rational>> first_simplex_towards(const PointSet& points,
                                                                const StarIndex& canonical,
                                                                Vertex a, Vertex b) {
  for (const Simplex& simplex : canonical.star({a})) {
    std::vector<Rational> coefficients =
        in_directions(points, a, without(simplex, {a}), points[b] - points[a]);
    if (std::all_of(coefficients.begin(), coefficients.end(),
                    [](const Rational& c) { return sign(c) >= 0; })) {
      return {simplex, std::move(coefficients)};
    }
  }
  assert(false && "the convex hull holds the segment");
  return {};
}

// With σ the simplex into which ab sets out, b − a = Σ μ (x − a) over the other vertices x of σ,
// and M = Σ μ, the point Σ (μ/M) x is on the line of ab. The sum of the powers, Σ (μ/M) power(x),
// has the sign of the height of the lower hull less that of the lifted segment, just after a. The
// former is a convex function, and equal to the latter in the ends; so it is smaller in between or
// equal throughout. If it is smaller, no circumball is empty. If it is equal, b⁺ lies on the
// witness plane of σ, and the open circumball of σ is one of ab.
SimplexDelaunayhood of_missing_edge(const PointSet& points, const StarIndex& canonical,
                                    const Simplex& edge) {
  const auto [simplex, coefficients] = first_simplex_towards(points, canonical, edge[0], edge[1]);
  const Simplex others = without(simplex, {edge[0]});
  const Ball diametral = circumball(points, edge);
  Rational sum = 0;
  for (const Rational& coefficient : coefficients) sum += coefficient;
  delaunay::Obstruction why{{}, {}, 0};
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (sign(coefficients[i]) == 0) continue;
    why.points.push_back(others[i]);
    why.coefficients.push_back(coefficients[i] / sum);
    why.power += why.coefficients.back() * power(points, diametral, others[i]);
  }
  assert(sign(why.power) <= 0);
  if (sign(why.power) < 0) return {Delaunayhood::kNotDelaunay, std::nullopt, std::move(why)};
  return {Delaunayhood::kDelaunay, circumball(points, simplex), std::move(why)};
}

}  // namespace

StarIndex canonical_delaunay(const PointSet& points, const Progress& progress) {
  const delaunay::BowyerWatsonOptions options{delaunay::InsertionOrder::kBrioHilbert,
                                              delaunay::PointLocation::kWalking, 1, progress};
  return StarIndex(delaunay::bowyer_watson(points, options).simplices());
}

std::vector<SegmentProtection> edge_protection(const PointSet& points,
                                               const StarIndex& canonical_delaunay,
                                               const std::vector<Simplex>& segments,
                                               const Progress& progress) {
  std::vector<SegmentProtection> answers;
  answers.reserve(segments.size());
  for (const Simplex& segment : segments) {
    tell(progress, "segments", answers.size(), segments.size());
    const std::vector<Simplex> star = canonical_delaunay.star(segment);
    answers.push_back({segment, !star.empty(),
                       star.empty() ? of_missing_edge(points, canonical_delaunay, segment)
                                    : of_present_edge(points, star, segment)});
  }
  return answers;
}

std::vector<SegmentProtection> edge_protection(const PiecewiseLinearComplex& complex,
                                               const Progress& progress) {
  return edge_protection(complex.points, canonical_delaunay(complex.points, progress),
                         complex.segments, progress);
}

std::optional<Vertex> encroaching_vertex(const PointSet& points,
                                         const SegmentProtection& protection) {
  if (!protection.status.obstruction) return std::nullopt;
  const Ball diametral = circumball(points, protection.segment);
  const Simplex& suspects = protection.status.obstruction->points;
  // The mean of their powers is at most zero.
  return *std::min_element(suspects.begin(), suspects.end(), [&](Vertex p, Vertex q) {
    return power(points, diametral, p) < power(points, diametral, q);
  });
}

bool is_strongly_delaunay_edge(const PointSet& points, const StarIndex& canonical_delaunay,
                               const Simplex& edge) {
  const std::vector<Simplex> star = canonical_delaunay.star(edge);
  return !star.empty() &&
         of_present_edge(points, star, edge).delaunayhood == Delaunayhood::kStronglyDelaunay;
}

bool has_empty_diametral_ball(const PointSet& points, const StarIndex& canonical_delaunay,
                              const Simplex& edge) {
  const std::vector<Simplex> star = canonical_delaunay.star(edge);
  return !star.empty() && is_diametral_ball_clear_of(points, edge, link_vertices(star, edge));
}

bool is_edge_protected(const PiecewiseLinearComplex& complex) {
  return is_edge_protected(edge_protection(complex));
}

bool is_edge_protected_under_perturbation(const PiecewiseLinearComplex& complex) {
  const StarIndex canonical = canonical_delaunay(complex.points);
  return std::all_of(complex.segments.begin(), complex.segments.end(),
                     [&](const Simplex& segment) { return !canonical.star(segment).empty(); });
}

bool is_edge_protected(const std::vector<SegmentProtection>& segments) {
  return std::all_of(segments.begin(), segments.end(), [](const SegmentProtection& segment) {
    return segment.status.delaunayhood == Delaunayhood::kStronglyDelaunay;
  });
}

bool is_edge_protected_under_perturbation(const std::vector<SegmentProtection>& segments) {
  return std::all_of(segments.begin(), segments.end(),
                     [](const SegmentProtection& segment) { return segment.is_present; });
}

}  // namespace circumspect::constrained
