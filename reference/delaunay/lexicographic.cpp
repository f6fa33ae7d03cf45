#include "reference/delaunay/lexicographic.hpp"

#include <algorithm>

#include "kernel/complex/point_set.hpp"
#include "kernel/predicates/orientation.hpp"
#include "reference/delaunay/unfinished_facets.hpp"

namespace circumspect::delaunay {
namespace {

// The triangulation of the points inserted so far. Its unfinished facets are those of the hull, the
// outside in front.
class LexicographicTriangulation {
 public:
  explicit LexicographicTriangulation(const PointSet& points) : points_(points) {}

  // v is off the affine hull: joins v to everything. `axes` are coordinates of the larger hull.
  void raise_dimension(Vertex v, const std::vector<std::size_t>& axes) {
    axes_ = axes;
    if (simplices_.empty()) simplices_.push_back({});
    hull_ = {};
    for (Simplex& simplex : simplices_) {
      simplex = positively_oriented(points_, axes_, with_apex(simplex, v));
      hull_.adjoin(simplex);
    }
  }

  void join_to_visible_facets(Vertex v) {
    for (const OrientedFacet& facet : hull_.all()) {
      const Simplex simplex = join(facet, v);
      if (orientation(points_.configuration(), axes_, simplex) <= 0) continue;
      simplices_.push_back(simplex);
      hull_.adjoin(simplex);
    }
  }

  const std::vector<Simplex>& simplices() const { return simplices_; }

 private:
  const PointSet& points_;
  std::vector<std::size_t> axes_;
  std::vector<Simplex> simplices_;
  UnfinishedFacets hull_;
};

}  // namespace

Triangulation lexicographic(const PointSet& points) {
  if (points.empty()) return Triangulation(-1, {});
  std::vector<Vertex> order = all_vertices(points);
  std::sort(order.begin(), order.end(), [&](Vertex a, Vertex b) { return points[a] < points[b]; });
  // The first affinely independent points are those at which the dimension grows.
  const Simplex basis = flat_through(points, order).basis;
  LexicographicTriangulation triangulation(points);
  Simplex independent;
  for (const Vertex v : order) {
    if (contains(basis, v)) {
      independent.push_back(v);
      triangulation.raise_dimension(v, flat_through(points, independent).axes);
    } else {
      triangulation.join_to_visible_facets(v);
    }
  }
  return Triangulation(points.dimension(), triangulation.simplices());
}

}  // namespace circumspect::delaunay
