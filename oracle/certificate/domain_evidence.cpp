#include "oracle/certificate/domain_evidence.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "kernel/complex/improper_intersection.hpp"
#include "kernel/exact/linear_algebra.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/domain_part.hpp"
#include "oracle/certificate/evidence.hpp"

namespace circumspect::certificate {
namespace {

// Which of the rules of meshes refute a claim about a domain.
bool refutes(Rule rule, Claim claim) {
  switch (rule) {
    case Rule::kWrongDimension:
    case Rule::kUnknownVertex:
    case Rule::kRepeatedVertex:
    case Rule::kDegenerateSimplex:
    case Rule::kDuplicateSimplex:
    case Rule::kOverlap:
    case Rule::kCoveredTwice:
      return true;
    case Rule::kVertexInBall:
    case Rule::kFacetNotLocal:
      return claim == Claim::kConformingDelaunay;
    default:
      return false;
  }
}

class Finder {
 public:
  Finder(const ExactMesh& mesh, const Domain& domain, const ScaledPoints& points,
         const std::vector<Vertex>& vertices)
      : mesh_(mesh), complex_(domain.complex), points_(points), vertices_(vertices) {
    for (const Point& point : complex_.points.points()) given_.insert(point);
    for (const Simplex& simplex : mesh.simplices) {
      for (const Vertex v : simplex) {
        if (mesh.points.names(v)) used_.emplace(mesh.points[v], v);
      }
    }
  }

  // With fewer vertices it may dangle.
  std::optional<Evidence> no_simplex() const {
    for (std::size_t s = 0; s < mesh_.simplices.size(); ++s) {
      const std::size_t size = mesh_.simplices[s].size();
      if (size == 0 || size > points_.dimension + 1)
        return Evidence{Rule::kWrongDimension, {to_integer(s) + 1}};
    }
    return std::nullopt;
  }

  std::optional<Evidence> vertex_missing() const {
    for (Vertex v = 0; complex_.points.names(v); ++v) {
      if (!used_.contains(complex_.points[v]))
        return Evidence{Rule::kDomainVertexMissing, {to_integer(v) + 1}};
    }
    return std::nullopt;
  }

  std::optional<Evidence> steiner_forbidden() const {
    for (std::size_t s = 0; s < mesh_.simplices.size(); ++s) {
      const Simplex& simplex = mesh_.simplices[s];
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        if (!mesh_.points.names(simplex[i]) || given_.contains(mesh_.points[simplex[i]])) continue;
        return Evidence{Rule::kSteinerForbidden, {to_integer(s) + 1, to_integer(i)}};
      }
    }
    return std::nullopt;
  }

  // Where the mesh lists the vertex, the edge that it is inside of, and the segment; from the
  // witness.
  std::optional<Evidence> vertex_in_edge(const Verdict& verdict) const {
    for (const Violation& violation : verdict.violations()) {
      const Witness& witness = violation.witness;
      if (violation.rule != Rule::kVertexInEdge || !witness.face || !witness.domain_cell) continue;
      const auto edge = number_of(mesh_, witness.simplices.front());
      const auto segment =
          std::find(complex_.segments.begin(), complex_.segments.end(), *witness.domain_cell);
      const auto around = std::find_if(
          mesh_.simplices.begin(), mesh_.simplices.end(),
          [&](const Simplex& simplex) { return contains(simplex, witness.vertices.front()); });
      if (!edge || segment == complex_.segments.end() || around == mesh_.simplices.end()) continue;
      const auto place = [](const Simplex& simplex, Vertex v) {
        return to_integer(std::find(simplex.begin(), simplex.end(), v) - simplex.begin());
      };
      const Simplex& listed = mesh_.simplices[*edge - 1];
      return Evidence{Rule::kVertexInEdge,
                      {to_integer(around - mesh_.simplices.begin()) + 1,
                       place(*around, witness.vertices.front()), to_integer(*edge),
                       place(listed, witness.face->front()), place(listed, witness.face->back()),
                       to_integer(segment - complex_.segments.begin()) + 1}};
    }
    return std::nullopt;
  }

