#include "oracle/certificate/evidence.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "kernel/exact/linear_algebra.hpp"
#include "oracle/certificate/certificate.hpp"
#include "oracle/judge/points/simplices.hpp"

namespace circumspect::certificate {

namespace {

Integer number(std::size_t index) { return to_integer(index) + 1; }
Integer position(std::size_t index) { return to_integer(index); }

// The entry that names no point.
std::optional<std::size_t> unknown_entry(const ExactMesh& mesh, const Simplex& simplex) {
  const auto unknown =
      std::find_if(simplex.begin(), simplex.end(), [&](Vertex v) { return !mesh.points.names(v); });
  if (unknown == simplex.end()) return std::nullopt;
  return static_cast<std::size_t>(unknown - simplex.begin());
}

// What one simplex shows about a rule.
std::optional<std::vector<Integer>> fault_of(const ExactMesh& mesh, Sidedness& sidedness,
                                             std::size_t s, Rule rule) {
  const Simplex& simplex = mesh.simplices[s];
  const bool has_right_size = static_cast<int>(simplex.size()) == mesh.points.dimension() + 1;
  const auto unknown = unknown_entry(mesh, simplex);
  if (rule == Rule::kUnknownVertex && unknown) return {{number(s), position(*unknown)}};
  if (rule == Rule::kWrongDimension && !has_right_size) return {{number(s)}};
  if (rule == Rule::kRepeatedVertex) {
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      for (std::size_t j = i + 1; j < simplex.size(); ++j) {
        if (simplex[i] == simplex[j]) return {{number(s), position(i), position(j)}};
      }
    }
  }
  if (rule == Rule::kDegenerateSimplex && has_right_size && !unknown &&
      sidedness.orientation(simplex) == 0) {
    return {{number(s)}};
  }
  return std::nullopt;
}

std::optional<std::vector<Integer>> same_vertices(const ExactMesh& mesh) {
  std::vector<Simplex> ascending;
  for (const Simplex& simplex : mesh.simplices) ascending.push_back(sorted(simplex));
  std::vector<std::size_t> order(ascending.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return ascending[a] < ascending[b]; });
  const auto twice = std::adjacent_find(
      order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return ascending[a] == ascending[b]; });
  if (twice == order.end()) return std::nullopt;
  return {{number(*twice), number(*(twice + 1))}};
}

std::optional<std::vector<Integer>> overused_facet(const ExactMesh& mesh) {
  std::vector<FaceUse> uses = facets(mesh);
  std::optional<std::vector<Integer>> because;
  for_each_face(uses, [&](std::span<const FaceUse> group) {
    if (group.size() < 3 || because) return;
    because.emplace();
    for (const FaceUse& use : group.first(3)) {
      because->push_back(number(use.cell));
      because->push_back(position(use.place));
    }
  });
  return because;
}

std::optional<std::vector<Integer>> find(const ExactMesh& mesh, const ScaledPoints& points,
                                         Rule rule) {
  switch (rule) {
    case Rule::kDuplicateSimplex:
      return same_vertices(mesh);
    case Rule::kFacetOverused:
      return overused_facet(mesh);
    case Rule::kUnusedPoint: {
      const std::vector<Vertex> unused = check::unused_points(mesh);
      if (unused.empty()) return std::nullopt;
      return {{number(static_cast<std::size_t>(unused.front()))}};
    }
    default:
      break;
  }
  Sidedness sidedness(points);
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    if (auto because = fault_of(mesh, sidedness, s, rule)) return because;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Evidence> simplex_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                         Rule rule) {
  auto because = find(mesh, points, rule);
  if (!because) return std::nullopt;
  return Evidence{rule, std::move(*because)};
}

std::optional<Evidence> overlap_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                         Rule rule, const Witness& witness) {
  if (!witness.point || witness.simplices.size() != 2) return std::nullopt;
  // Faces of simplices, too: then the simplices overlap.
  Evidence evidence{rule, {}};
  for (const Simplex& face : witness.simplices) {
    const auto found =
        std::find_if(mesh.simplices.begin(), mesh.simplices.end(),
                     [&](const Simplex& simplex) { return has_face(simplex, face); });
    if (found == mesh.simplices.end()) return std::nullopt;
    evidence.because.emplace_back(to_integer(found - mesh.simplices.begin() + 1));
  }
  const HomogeneousPoint common = scaled(points, *witness.point);
  evidence.because.insert(evidence.because.end(), common.numerators.begin(),
                          common.numerators.end());
  evidence.because.push_back(common.denominator);
  return evidence;
}

