#include "reference/constrained/gift_wrapping_cdt.hpp"

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/visibility.hpp"
#include "kernel/predicates/orientation.hpp"
#include "reference/constrained/clear_apex.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/gift_wrapping.hpp"
#include "reference/delaunay/unfinished_facets.hpp"

namespace circumspect::constrained {

namespace {

const std::vector<std::size_t> kAxesOfSpace = {0, 1, 2};

class SpatialWrapping {
 public:
  explicit SpatialWrapping(const PiecewiseLinearComplex& complex)
      : complex_(complex),
        points_(complex.points),
        walls_(triangulated_polygons(complex)),
        edges_of_walls_(edges_of(walls_)),
        regions_(points_, walls_, complex.hole_seeds, complex.kind),
        polygons_(points_, kAxesOfSpace, walls_),
        segments_(points_, kAxesOfSpace, segments_apart()) {}

  tl::expected<PlcTriangulation, NoCdt> run(const Progress& progress) {
    std::optional<NoCdt> failure = wrap(progress);
    if (!failure) failure = what_is_wrong();
    if (failure) return tl::unexpected(*failure);
    return with_dangling(tetrahedra_, cells());
  }

 private:
  // The segments that are in no polygon.
  std::vector<Simplex> segments_apart() const {
    std::vector<Simplex> apart;
    for (const Simplex& segment : complex_.segments) {
      if (!edges_of_walls_.contains(segment)) apart.push_back(segment);
    }
    return apart;
  }

  // The sides of polygons that are in the domain. Without any polygon, a facet of the hull.
  UnfinishedFacets seeds() const {
    UnfinishedFacets seeds;
    for (const Simplex& wall : walls_) {
      const OrientedFacet facet = OrientedFacet::of(wall);
      for (const OrientedFacet& side : {facet, facet.reverse()}) {
        if (regions_.faces_inside(side)) seeds.add(side);
      }
    }
    if (walls_.empty() && complex_.kind == DomainKind::kHull && points_.dimension() == 3) {
      const OrientedFacet facet = OrientedFacet::of(delaunay::hull_facet_seed(points_));
      seeds.add(facet);
      seeds.add(facet.reverse());
    }
    return seeds;
  }

  bool is_inside(const Simplex& simplex) const {
    return regions_.locate(barycentre(points_, simplex)) == Where::kInside;
  }

  // Finishes facets until none is left, and collects the tetrahedra.
  std::optional<NoCdt> wrap(const Progress& progress) {
    const std::vector<Vertex> all = all_vertices(points_);
    const auto is_clear = [&](const Simplex& simplex) { return polygons_.is_clear(simplex); };
    UnfinishedFacets unfinished = seeds();
    SimplexDictionary dictionary;
    while (!unfinished.empty()) {
      tell(progress, "tetrahedra found", dictionary.size());
      const OrientedFacet facet = unfinished.first();
      const InFront in_front = first_clear_apex(points_, kAxesOfSpace, facet, all, is_clear);
      if (!in_front.has_candidates && complex_.kind == DomainKind::kHull) {
        unfinished.remove(facet);
        continue;
      }
      if (!in_front.apex) return why_unfinished(facet);
      const Simplex tetrahedron = join(facet, *in_front.apex);
      if (const auto failure = what_is_in_the_way(dictionary, tetrahedron)) return failure;
      dictionary.add(tetrahedron);
      unfinished.adjoin(tetrahedron);
    }
    tetrahedra_ = dictionary.simplices();
    for (Simplex& tetrahedron : tetrahedra_) tetrahedron = sorted(std::move(tetrahedron));
    std::sort(tetrahedra_.begin(), tetrahedra_.end());
    return std::nullopt;
  }

  std::optional<NoCdt> what_is_in_the_way(const SimplexDictionary& dictionary,
                                          const Simplex& tetrahedron) const {
    if (const auto segment = segments_.inside(tetrahedron)) {
      return NoCdt{WhyNoCdt::kSegmentCrosses, sorted(tetrahedron), *segment};
    }
    for (std::size_t place = 0; place < tetrahedron.size(); ++place) {
      const OrientedFacet side = OrientedFacet::opposite(tetrahedron, place);
      if (dictionary.adjacent(side)) {
        return NoCdt{WhyNoCdt::kSimplicesOverlap, side.vertices, {}};
      }
    }
    return std::nullopt;
  }

