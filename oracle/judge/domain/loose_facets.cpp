#include "oracle/judge/domain/loose_facets.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "kernel/boxes/box_index.hpp"
#include "kernel/complex/measure.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/points/triangulation.hpp"

namespace circumspect::check {

namespace {

// Where points are that follow each other closely: if no wall is between a point and the one before
// it, both are in one region.
class PointsInTurn {
 public:
  explicit PointsInTurn(const Regions& regions) : regions_(regions) {}

  bool is_out(const Point& point) {
    if (!before_ || !nothing_between(*before_, point)) where_ = regions_.locate(point);
    before_ = point;
    return where_ == Where::kOutside || where_ == Where::kHole;
  }

 private:
  bool nothing_between(const Point& from, const Point& to) const {
    const auto crossed = regions_.walls().crossings(from, to);
    return crossed && crossed->empty();
  }

  const Regions& regions_;
  std::optional<Point> before_;
  Where where_ = Where::kOnWall;
};

// Where a simplex or its loose facet leaves the domain, by the barycentre; nothing if neither does.
std::optional<Point> point_outside(const MeshedDomain& in, const FacetUse& use,
                                   PointsInTurn& points) {
  for (const Simplex& cell : {in.mesh.simplices[use.simplex], use.facet}) {
    Point middle = barycentre(in.mesh.points, cell);
    if (points.is_out(middle)) return middle;
  }
  return std::nullopt;
}

class LooseFacets {
 public:
  LooseFacets(const MeshedDomain& in, const std::vector<FacetUse>& facets)
      : in_(in), facets_(facets), index_(boxes_of_vertices()), hanging_(facets.size()) {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const Box box = box_around_all(coordinates(in.mesh.points, facets_[f].facet));
      for (const std::size_t place : index_.meeting(box)) {
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

  // Is a vertex in the closed facet?
  bool lies_in(Vertex v, std::size_t f) const {
    const Simplex& facet = facets_[f].facet;
    return circumspect::lies_in(in_.mesh.points.configuration(), facet, v);
  }

  // The facets with hanging vertices that hold all of another one, with simplices on opposite
  // sides.
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
    const BoundaryFacet facet = boundary_facet(in_.mesh, whole);
    return side_of(in_.mesh.points.configuration(), facet, apex(part)) < 0;
  }

  // Do parts of a facet, which meet edge to edge or are at fault themselves, measure as much as it?
  bool is_filled(const FacetUse& whole, const std::vector<Simplex>& parts) const {
    const auto axes = axes_of(in_.mesh.points.configuration(), whole.facet);
    return measure(in_.mesh.points, axes, parts) == measure(in_.mesh.points, axes, whole.facet);
  }

  // A hanging vertex is in the facet's simplex without being a vertex of it, and is a vertex of
  // another.
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
  PointsInTurn points(in.regions);
  for (const FacetUse& use : loose) {
    if (const auto middle = point_outside(in, use, points)) {
      outside.add(use.simplex, {.face = use.facet, .point = middle}, verdict);
    } else {
      inside.push_back(use);
    }
  }
  if (!inside.empty()) LooseFacets(in, inside).judge(verdict);
}

}  // namespace circumspect::check
