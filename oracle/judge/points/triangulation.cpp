#include "oracle/judge/points/triangulation.hpp"

#include <algorithm>
#include <optional>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/conditions/conditions.hpp"

namespace circumspect::check {

namespace {

Simplex with_apex(Simplex facet, Vertex apex) {
  facet.push_back(apex);
  return facet;
}

}  // namespace

std::vector<BoundaryFacet> boundary_facets(const ExactMesh& mesh,
                                           const std::vector<FacetUse>& uses) {
  std::vector<BoundaryFacet> boundary;
  for_each_facet(uses, [&](std::span<const FacetUse> group) {
    if (group.size() != 1) return;
    const FacetUse& use = group.front();
    boundary.push_back({use.facet, mesh.simplices[use.simplex][use.opposite], use.simplex});
  });
  return boundary;
}

int side_of(const Configuration& points, const BoundaryFacet& facet, Vertex q) {
  return orientation(points, with_apex(facet.facet, q)) *
         orientation(points, with_apex(facet.facet, facet.apex));
}

Witness beyond(const ExactMesh& mesh, const BoundaryFacet& facet, Vertex q) {
  Witness witness{
      .simplices = {mesh.simplices[facet.simplex]}, .face = facet.facet, .vertices = {q}};
  const Configuration& points = mesh.points.configuration();
  witness.values = {
      {"orientation determinant of facet and own apex",
       orientation_determinant(points, points.axes(), with_apex(facet.facet, facet.apex))},
      {"orientation determinant of facet and vertex beyond",
       orientation_determinant(points, points.axes(), with_apex(facet.facet, q))}};
  return witness;
}

namespace {

// The witness that two simplices overlap: a common point off their common face.
Witness overlap(const ExactMesh& mesh, std::size_t a, std::size_t b) {
  const Simplex& first = mesh.simplices[a];
  const Simplex& second = mesh.simplices[b];
  return {.simplices = {first, second}, .point = improper_intersection(mesh.points, first, second)};
}

// Is the vertex of `b` opposite a shared facet on the same side of it as that of `a`?
bool on_same_side(const ExactMesh& mesh, const FacetUse& a, const FacetUse& b) {
  const Configuration& points = mesh.points.configuration();
  const BoundaryFacet facet{a.facet, mesh.simplices[a.simplex][a.opposite], a.simplex};
  return side_of(points, facet, mesh.simplices[b.simplex][b.opposite]) > 0;
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
  Simplex with_far = hinge.ridge;
  with_far.push_back(hinge.first_far);
  const int side = orientation(points, axes, with_far);
  with_far.back() = hinge.second_far;
  return side == orientation(points, axes, with_far);
}

// Condition 2 at a ridge of two facets.
bool judge_hinge(const ExactMesh& mesh, const Hinge& hinge, Verdict& verdict) {
  const Configuration& points = mesh.points.configuration();
  switch (conditions::at_ridge(
      2, [&] { return side_of(points, hinge.first, hinge.second_far); },
      [&] { return side_of(points, hinge.second, hinge.first_far); },
      [&] { return is_folded(mesh, hinge); })) {
    case conditions::AtRidge::kSecondBeyond:
      verdict.add(Rule::kHullNotConvex, beyond(mesh, hinge.first, hinge.second_far));
      return false;
    case conditions::AtRidge::kFirstBeyond:
      verdict.add(Rule::kHullNotConvex, beyond(mesh, hinge.second, hinge.first_far));
      return false;
    case conditions::AtRidge::kFolded:
      verdict.add(Rule::kOverlap, overlap(mesh, hinge.first.simplex, hinge.second.simplex));
      return false;
    case conditions::AtRidge::kNotClosed:
    case conditions::AtRidge::kGood:
      break;
  }
  return true;
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
  const int own = orientation(points, simplex);
  return conditions::covers(simplex.size(), [&](std::size_t place) {
    return own * orientation(points, with_vertex_replaced(simplex, place, sample));
  });
}

}  // namespace

bool judge_facet_matching(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                          Verdict& verdict) {
  bool matched = true;
  for_each_facet(uses, [&](std::span<const FacetUse> group) {
    switch (conditions::at_facet(group.size(),
                                 [&] { return on_same_side(mesh, group[0], group[1]); })) {
      case conditions::AtFacet::kGood:
        return;
      case conditions::AtFacet::kOverused: {
        Witness witness{.face = group.front().facet};
        for (const FacetUse& use : group) witness.simplices.push_back(mesh.simplices[use.simplex]);
        verdict.add(Rule::kFacetOverused, witness);
        break;
      }
      case conditions::AtFacet::kSameSide:
        verdict.add(Rule::kOverlap, overlap(mesh, group[0].simplex, group[1].simplex));
        break;
    }
    matched = false;
  });
  return matched;
}

bool judge_ridges(const ExactMesh& mesh, const std::vector<BoundaryFacet>& boundary,
                  const std::vector<FacetUse>& ridges, Verdict& verdict) {
  bool closed = true;
  bool convex = true;
  for_each_facet(ridges, [&](std::span<const FacetUse> group) {
    const auto far = [&](const FacetUse& use) { return boundary[use.simplex].facet[use.opposite]; };
    if (group.size() == 2) {
      const Hinge hinge{boundary[group[0].simplex], far(group[0]), boundary[group[1].simplex],
                        far(group[1]), group[0].facet};
      convex &= judge_hinge(mesh, hinge, verdict);
      return;
    }
    closed = false;
    Witness witness{.face = group.front().facet};
    for (const FacetUse& use : group) witness.simplices.push_back(boundary[use.simplex].facet);
    verdict.add(Rule::kHullNotClosed, witness);
  });
  return closed && convex;
}

void judge_sample_point(const ExactMesh& mesh, const std::vector<BoundaryFacet>& boundary,
                        Verdict& verdict) {
  const Simplex& first = mesh.simplices.front();
  const Point sample = barycentre(coordinates(mesh.points, first));
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

}  // namespace circumspect::check
