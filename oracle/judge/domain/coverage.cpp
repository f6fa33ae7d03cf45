#include "oracle/judge/domain/coverage.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "kernel/boxes/box_index.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/domain/listed_faces.hpp"
#include "oracle/judge/domain/measures.hpp"
#include "oracle/judge/domain/outside_simplices.hpp"
#include "oracle/judge/points/triangulation.hpp"

namespace circumspect::check {

namespace {

// The witness that nothing covers the side of a piece: which side, by a sign of orientation.
Witness bare_side(const WallPiece& piece, std::size_t side) {
  return {.face = piece.facet,
          .values = {{"orientation of the bare side", Rational(side == 1 ? 1 : -1)}}};
}

// The simplices on the two sides of a facet.
std::array<std::size_t, 2> simplices_at(const MeshedDomain& in, std::span<const FacetUse> group) {
  std::array<std::size_t, 2> simplices = {kNowhere, kNowhere};
  for (const FacetUse& use : group) {
    Simplex with_apex = use.facet;
    with_apex.push_back(in.mesh.simplices[use.simplex][use.opposite]);
    simplices[side_index(orientation(in.mesh.points.configuration(), with_apex))] = use.simplex;
  }
  return simplices;
}

void judge_piece(const MeshedDomain& in, const WallPiece& piece,
                 const std::array<std::size_t, 2>& simplices, OutsideSimplices& outside,
                 Verdict& verdict) {
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const bool inside = in.is_inside(piece.regions[side]);
    const bool covered = simplices[side] != kNowhere;
    if (inside && !covered) verdict.add(Rule::kUncovered, bare_side(piece, side));
    if (!inside && covered) outside.add(simplices[side], {.face = piece.facet}, verdict);
  }
}

}  // namespace

void judge_coverage(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                    Verdict& verdict) {
  OutsideSimplices outside(in);
  std::vector<FacetUse> loose;
  auto piece = pieces.begin();
  for_each_facet(in.uses, [&](std::span<const FacetUse> group) {
    const Simplex& facet = group.front().facet;
    for (; piece != pieces.end() && piece->facet < facet; ++piece) {
      judge_piece(in, *piece, {kNowhere, kNowhere}, outside, verdict);
    }
    if (piece != pieces.end() && piece->facet == facet) {
      judge_piece(in, *piece, simplices_at(in, group), outside, verdict);
      ++piece;
    } else if (group.size() == 1) {
      loose.push_back(group.front());
    }
  });
  for (; piece != pieces.end(); ++piece) {
    judge_piece(in, *piece, {kNowhere, kNowhere}, outside, verdict);
  }
  judge_loose_facets(in, loose, outside, verdict);
  outside.add_those_beside(pieces, verdict);
}

// ---- Hull coverage ----
// Coverage where the convex hull is the domain: what docs/theory/points.md proves of triangulations
// of point sets does most of the work.

namespace {

// A vertex on the boundary of a convex polyhedron is extreme iff its boundary facets lie in three
// planes or more; on the boundary of a convex polygon, in two lines. So count the planes up to that.
void judge_hull_unchanged(const MeshedDomain& in, Verdict& verdict) {
  const std::vector<BoundaryFacet> boundary = boundary_facets(in.mesh, in.uses);
  std::map<Vertex, std::vector<std::size_t>> facets_at;
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    for (const Vertex v : boundary[f].facet) {
      if (in.places.is_steiner(v)) facets_at[v].push_back(f);
    }
  }
  const Configuration& points = in.mesh.points.configuration();
  const auto coplanar = [&](std::size_t a, std::size_t b) {
    const Simplex& other = boundary[b].facet;
    return std::all_of(other.begin(), other.end(),
                       [&](Vertex v) { return side_of(points, boundary[a], v) == 0; });
  };
  std::set<Vertex> extreme;
  for (const auto& [v, facets] : facets_at) {
    std::vector<std::size_t> planes;
    for (const std::size_t f : facets) {
      const bool seen = std::any_of(planes.begin(), planes.end(),
                                    [&](std::size_t plane) { return coplanar(plane, f); });
      if (!seen) planes.push_back(f);
      if (planes.size() >= in.complex.ambient_dimension()) break;
    }
    if (planes.size() == in.complex.ambient_dimension()) extreme.insert(v);
  }
  OutsideSimplices outside(in);
  for (std::size_t s = 0; s < in.mesh.simplices.size() && !extreme.empty(); ++s) {
    std::vector<Vertex> vertices;
    for (const Vertex v : in.mesh.simplices[s]) {
      if (extreme.contains(v)) vertices.push_back(v);
    }
    if (!vertices.empty()) outside.add(s, {.vertices = vertices}, verdict);
  }
}

}  // namespace

void judge_hull_coverage(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                         Verdict& verdict) {
  if (in.mesh.simplices.empty()) {
    verdict.add(Rule::kUncovered, {.point = barycentre(in.complex.points.points())});
    return;
  }
  if (in.known == nullptr || !in.known->fills_hull) {
    const std::size_t faults = verdict.tallies().size();
    judge_complex_by_lemma(in.mesh, facet_uses(in.mesh.simplices), verdict);
    if (verdict.tallies().size() > faults) return;
  }
  judge_hull_unchanged(in, verdict);
  for (const WallPiece& piece : pieces) {
    if (is_facet(in.uses, piece.facet)) continue;
    verdict.add(Rule::kUncovered, {.face = piece.facet});
  }
}

// ---- Loose facets ----