// Faults of the boundary: the simplices of the facets in question are looked up.

namespace {

// The number of a simplex that has the facet, and the place of its other vertex.
void append_facet(std::vector<Integer>& because, const ExactMesh& mesh, const Simplex& facet) {
  const auto found = std::find_if(mesh.simplices.begin(), mesh.simplices.end(),
                                  [&](const Simplex& simplex) { return has_face(simplex, facet); });
  assert(found != mesh.simplices.end());
  const auto off =
      std::find_if(found->begin(), found->end(), [&](Vertex v) { return !contains(facet, v); });
  because.emplace_back(to_integer(found - mesh.simplices.begin()) + 1);
  because.emplace_back(to_integer(off - found->begin()));
}

}  // namespace

std::optional<Evidence> hull_evidence(const ExactMesh& mesh, Rule rule, const Witness& witness) {
  Evidence evidence{rule, {}};
  if (rule == Rule::kHullNotConvex) {
    append_facet(evidence.because, mesh, *witness.face);
    evidence.because.emplace_back(to_integer(witness.vertices.front()) + 1);
    return evidence;
  }
  // Each simplex around a ridge has two of the facets there, and no facet is in three simplices: so
  // those that are in one simplex only are even in number, and if they are not two, they are four.
  constexpr std::size_t kEnough = 3;
  if (witness.simplices.size() < kEnough) return std::nullopt;
  for (std::size_t i = 0; i < kEnough; ++i) {
    append_facet(evidence.because, mesh, witness.simplices[i]);
  }
  return evidence;
}

std::optional<Evidence> uncovered_point_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                                 Vertex point) {
  Evidence evidence{Rule::kUnusedPoint, {to_integer(point) + 1}};
  const HomogeneousPoint q = barycentre(points, {point});
  Sidedness sidedness(points);
  for (const Simplex& simplex : mesh.simplices) {
    const auto place = sidedness.separating_place(simplex, sidedness.orientation(simplex), q);
    if (!place) return std::nullopt;
    evidence.because.emplace_back(to_integer(*place));
  }
  return evidence;
}

// The witnesses of the checkers, in the numbers of a refutation.

namespace {

// A simplex and the place of one of its vertices.
struct Entry {
  std::size_t simplex;
  std::size_t place;
};

std::size_t place_of(const Simplex& simplex, Vertex v) {
  return static_cast<std::size_t>(std::find(simplex.begin(), simplex.end(), v) - simplex.begin());
}

// The simplex that joins the facet and the vertex.
Entry entry_of(const ExactMesh& mesh, Simplex facet, Vertex apex) {
  facet.push_back(apex);
  const Simplex vertices = sorted(facet);
  const auto found =
      std::find_if(mesh.simplices.begin(), mesh.simplices.end(),
                   [&](const Simplex& simplex) { return sorted(simplex) == vertices; });
  assert(found != mesh.simplices.end());
  return {static_cast<std::size_t>(found - mesh.simplices.begin()), place_of(*found, apex)};
}

// Any simplex that has the vertex.
Entry entry_of(const ExactMesh& mesh, Vertex v) {
  const auto found = std::find_if(mesh.simplices.begin(), mesh.simplices.end(),
                                  [v](const Simplex& simplex) { return contains(simplex, v); });
  assert(found != mesh.simplices.end());
  return {static_cast<std::size_t>(found - mesh.simplices.begin()), place_of(*found, v)};
}

void append(std::vector<Integer>& because, const Entry& entry) {
  because.emplace_back(to_integer(entry.simplex + 1));
  because.emplace_back(to_integer(entry.place));
}

}  // namespace

std::optional<std::size_t> number_of(const ExactMesh& mesh, const Simplex& simplex) {
  const auto found =
      std::find_if(mesh.simplices.begin(), mesh.simplices.end(), [&](const Simplex& listed) {
        return std::is_permutation(listed.begin(), listed.end(), simplex.begin(), simplex.end());
      });
  if (found == mesh.simplices.end()) return std::nullopt;
  return static_cast<std::size_t>(found - mesh.simplices.begin()) + 1;
}

