#include "oracle/judge/points/triangulation.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/improper_intersection.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/conditions/conditions.hpp"
#include "oracle/judge/points/simplices.hpp"
#include "oracle/model/witnesses.hpp"

namespace circumspect::check {

namespace {

Vertex apex_of(const ExactMesh& mesh, const FacetUse& use) {
  return mesh.simplices[use.simplex][use.opposite];
}

// The side of the facet on which the simplex is that uses it.
int inner_side(const ExactMesh& mesh, const FacetUse& use) {
  return side_of_facet(mesh.points.configuration(), use.facet, apex_of(mesh, use));
}

}  // namespace

BoundaryFacet boundary_facet(const ExactMesh& mesh, const FacetUse& use) {
  return {use.facet, apex_of(mesh, use), use.simplex, inner_side(mesh, use)};
}

std::vector<BoundaryFacet> boundary_facets(const ExactMesh& mesh,
                                           const std::vector<FacetUse>& uses) {
  std::vector<BoundaryFacet> boundary;
  for (const auto group : ByFacet(uses)) {
    if (group.size() == 1) boundary.push_back(boundary_facet(mesh, group.front()));
  }
  return boundary;
}

int side_of(const Configuration& points, const BoundaryFacet& facet, Vertex q) {
  return side_of_facet(points, facet.facet, q) * facet.inner;
}

namespace {

Witness beyond(const ExactMesh& mesh, const BoundaryFacet& facet, Vertex q) {
  return vertex_beyond_facet(mesh.points, mesh.simplices[facet.simplex], facet.facet, facet.apex,
                             q);
}

// The witness that two simplices overlap: a common point off their common face. A linear program
// finds the point, so only a witness that is shown has one: where the points are those of another
// mesh, half of the facets have both of their simplices on one side.
Witness overlap(const ExactMesh& mesh, std::size_t a, std::size_t b, bool is_shown) {
  const Simplex& first = mesh.simplices[a];
  const Simplex& second = mesh.simplices[b];
  Witness witness{.simplices = {first, second}};
  if (is_shown) witness.point = improper_intersection(mesh.points, first, second);
  return witness;
}

// What condition 1 finds wrong with a facet of these uses.
std::optional<Violation> fault_at_facet(const ExactMesh& mesh, std::span<const FacetUse> uses,
                                        bool is_shown) {
  const auto same_side = [&] { return inner_side(mesh, uses[0]) == inner_side(mesh, uses[1]); };
  switch (conditions::at_facet(uses.size(), same_side)) {
    case conditions::AtFacet::kOverused: {
      Witness witness{.face = uses.front().facet};
      for (const FacetUse& use : uses) witness.simplices.push_back(mesh.simplices[use.simplex]);
      return Violation{Rule::kFacetOverused, std::move(witness)};
    }
    case conditions::AtFacet::kSameSide:
      return Violation{Rule::kOverlap, overlap(mesh, uses[0].simplex, uses[1].simplex, is_shown)};
    case conditions::AtFacet::kGood:
      break;
  }
  return std::nullopt;
}

// Two boundary facets that meet in a ridge, each with its vertex off the ridge.
struct Hinge {
  const BoundaryFacet& first;
  Vertex first_far;
  const BoundaryFacet& second;
  Vertex second_far;
  const Simplex& ridge;
};

// Coplanar facets: are the far vertices on the same side of the ridge, within the plane?
bool is_folded(const ExactMesh& mesh, const Hinge& hinge) {
  const Configuration& points = mesh.points.configuration();
  const std::vector<std::size_t> axes = axes_of(points, hinge.first.facet);
  const int side = side_of_facet(points, axes, hinge.ridge, hinge.first_far);
  return side == side_of_facet(points, axes, hinge.ridge, hinge.second_far);
}

// What condition 2 finds wrong with a ridge of two facets.
std::optional<Violation> fault_at_hinge(const ExactMesh& mesh, const Hinge& hinge, bool is_shown) {
  const Configuration& points = mesh.points.configuration();
  switch (conditions::at_ridge(
      2, [&] { return side_of(points, hinge.first, hinge.second_far); },
      [&] { return side_of(points, hinge.second, hinge.first_far); },
      [&] { return is_folded(mesh, hinge); })) {
    case conditions::AtRidge::kSecondBeyond:
      return Violation{Rule::kHullNotConvex, beyond(mesh, hinge.first, hinge.second_far)};
    case conditions::AtRidge::kFirstBeyond:
      return Violation{Rule::kHullNotConvex, beyond(mesh, hinge.second, hinge.first_far)};
    case conditions::AtRidge::kFolded:
      return Violation{Rule::kOverlap,
                       overlap(mesh, hinge.first.simplex, hinge.second.simplex, is_shown)};
    case conditions::AtRidge::kNotClosed:
    case conditions::AtRidge::kGood:
      break;
  }
  return std::nullopt;
}

// What condition 2 finds wrong with a ridge that these boundary facets use.
std::optional<Violation> fault_at_ridge(const ExactMesh& mesh,
                                        const std::vector<BoundaryFacet>& boundary,
                                        std::span<const FacetUse> uses, bool is_shown) {
  if (uses.size() == 2) {
    const BoundaryFacet& first = boundary[uses[0].simplex];
    const BoundaryFacet& second = boundary[uses[1].simplex];
    return fault_at_hinge(mesh,
                          {first, first.facet[uses[0].opposite], second,
                           second.facet[uses[1].opposite], uses[0].facet},
                          is_shown);
  }
  Witness witness{.face = uses.front().facet};
  for (const FacetUse& use : uses) witness.simplices.push_back(boundary[use.simplex].facet);
  return Violation{Rule::kHullNotClosed, std::move(witness)};
}

// A vertex of the sample's simplex that lies strictly beyond the facet. There is one whenever the
// sample point does not lie strictly on the inner side: it is the mean of the vertices, and a sound
// simplex does not lie in a hyperplane.
Vertex vertex_beyond(const ExactMesh& mesh, const BoundaryFacet& facet,
                     const Simplex& sample_simplex) {
  return *std::find_if(sample_simplex.begin(), sample_simplex.end(), [&](Vertex v) {
    return side_of(mesh.points.configuration(), facet, v) < 0;
  });
}

// Is the sample point in the closed simplex?
bool covers(const Configuration& points, const Simplex& simplex, Vertex sample) {
  const std::vector<int> signs = barycentric_signs(points, simplex, sample);
  return conditions::covers(signs.size(), [&](std::size_t place) { return signs[place]; });
}

}  // namespace

bool judge_facet_matching(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                          Verdict& verdict) {
  bool matched = true;
  for (const auto group : ByFacet(uses)) {
    const auto fault = fault_at_facet(mesh, group, verdict.keeps_more());
    if (fault) verdict.add(fault->rule, fault->witness);
    matched &= !fault;
  }
  return matched;
}

bool judge_ridges(const ExactMesh& mesh, const std::vector<BoundaryFacet>& boundary,
                  const std::vector<FacetUse>& ridges, Verdict& verdict) {
  bool closed_and_convex = true;
  for (const auto group : ByFacet(ridges)) {
    const auto fault = fault_at_ridge(mesh, boundary, group, verdict.keeps_more());
    if (fault) verdict.add(fault->rule, fault->witness);
    closed_and_convex &= !fault;
  }
  return closed_and_convex;
}

void judge_sample_point(const ExactMesh& mesh, const std::vector<BoundaryFacet>& boundary,
                        Verdict& verdict) {
  const Simplex& first = mesh.simplices.front();
  const Point sample = barycentre(mesh.points, first);
  std::vector<Point> with_sample = mesh.points.points();
  with_sample.push_back(sample);
  const Configuration points(with_sample);
  const auto o = static_cast<Vertex>(mesh.points.size());
  bool inside_hull = true;
  for (const BoundaryFacet& facet : boundary) {
    if (conditions::is_strictly_inside(side_of(points, facet, o))) continue;
    inside_hull = false;
    verdict.add(Rule::kHullNotConvex, beyond(mesh, facet, vertex_beyond(mesh, facet, first)));
  }
  if (!inside_hull) return;
  for (std::size_t s = 1; s < mesh.simplices.size(); ++s) {
    if (!covers(points, mesh.simplices[s], o)) continue;
    verdict.add(Rule::kCoveredTwice, {.simplices = {first, mesh.simplices[s]}, .point = sample});
  }
}

bool judge_complex_by_lemma(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                            Verdict& verdict) {
  if (mesh.simplices.empty()) return true;
  if (!judge_facet_matching(mesh, uses, verdict)) return false;
  const std::vector<BoundaryFacet> boundary = boundary_facets(mesh, uses);
  std::vector<Simplex> facets;
  facets.reserve(boundary.size());
  for (const BoundaryFacet& facet : boundary) facets.push_back(facet.facet);
  if (judge_ridges(mesh, boundary, facet_uses(facets), verdict))
    judge_sample_point(mesh, boundary, verdict);
  return true;
}

namespace {

// `across` is the place of the true neighbour in the list of simplices, or −1.
void judge_link(const ExactMesh& mesh, const FacetUse& use, Vertex across, Verdict& verdict) {
  const Vertex expected = across < 0 ? -1 : across + mesh.neighbors->first_index;
  const Vertex listed = mesh.neighbors->rows[use.simplex][use.opposite];
  if (listed == expected) return;
  const Simplex* const simplex =
      across < 0 ? nullptr : &mesh.simplices[static_cast<std::size_t>(across)];
  add_wrong_neighbor(mesh, use, simplex, listed, expected, verdict);
}

}  // namespace

void judge_neighbors(const ExactMesh& mesh, const std::vector<FacetUse>& uses, Verdict& verdict) {
  for (const auto group : ByFacet(uses)) {
    const bool shared = group.size() == 2;
    for (std::size_t i = 0; i < group.size(); ++i) {
      const Vertex across = shared ? static_cast<Vertex>(group[1 - i].simplex) : -1;
      judge_link(mesh, group[i], across, verdict);
    }
  }
}

void add_wrong_neighbor(const ExactMesh& mesh, const FacetUse& use, const Simplex* across,
                        Vertex listed, Vertex expected, Verdict& verdict) {
  Witness witness{
      .simplices = {mesh.simplices[use.simplex]},
      .face = use.facet,
      .values = {{"neighbour listed", listed}, {"neighbour across the face", expected}}};
  // Names the true neighbour by its vertices, so that the reader need not count simplices.
  if (across != nullptr) witness.simplices.push_back(*across);
  verdict.add(Rule::kWrongNeighbor, witness);
}

void judge_beside_definition(const ExactMesh& mesh, const Options& options, Verdict& verdict) {
  Verdict beside(verdict.claim(), mesh, 0);
  const bool was_compared = verdict.tallies().count(Rule::kWrongDimension) == 0 &&
                            judge_simplices(mesh, options.oriented, beside);
  if (!was_compared) return;
  if (mesh.neighbors && verdict.tallies().count(Rule::kOverlap) == 0) {
    judge_neighbors(mesh, facet_uses(mesh.simplices), beside);
  }
  for (const Violation& violation : beside.violations()) {
    verdict.add(violation.rule, violation.witness);
    verdict.unique.reset();
    verdict.canonical.reset();
  }
}

}  // namespace circumspect::check