namespace {

// Where a simplex or its loose facet leaves the domain, by the barycentre; nothing if neither does.
std::optional<Point> point_outside(const MeshedDomain& in, const FacetUse& use) {
  const auto is_out = [](Where where) { return where == Where::kOutside || where == Where::kHole; };
  for (const Simplex& cell : {in.mesh.simplices[use.simplex], use.facet}) {
    Point middle = barycentre(coordinates(in.mesh.points, cell));
    if (is_out(in.regions.locate(middle))) return middle;
  }
  return std::nullopt;
}

class LooseFacets {
 public:
  LooseFacets(const MeshedDomain& in, const std::vector<FacetUse>& facets)
      : in_(in), facets_(facets), index_(boxes_of_vertices()), hanging_(facets.size()) {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      for (const std::size_t place : index_.meeting(box_of(facets_[f].facet))) {
        const Vertex v = vertices_[place];
        if (!contains(facets_[f].facet, v) && lies_in(v, f)) hanging_[f].push_back(v);
      }
      if (hanging_[f].empty()) continue;
      for (const Vertex v : hanging_[f]) at_vertex_[v].push_back(f);
      for (const Vertex v : facets_[f].facet) at_vertex_[v].push_back(f);
    }
  }

  void judge(Verdict& verdict) const {
    std::vector<std::vector<Simplex>> parts(facets_.size());
    std::set<std::size_t> explained;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      for (const std::size_t whole : facets_that_hold(f)) {
        parts[whole].push_back(facets_[f].facet);
        explained.insert(f);
      }
    }
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const FacetUse& use = facets_[f];
      if (!hanging_[f].empty()) add_overlap(f, verdict);
      if (explained.contains(f) || (!hanging_[f].empty() && is_filled(use, parts[f]))) continue;
      verdict.add(Rule::kUncovered,
                  {.simplices = {in_.mesh.simplices[use.simplex]}, .face = use.facet});
    }
  }

 private:
  std::vector<Box> boxes_of_vertices() {
    std::set<Vertex> ends;
    for (const FacetUse& use : facets_) ends.insert(use.facet.begin(), use.facet.end());
    vertices_.assign(ends.begin(), ends.end());
    std::vector<Box> boxes;
    for (const Vertex v : vertices_) boxes.push_back(box_around(in_.mesh.points[v]));
    return boxes;
  }

  Box box_of(const Simplex& facet) const {
    Box box = box_around(in_.mesh.points[facet.front()]);
    for (const Vertex v : facet) box = box_around(box, box_around(in_.mesh.points[v]));
    return box;
  }

  // Is a vertex in the closed facet?
  bool lies_in(Vertex v, std::size_t f) const {
    const Simplex& facet = facets_[f].facet;
    return circumspect::lies_in(in_.mesh.points.configuration(), facet, v);
  }

  // The facets with hanging vertices that hold all of another one, with simplices on opposite sides.
  std::vector<std::size_t> facets_that_hold(std::size_t f) const {
    const FacetUse& part = facets_[f];
    std::vector<std::size_t> found;
    const auto at_first = at_vertex_.find(part.facet.front());
    if (at_first == at_vertex_.end()) return found;
    for (const std::size_t whole : at_first->second) {
      const bool holds = whole != f && std::all_of(part.facet.begin(), part.facet.end(),
                                                   [&](Vertex v) { return lies_in(v, whole); });
      if (holds && is_beyond(part, facets_[whole])) found.push_back(whole);
    }
    return found;
  }

  Vertex apex(const FacetUse& use) const { return in_.mesh.simplices[use.simplex][use.opposite]; }

  // Is the simplex of one facet on the other side of another facet, in the same hyperplane?
  bool is_beyond(const FacetUse& part, const FacetUse& whole) const {
    const BoundaryFacet facet{whole.facet, apex(whole), whole.simplex};
    return side_of(in_.mesh.points.configuration(), facet, apex(part)) < 0;
  }

  // Do parts of a facet, which meet edge to edge or are at fault themselves, measure as much as it?
  bool is_filled(const FacetUse& whole, const std::vector<Simplex>& parts) const {
    const auto axes = axes_of(in_.mesh.points.configuration(), whole.facet);
    return measure(in_.mesh.points, axes, parts) == measure(in_.mesh.points, axes, whole.facet);
  }

  // A hanging vertex is in the facet's simplex without being a vertex of it, and is a vertex of another.
  void add_overlap(std::size_t f, Verdict& verdict) const {
    const Vertex v = hanging_[f].front();
    const auto other = std::find_if(facets_.begin(), facets_.end(),
                                    [&](const FacetUse& use) { return contains(use.facet, v); });
    verdict.add(Rule::kOverlap, {.simplices = {in_.mesh.simplices[facets_[f].simplex],
                                               in_.mesh.simplices[other->simplex]},
                                 .face = facets_[f].facet,
                                 .vertices = hanging_[f],
                                 .point = in_.mesh.points[v]});
  }

  const MeshedDomain& in_;
  const std::vector<FacetUse>& facets_;
  std::vector<Vertex> vertices_;  // of loose facets
  BoxIndex index_;                // of them
  std::vector<std::vector<Vertex>> hanging_;
  std::map<Vertex, std::vector<std::size_t>> at_vertex_;  // facets with hanging vertices
};

}  // namespace

void judge_loose_facets(const MeshedDomain& in, const std::vector<FacetUse>& loose,
                        OutsideSimplices& outside, Verdict& verdict) {
  std::vector<FacetUse> inside;
  for (const FacetUse& use : loose) {
    if (const auto middle = point_outside(in, use)) {
      outside.add(use.simplex, {.face = use.facet, .point = middle}, verdict);
    } else {
      inside.push_back(use);
    }
  }
  if (!inside.empty()) LooseFacets(in, inside).judge(verdict);
}

}  // namespace circumspect::check