std::optional<Evidence> ball_evidence(const ExactMesh& mesh, Rule rule, const Witness& witness) {
  Evidence evidence{rule, {}};
  const Vertex q = witness.vertices.front();
  const Simplex& simplex = witness.simplices.front();
  if (rule == Rule::kVertexSubmerged) {
    append(evidence.because, entry_of(mesh, q));
    for (const Vertex v : simplex) evidence.because.emplace_back(to_integer(v) + 1);
  } else if (rule == Rule::kFacetNotLocal) {
    const Simplex& facet = *witness.face;
    const auto off =
        std::find_if(simplex.begin(), simplex.end(), [&](Vertex v) { return !contains(facet, v); });
    append(evidence.because, entry_of(mesh, facet, *off));
    append(evidence.because, entry_of(mesh, facet, q));
  } else {
    const auto number = number_of(mesh, simplex);
    if (!number) return std::nullopt;
    evidence.because.emplace_back(to_integer(*number));
    evidence.because.emplace_back(to_integer(q) + 1);
  }
  return evidence;
}

std::optional<Evidence> flat_ball_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                           const Witness& witness) {
  const auto number = number_of(mesh, witness.simplices.front());
  if (!number) return std::nullopt;
  const Simplex& simplex = mesh.simplices[*number - 1];
  const Vertex q = witness.vertices.front();
  RationalMatrix equations = {std::vector<Rational>(simplex.size(), 1)};
  std::vector<Rational> right_sides = {1};
  for (const std::size_t axis : mesh.points.configuration().hull().axes) {
    equations.emplace_back();
    for (const Vertex v : simplex) equations.back().emplace_back(points.coordinate(v, axis));
    right_sides.emplace_back(points.coordinate(q, axis));
  }
  if (simplex.size() != equations.size()) return std::nullopt;
  const auto weights = solve(std::move(equations), std::move(right_sides));
  if (!weights) return std::nullopt;
  const Integer whole = common_denominator(*weights);
  Evidence evidence{Rule::kVertexInBall, {to_integer(*number), to_integer(q) + 1}};
  for (const Rational& weight : *weights) {
    evidence.because.push_back(-numerator_over(whole, weight));
  }
  evidence.because.push_back(whole);
  return evidence;
}

std::optional<Evidence> line_end_evidence(const ExactMesh& mesh, const ScaledPoints& points) {
  const std::size_t axis = mesh.points.configuration().hull().axes.front();
  const auto along = [&](Vertex v) -> const Integer& { return points.coordinate(v, axis); };
  Vertex first = 0;
  Vertex last = 0;
  std::vector<std::size_t> uses(mesh.points.size());
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    if (along(v) < along(first)) first = v;
    if (along(last) < along(v)) last = v;
  }
  for (const Simplex& simplex : mesh.simplices) {
    for (const Vertex v : simplex) ++uses[static_cast<std::size_t>(v)];
  }
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    const Simplex& simplex = mesh.simplices[s];
    if (simplex.size() != 2) return std::nullopt;
    for (std::size_t start = 0; start < 2; ++start) {
      const Vertex end = simplex[1 - start];
      const Vertex beyond = along(simplex[start]) < along(end) ? last : first;
      if (uses[static_cast<std::size_t>(end)] == 1 && along(beyond) != along(end)) {
        return Evidence{Rule::kHullNotConvex, {number(s), position(start), to_integer(beyond) + 1}};
      }
    }
  }
  return std::nullopt;
}

std::optional<Evidence> two_sides_evidence(const ExactMesh& mesh, const Witness& witness) {
  const auto number = number_of(mesh, witness.simplices.front());
  if (!number || witness.vertices.size() != 2) return std::nullopt;
  return Evidence{Rule::kFacetNotSupporting,
                  {to_integer(*number), to_integer(witness.vertices[0]) + 1,
                   to_integer(witness.vertices[1]) + 1}};
}

