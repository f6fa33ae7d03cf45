#include "reference/constrained/segment_insertion.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "reference/constrained/planar_domain.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/predicates/orientation.hpp"
#include "reference/predicates/perturbation.hpp"

namespace circumspect::constrained {
namespace {

// The vertices of a cavity in order along its boundary; an edge with the cavity on both sides is
// passed twice, and so is a vertex where the boundary touches itself.
using Chain = std::vector<Vertex>;

struct Cavities {
  std::vector<Simplex> crossed;
  Chain left, right;  // both from the first end of the segment to the second
};

class SegmentInsertion {
 public:
  SegmentInsertion(const PointSet& points, const std::vector<std::size_t>& axes,
                   const StarIndex& triangles)
      : points_(points), axes_(axes), triangles_(triangles) {}

  // Walks through the triangles that ab crosses.
  Cavities crossed_by(Vertex a, Vertex b) const {
    Cavities cavities{{}, {a}, {a}};
    Simplex edge = crossed_edge_at(a, b, cavities.crossed);
    while (true) {
      const Vertex left = side(a, b, edge[0]) > 0 ? edge[0] : edge[1];
      const Vertex right = left == edge[0] ? edge[1] : edge[0];
      if (cavities.left.back() != left) cavities.left.push_back(left);
      if (cavities.right.back() != right) cavities.right.push_back(right);
      const std::vector<Simplex> adjoining = triangles_.star(edge);
      assert(adjoining.size() == 2);
      const Simplex& next = adjoining[0] == cavities.crossed.back() ? adjoining[1] : adjoining[0];
      cavities.crossed.push_back(next);
      const Vertex apex = without(next, edge).front();
      if (apex == b) break;
      edge = sorted({apex, side(a, b, apex) > 0 ? right : left});
    }
    cavities.left.push_back(b);
    cavities.right.push_back(b);
    return cavities;
  }

  // Fills the cavity on the left of the edge from the chain's front to its back. All vertices of the
  // chain are visible from the edge, through the triangles that were there; so the first of them in
  // the pencil of circles through the edge is the apex of its triangle, which leaves two smaller
  // cavities of the same kind. (They wait in a list: one within the other they may be as many as the
  // chain is long, too many to call this function again for each.)
  void retriangulate(Chain chain, std::vector<Simplex>& created) const {
    std::vector<Chain> pending = {std::move(chain)};
    while (!pending.empty()) {
      const Chain cavity = std::move(pending.back());
      pending.pop_back();
      if (cavity.size() <= 2) continue;
      const std::size_t place = apex_place(cavity);
      created.push_back(sorted({cavity.front(), cavity[place], cavity.back()}));
      const auto middle = cavity.begin() + static_cast<std::ptrdiff_t>(place);
      pending.emplace_back(cavity.begin(), middle + 1);
      pending.emplace_back(middle, cavity.end());
    }
  }

 private:
  int side(Vertex a, Vertex b, Vertex c) const {
    if (a == c || b == c) return 0;
    return orientation(points_.configuration(), axes_, Simplex{a, b, c});
  }

  // The edge opposite a in the triangle through which ab leaves a.
  Simplex crossed_edge_at(Vertex a, Vertex b, std::vector<Simplex>& crossed) const {
    for (const Simplex& triangle : triangles_.star({a})) {
      const Simplex edge = without(triangle, {a});
      const int turn = side(a, edge[0], edge[1]);
      if (side(a, edge[0], b) == turn && side(a, b, edge[1]) == turn) {
        crossed.push_back(triangle);
        return edge;
      }
    }
    assert(!"an end of the segment is no vertex, or a vertex lies inside the segment");
    return {};
  }

  // Where the chain has the apex for the edge from its front to its back. It passes that vertex only
  // once: what it passes between two visits of a vertex u is visible from the edge between two points
  // from which u is, so it lies in the triangle of u and the edge, and comes before u in the pencil.
  std::size_t apex_place(const Chain& chain) const {
    const Vertex a = chain.front(), b = chain.back();
    std::optional<Vertex> apex;
    for (const Vertex v : chain) {
      if (side(a, b, v) <= 0 || v == apex) continue;
      const bool is_first =
          !apex || perturbed_in_ball(points_.configuration(), axes_, Simplex{a, b, *apex}, v) > 0;
      if (is_first) apex = v;
    }
    assert(apex && std::count(chain.begin(), chain.end(), *apex) == 1);
    return static_cast<std::size_t>(std::find(chain.begin(), chain.end(), *apex) - chain.begin());
  }

  const PointSet& points_;
  const std::vector<std::size_t>& axes_;
  const StarIndex& triangles_;
};

}  // namespace

StarIndex planar_delaunay(const PointSet& points, const std::vector<std::size_t>& axes,
                          const std::vector<Vertex>& vertices) {
  const std::vector<Simplex> hull = hull_edges(points, axes, vertices);
  if (hull.empty()) return StarIndex({});
  UnfinishedFacets unfinished;
  unfinished.add(OrientedFacet::of(hull.front()));
  unfinished.add(OrientedFacet::of(hull.front()).reverse());
  std::vector<Simplex> triangles = delaunay::gift_wrap(points, axes, unfinished, vertices);
  for (Simplex& triangle : triangles) triangle = sorted(std::move(triangle));
  return StarIndex(triangles);
}

void insert_segment(const PointSet& points, const std::vector<std::size_t>& axes,
                    StarIndex& triangles, const Simplex& segment) {
  if (triangles.size() == 0 || !triangles.star(segment).empty()) return;
  const SegmentInsertion insertion(points, axes, triangles);
  const Cavities cavities = insertion.crossed_by(segment[0], segment[1]);
  std::vector<Simplex> created;
  insertion.retriangulate(cavities.left, created);
  insertion.retriangulate(Chain(cavities.right.rbegin(), cavities.right.rend()), created);
  triangles.replace(cavities.crossed, created);
}

}  // namespace circumspect::constrained