  // Is some vertex in front visible from the facet? Then the tetrahedron that should be there, with
  // the first such vertex, is crossed by a polygon.
  NoCdt why_unfinished(const OrientedFacet& facet) const {
    const Regions regions(complex_);
    if (respects(complex_, regions, facet.vertices)) {
      const auto counts = [&](const Simplex& tetrahedron) {
        const Vertex apex = without(tetrahedron, facet.vertices).front();
        return is_visible(complex_, regions, apex, facet.vertices);
      };
      const auto apex =
          first_clear_apex(points_, kAxesOfSpace, facet, all_vertices(points_), counts).apex;
      if (apex) {
        const Simplex tetrahedron = join(facet, *apex);
        return {WhyNoCdt::kPolygonCrosses, sorted(tetrahedron),
                polygons_.inside(tetrahedron).value()};
      }
    }
    return {WhyNoCdt::kFacetUnfinished, facet.vertices, {}};
  }

  // Is the result of the wrapping a CDT?
  std::optional<NoCdt> what_is_wrong() const {
    if (complex_.kind == DomainKind::kHull && !tetrahedra_.empty() && !is_covered_once()) {
      return NoCdt{WhyNoCdt::kSimplicesOverlap, tetrahedra_.front(), {}};
    }
    if (const auto missing = what_is_missing()) return missing;
    return where_not_locally_delaunay();
  }

  // A sample point, inside the first tetrahedron: is it in the domain, and in no other?
  bool is_covered_once() const {
    const Point sample = barycentre(points_, tetrahedra_.front());
    if (regions_.locate(sample) != Where::kInside) return false;
    const auto holds_sample = [&](const Simplex& tetrahedron) {
      return holds(points_, tetrahedron, sample);
    };
    return std::count_if(tetrahedra_.begin(), tetrahedra_.end(), holds_sample) == 1;
  }

  // No vertex ever lies in a tetrahedron without being one of its vertices. Suppose that a vertex u
  // lies in such a way in t, and that t was made in front of the facet f. If u is off f, its
  // simplex with f is part of t, so it is clear; and u is in the ball of t, so it comes before the
  // apex of t. If u is in f, it lies in the tetrahedron behind f as well, which was there before.
  // (In a seed there is none.)
  std::optional<NoCdt> what_is_missing() const {
    const std::set<Simplex> edges = edges_of(tetrahedra_);
    std::set<Vertex> vertices = vertices_of(tetrahedra_);
    vertices.merge(vertices_of(complex_.segments));
    for (const Simplex& segment : segments_apart()) {
      if (edges.contains(segment) || !is_inside(segment)) continue;
      return NoCdt{WhyNoCdt::kSegmentMissing, {}, segment};
    }
    for (const Vertex v : all_vertices(points_)) assert(vertices.contains(v) || !is_inside({v}));
    return std::nullopt;
  }

  std::optional<NoCdt> where_not_locally_delaunay() const {
    const StarIndex triangulation(tetrahedra_);
    const auto facet = facet_not_locally_delaunay(points_, triangulation, facets_of(tetrahedra_),
                                                  {walls_.begin(), walls_.end()});
    if (!facet) return std::nullopt;
    const Vertex beyond = triangulation.link(*facet).back().front();
    return NoCdt{WhyNoCdt::kNotLocallyDelaunay, *facet, {beyond}};
  }

  // The walls, segments and vertices; some of them may dangle.
  std::set<Simplex> cells() const {
    std::set<Simplex> cells(walls_.begin(), walls_.end());
    cells.insert(complex_.segments.begin(), complex_.segments.end());
    for (const Vertex v : all_vertices(points_)) cells.insert({v});
    return cells;
  }

  const PiecewiseLinearComplex& complex_;
  const PointSet& points_;
  std::vector<Simplex> walls_;
  std::set<Simplex> edges_of_walls_;
  Regions regions_;
  Obstacles polygons_;
  Obstacles segments_;
  std::vector<Simplex> tetrahedra_;
};

}  // namespace

std::vector<Simplex> triangulated_polygons(const PiecewiseLinearComplex& complex) {
  std::vector<Simplex> triangles;
  for (const Polygon& polygon : complex.polygons) {
    const std::vector<Simplex> more = planar_cdt(complex.points, polygon);
    triangles.insert(triangles.end(), more.begin(), more.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

tl::expected<PlcTriangulation, NoCdt> gift_wrapping_cdt(const PiecewiseLinearComplex& complex,
                                                        const Progress& progress) {
  return SpatialWrapping(complex).run(progress);
}

}  // namespace circumspect::constrained