namespace {

// A vertex last in a simplex whose others stay.
Simplex with(Simplex others, Vertex last) {
  others.push_back(last);
  return others;
}

// A facet of the hull beyond a ridge of this one, and a point beside it. Where others lie in the
// plane of this facet, it is there; else it is the first that a plane about the ridge meets.
// Requires: `facet` ends with its vertex off the ridge, and is in the boundary of the hull.
std::optional<Simplex> facet_beyond(Sidedness& sidedness, Vertex count, const Simplex& facet) {
  const Simplex ridge(facet.begin(), std::prev(facet.end()));
  const Vertex apex = facet.back();
  Vertex beside = 0;
  while (beside < count && sidedness.orientation(with(facet, beside)) == 0) ++beside;
  if (beside == count) return std::nullopt;
  const int own = sidedness.orientation(with(facet, beside));
  Vertex found = beside;
  for (Vertex v = 0; v < count; ++v) {
    const Simplex turned = with(ridge, v);
    if (sidedness.orientation(with(turned, beside)) == -own &&
        sidedness.orientation(with(turned, apex)) == 0) {
      return with(turned, beside);
    }
    const Simplex before = with(ridge, found);
    if (sidedness.orientation(with(before, v)) == -sidedness.orientation(with(before, apex))) {
      found = v;
    }
  }
  return with(with(ridge, found), apex);
}

// On the way from the middle of a ridge to vertex `to`: the 2^halvings-th part of it.
HomogeneousPoint near_ridge(const ScaledPoints& points, const Simplex& ridge, Vertex to,
                            std::size_t halvings) {
  Integer part = 1;
  for (std::size_t i = 0; i < halvings; ++i) part *= 2;
  const Integer count = to_integer(ridge.size());
  HomogeneousPoint point{{}, part * count};
  for (std::size_t axis = 0; axis < points.dimension; ++axis) {
    Integer sum = count * points.coordinate(to, axis);
    for (const Vertex v : ridge) sum += (part - 1) * points.coordinate(v, axis);
    point.numerators.push_back(std::move(sum));
  }
  return in_lowest_terms(std::move(point));
}

// Some vertex of `around` shows that the point is not in the facet: together they make a simplex.
bool is_off(Sidedness& sidedness, const Simplex& facet, const Simplex& around,
            const HomogeneousPoint& point) {
  return std::any_of(around.begin(), around.end(), [&](Vertex v) {
    const Simplex simplex = with(facet, v);
    const int own = sidedness.orientation(simplex);
    return own != 0 && (sidedness.separating_place(simplex, own, point) ||
                        sidedness.orientation_with(simplex, facet.size(), point) == own);
  });
}

}  // namespace

std::optional<Evidence> uncovered_hull_evidence(const ExactMesh& mesh, const ScaledPoints& points,
                                                const Witness& witness) {
  if (!witness.face || witness.simplices.empty()) return std::nullopt;
  Simplex facet = *witness.face;
  for (const Vertex v : witness.simplices.front()) {
    if (!contains(facet, v)) facet.push_back(v);
  }
  if (facet.size() != points.dimension) return std::nullopt;
  Sidedness sidedness(points);
  const auto around = facet_beyond(sidedness, static_cast<Vertex>(mesh.points.size()), facet);
  if (!around) return std::nullopt;
  const Vertex to = (*around)[points.dimension - 1];
  // Near the ridge there is no facet but those at it; this many halvings are more than enough for
  // points of a program.
  constexpr std::size_t kMostHalvings = 200;
  for (std::size_t halvings = 1; halvings < kMostHalvings; ++halvings) {
    const HomogeneousPoint point = near_ridge(points, *witness.face, to, halvings);
    if (!std::all_of(mesh.simplices.begin(), mesh.simplices.end(), [&](const Simplex& row) {
          return row.size() == points.dimension && is_off(sidedness, row, *around, point);
        })) {
      continue;
    }
    Evidence evidence{Rule::kHullUncovered, {}};
    for (const Vertex v : *around) evidence.because.emplace_back(to_integer(v) + 1);
    evidence.because.insert(evidence.because.end(), point.numerators.begin(),
                            point.numerators.end());
    evidence.because.push_back(point.denominator);
    return evidence;
  }
  return std::nullopt;
}

std::optional<Evidence> edge_evidence(const ExactMesh& mesh, const Witness& witness) {
  Evidence evidence{Rule::kEdgeNotDelaunay, {}};
  // The edge is one of two rows: a triangle that is listed twice is a third one.
  Simplex edge = witness.simplices.front();
  std::erase(edge, witness.vertices.front());
  const auto rows =
      std::count_if(mesh.simplices.begin(), mesh.simplices.end(), [&](const Simplex& row) {
        return std::all_of(edge.begin(), edge.end(), [&](Vertex end) {
          return std::find(row.begin(), row.end(), end) != row.end();
        });
      });
  if (rows != 2) return std::nullopt;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto number = number_of(mesh, witness.simplices[side]);
    if (!number) return std::nullopt;
    append(evidence.because,
           {*number - 1, place_of(mesh.simplices[*number - 1], witness.vertices[side])});
  }
  return evidence;
}

}  // namespace circumspect::certificate