  // Weights for the vertices of a dangling simplex and for those that are in its circumballs: both
  // are combined to one point, and the latter's squares to less. Such weights exist wherever no
  // circumball is empty.
  std::optional<Evidence> no_empty_ball(const Verdict& verdict) const {
    for (const Violation& violation : verdict.violations()) {
      if (violation.rule != Rule::kNoEmptyBall) continue;
      const auto number = number_of(mesh_, violation.witness.simplices.front());
      if (!number) continue;
      const Simplex& simplex = mesh_.simplices[*number - 1];
      const std::vector<Vertex>& others = violation.witness.vertices;
      // Those of the others, then what is added and what is taken away of the simplex's own.
      Simplex columns = others;
      columns.insert(columns.end(), simplex.begin(), simplex.end());
      columns.insert(columns.end(), simplex.begin(), simplex.end());
      LinearProgram program{RationalMatrix(points_.dimension + 2), {}, {}};
      program.right_sides.assign(points_.dimension + 2, 0);
      program.right_sides.back() = 1;
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const int sign = i < others.size() + simplex.size() ? 1 : -1;
        Rational square = 0;
        for (std::size_t axis = 0; axis < points_.dimension; ++axis) {
          const Rational x(points_.coordinate(columns[i], axis));
          program.equations[axis].push_back(sign * x);
          square += x * x;
        }
        program.equations[points_.dimension].push_back(sign);
        program.equations[points_.dimension + 1].push_back(i < others.size() ? 1 : 0);
        program.objective.push_back(-sign * square);
      }
      const LinearProgramAnswer answer = maximize(program);
      if (answer.status != LinearProgramStatus::kOptimal || sgn(answer.value) <= 0) continue;
      std::vector<Rational> weights(
          answer.solution.begin(),
          answer.solution.begin() + static_cast<std::ptrdiff_t>(others.size()));
      for (std::size_t i = others.size(); i < others.size() + simplex.size(); ++i) {
        weights.push_back(answer.solution[i] - answer.solution[i + simplex.size()]);
      }
      const Integer whole = common_denominator(weights);
      const auto weight = [&](std::size_t i) { return numerator_over(whole, weights[i]); };
      Evidence evidence{Rule::kNoEmptyBall, {to_integer(*number), to_integer(simplex.size())}};
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        evidence.because.push_back(weight(others.size() + i));
      }
      for (std::size_t i = 0; i < others.size(); ++i) {
        evidence.because.push_back(to_integer(others[i]) + 1);
        evidence.because.push_back(weight(i));
      }
      return evidence;
    }
    return std::nullopt;
  }

  // Of three simplices at a facet two are on one side of it: they overlap.
  std::optional<Evidence> overlap_beside_facet(const Verdict& verdict) const {
    for (const Violation& violation : verdict.violations()) {
      if (violation.rule != Rule::kFacetOverused || !violation.witness.face) continue;
      std::vector<Simplex> around;
      for (const Simplex& simplex : mesh_.simplices) {
        const bool has_facet = has_face(simplex, *violation.witness.face);
        if (has_facet && simplex.size() == points_.dimension + 1) around.push_back(simplex);
      }
      for (std::size_t i = 0; i < around.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          const auto point = improper_intersection(mesh_.points, around[i], around[j]);
          if (!point) continue;
          Witness witness;
          witness.simplices = {around[i], around[j]};
          witness.point = point;
          return overlap_evidence(mesh_, points_, Rule::kOverlap, witness);
        }
      }
    }
    return std::nullopt;
  }

  // The midpoint of two vertices of the mesh that follow on each other on the segment and are not
  // edge.
  std::optional<Evidence> segment_missing() const {
    std::set<Simplex> edges;
    for (const Simplex& simplex : mesh_.simplices) {
      if (simplex.size() > 4) return std::nullopt;
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        for (std::size_t j = i + 1; j < simplex.size(); ++j) {
          edges.insert(sorted({simplex[i], simplex[j]}));
        }
      }
    }
    for (std::size_t s = 0; s < complex_.segments.size(); ++s) {
      const std::vector<Vertex> along = places_along(complex_.segments[s]);
      for (std::size_t i = 0; i + 1 < along.size(); ++i) {
        if (edges.contains(sorted({along[i], along[i + 1]}))) continue;
        Evidence evidence{Rule::kSegmentMissing, {to_integer(s) + 1}};
        for (std::size_t axis = 0; axis < points_.dimension; ++axis) {
          evidence.because.push_back(points_.coordinate(along[i], axis) +
                                     points_.coordinate(along[i + 1], axis));
        }
        evidence.because.push_back(2);
        return evidence;
      }
    }
    return std::nullopt;
  }

 private:
  // The ends and the vertices of the mesh between them, by their places among all points.
  std::vector<Vertex> places_along(const Simplex& segment) const {
    const Vertex a = vertices_[static_cast<std::size_t>(segment[0])];
    const Vertex b = vertices_[static_cast<std::size_t>(segment[1])];
    const auto difference = [&](Vertex v, std::size_t axis) {
      return Integer(points_.coordinate(v, axis) - points_.coordinate(a, axis));
    };
    const auto along = [&](Vertex v) {
      Integer product = 0;
      for (std::size_t axis = 0; axis < points_.dimension; ++axis) {
        product += difference(v, axis) * difference(b, axis);
      }
      return product;
    };
    const Integer length = along(b);
    std::map<Integer, Vertex> places{{Integer(0), a}, {length, b}};
    for (const auto& [point, v] : used_) {
      const Integer t = along(v);
      if (sgn(t) <= 0 || t >= length) continue;
      bool is_on = true;
      for (std::size_t axis = 0; is_on && axis < points_.dimension; ++axis) {
        is_on = length * difference(v, axis) == t * difference(b, axis);
      }
      if (is_on) places.emplace(t, v);
    }
    std::vector<Vertex> vertices;
    for (const auto& [t, v] : places) vertices.push_back(v);
    return vertices;
  }

  const ExactMesh& mesh_;
  const PiecewiseLinearComplex& complex_;
  const ScaledPoints& points_;
  const std::vector<Vertex>& vertices_;
  std::set<Point> given_;
  std::map<Point, Vertex> used_;
};

}  // namespace

std::optional<Evidence> domain_evidence(const ExactMesh& mesh, const ExactMesh& all,
                                        const Domain& domain, const Verdict& verdict,
                                        const ScaledPoints& points,
                                        const std::vector<Vertex>& vertices) {
  const Finder finder(all, domain, points, vertices);
  for (const auto& [rule, tally] : verdict.tallies()) {
    std::optional<Evidence> found;
    if (rule == Rule::kDomainVertexMissing) found = finder.vertex_missing();
    if (rule == Rule::kSteinerForbidden) found = finder.steiner_forbidden();
    if (rule == Rule::kSegmentMissing) found = finder.segment_missing();
    if (rule == Rule::kVertexInEdge) found = finder.vertex_in_edge(verdict);
    if (rule == Rule::kNoEmptyBall) found = finder.no_empty_ball(verdict);
    if (rule == Rule::kFacetOverused) found = finder.overlap_beside_facet(verdict);
    if (rule == Rule::kWrongDimension) {
      found = finder.no_simplex();
    } else if (refutes(rule, verdict.claim())) {
      found = evidence_for(rule == Rule::kOverlap ? all : mesh, verdict, points, rule);
    }
    if (found) return found;
  }
  return std::nullopt;
}

}  // namespace circumspect::certificate
