// Domains: the random ones, the triangles of their polygons, their regions. Book: Section 4.5.1.
#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <doctest/doctest.h>

#include "inputs/triangulated/protected_complexes.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/polygon_triangles.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "kernel/predicates/intersection.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "properties/arguments/complexes.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/constrained/edge_protection.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties {
namespace {

// ---- complexes ----
// What the other properties rest on: random complexes are valid, those that are said to be edge-
// protected are, in the reading that is said, and each family holds what it is there for.

using generators::ComplexCase;

using Counts = std::map<std::string, std::size_t>;

bool has_slit(const Polygon& polygon) {
  // An edge of the outline is in one of the polygon's triangles, a slit in two.
  return std::any_of(polygon.segments.begin(), polygon.segments.end(), [&](const Simplex& segment) {
    return std::count_if(polygon.triangles.begin(), polygon.triangles.end(), [&](const Simplex& t) {
             return std::includes(t.begin(), t.end(), segment.begin(), segment.end());
           }) == 2;
  });
}

void count(const ComplexCase& one, Counts& counts) {
  ++counts[one.family];
  const PiecewiseLinearComplex complex = one.complex();
  const Regions regions(complex);
  const std::set<Simplex> facets = [&] {
    const auto all = facets_of(delaunay::bowyer_watson(complex.points).simplices());
    return std::set<Simplex>(all.begin(), all.end());
  }();
  bool has_inside = false;
  for (std::size_t region = 1; region < regions.size(); ++region) {
    if (regions.where(region) == Where::kInside) has_inside = true;
    if (regions.where(region) == Where::kHole) ++counts["hole"];
  }
  if (complex.ambient_dimension() == 3 && complex.points.dimension() < 3) ++counts["flat"];
  if (complex.kind == DomainKind::kHull) ++counts["hull"];
  if (complex.kind == DomainKind::kEnclosed && has_inside) ++counts["enclosed"];
  if (regions.size() > 2) ++counts["several polyhedra"];
  for (const Polygon& polygon : complex.polygons) {
    if (polygon.vertices.size() > 3) ++counts["larger polygon"];
    if (!polygon.hole_seeds.empty()) ++counts["hole in polygon"];
    if (has_slit(polygon)) ++counts["slit"];
    if (polygon.triangles.size() == 1 && !facets.contains(polygon.triangles[0])) {
      ++counts["polygon to be recovered"];
    }
  }
}

void all_occur(Counts& counts, const std::vector<std::string>& kinds) {
  for (const std::string& kind : kinds) {
    CAPTURE(kind);
    CHECK(occurs(counts[kind]));
  }
}

TEST_CASE("random complexes are valid, and of many kinds") {
  Counts counts;
  CHECK(holds("validated", 200, [&] {
    const ComplexCase one = *generators::any_complex(12);
    RC_ASSERT(validated(one.input).has_value());
    count(one, counts);
  }));
  all_occur(counts, {"furnished box", "glued tetrahedra", "scattered cells", "twisted prism",
                     "hull", "enclosed", "hole", "several polyhedra", "larger polygon",
                     "hole in polygon", "slit", "polygon to be recovered"});
}

TEST_CASE("random complexes in the plane are valid, and of many kinds") {
  Counts counts;
  CHECK(holds("validated", 200, [&] {
    const ComplexCase one = *generators::planar_complexes(14);
    RC_ASSERT(validated(one.input).has_value());
    count(one, counts);
  }));
  all_occur(counts, {"hull", "enclosed", "hole", "several polyhedra"});
}

TEST_CASE("protected complexes are edge-protected, in two readings (Section 4.5.3)") {
  Counts counts;
  CHECK(holds("is_edge_protected", 200, [&] {
    const ComplexCase one = *any_protected_complex(10);
    const PiecewiseLinearComplex complex = one.complex();
    RC_ASSERT(validated(one.input).has_value());
    RC_ASSERT(constrained::is_edge_protected_under_perturbation(complex));
    count(one, counts);
    ++counts[constrained::is_edge_protected(complex) ? "strongly" : "canonically only"];
  }));
  CHECK(holds("is_edge_protected", 30, [] {
    const ComplexCase one = *generators::generated([](generators::Dice& dice) {
      std::vector<Point> points =
          generators::rather_large(3, [&] { return generators::degenerate_points(dice, 3, {9}); });
      return dice.below(2) == 0 ? protected_polygons(dice, std::move(points), Protection::kStrong)
                                : protected_solid(dice, std::move(points), Protection::kStrong);
    });
    RC_ASSERT(constrained::is_edge_protected(one.complex()));
  }));
  all_occur(counts, {"protected polygons", "protected solid", "Delaunay polyhedron", "hull",
                     "enclosed", "several polyhedra", "larger polygon", "slit",
                     "polygon to be recovered", "strongly", "canonically only"});
}

// ---- polygon triangles ----
// The plane sweep that cuts polygons into triangles: on any points and segments it makes a
// triangulation of their convex hull that has the segments for edges.

using generators::below;

Rational twice_area(const PointSet& points, const std::vector<std::size_t>& axes, Vertex a,
                    Vertex b, Vertex c) {
  return orientation_determinant(points.configuration(), axes, Simplex{a, b, c});
}

// Twice the area of the convex hull: every hull edge has all vertices on its left or in its line.
Rational twice_hull_area(const PointSet& points, const std::vector<std::size_t>& axes) {
  Rational area = 0;
  const std::vector<Vertex> all = all_vertices(points);
  for (const Vertex a : all) {
    for (const Vertex b : all) {
      const bool is_edge =
          a != b && std::all_of(all.begin(), all.end(), [&](Vertex v) {
            if (v == a || v == b) return true;
            const int side = orientation(points.configuration(), axes, Simplex{a, b, v});
            return side > 0 ||
                   (side == 0 && !lies_inside_segment(points.configuration(), std::array{a, b}, v));
          });
      // Around vertex 0, which may be on the hull; of a row of vertices only neighbours count.
      if (is_edge && a != 0 && b != 0) area += twice_area(points, axes, 0, a, b);
    }
  }
  return area;
}

// Different points of the plane z = x + 2y over a grid: coordinates on any two axes will do.
std::vector<Point> slanted_points(long side, std::size_t count) {
  std::set<Point> points;
  for (std::size_t tries = 0; tries < count; ++tries) {
    const Rational x = *below(side), y = *below(side);
    points.insert({x, y, x + 2 * y});
  }
  std::vector<Point> result(points.begin(), points.end());
  for (std::size_t i = result.size(); i > 1; --i) {
    std::swap(result[i - 1], result[static_cast<std::size_t>(*below(static_cast<long>(i)))]);
  }
  return result;
}

std::set<Simplex> some_segments(const PointSet& points, long count) {
  const Configuration& configuration = points.configuration();
  std::set<Simplex> segments;
  const auto size = static_cast<long>(points.size());
  for (; count > 0; --count) {
    const Simplex segment = sorted({*below(size), *below(size)});
    bool fits = segment[0] != segment[1];
    for (const Vertex v : all_vertices(points)) {
      fits = fits && (contains(segment, v) || !lies_inside_segment(configuration, segment, v));
    }
    for (const Simplex& other : segments) {
      const bool touch = contains(other, segment[0]) || contains(other, segment[1]);
      fits = fits && (touch || !segments_cross(configuration, segment, other));
    }
    if (fits) segments.insert(segment);
  }
  return segments;
}

TEST_CASE("triangulate_by_sweep: fills the hull, keeps the segments, face to face") {
  for (const std::vector<std::size_t>& axes : {std::vector<std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
    CAPTURE(axes[0] + axes[1]);
    CHECK(holds("points of a slanted plane", 300, [&] {
      const long side = *below(5) + 2;
      const PointSet points(slanted_points(side, static_cast<std::size_t>(*below(14)) + 3));
      const std::set<Simplex> segments = some_segments(points, *below(30));
      const auto triangles = triangulate_by_sweep(points, axes, all_vertices(points),
                                                  {segments.begin(), segments.end()});
      if (points.dimension() < 2) {
        RC_ASSERT(triangles.empty());
        return;
      }
      Rational area = 0;
      std::set<Vertex> corners;
      std::set<Simplex> edges;
      for (const Simplex& t : triangles) {
        const Rational twice = abs(twice_area(points, axes, t[0], t[1], t[2]));
        RC_ASSERT(sign(twice) > 0);
        area += twice;
        corners.insert(t.begin(), t.end());
        for (std::size_t i = 0; i < 3; ++i) edges.insert(facet_opposite(t, i));
        for (const Simplex& other : triangles) {
          const bool same = &other == &t;
          RC_ASSERT(same || !interiors_meet(points.configuration(), axes, t, other));
        }
      }
      // Disjoint, as large as the hull, and with no vertex inside an edge.
      RC_ASSERT(area == twice_hull_area(points, axes));
      RC_ASSERT(corners.size() == points.size());
      RC_ASSERT(std::is_sorted(triangles.begin(), triangles.end()));
      for (const Simplex& segment : segments) RC_ASSERT(edges.contains(segment));
      for (const Simplex& edge : edges) {
        for (const Vertex v : corners) {
          const bool is_end = contains(edge, v);
          RC_ASSERT(is_end || !lies_inside_segment(points.configuration(), edge, v));
        }
      }
    }));
  }
}

// ---- regions ----
// Regions against walking from cell to cell of a triangulation whose facets the walls are. Book:
// Section 4.5.1.

// Some facets of a triangulation, at random; many are dangling, some enclose something.
struct Arrangement {
  PointSet points;
  std::vector<Simplex> cells;
  std::vector<FacetUse> uses;
  std::vector<Simplex> walls;

  Arrangement(const std::vector<Point>& coordinates, int share)
      : points(coordinates),
        cells(delaunay::bowyer_watson(points).simplices()),
        uses(facet_uses(cells)) {
    for_each_facet(uses, [&](std::span<const FacetUse> of_facet) {
      if (*rc::gen::inRange(0, 10) < share) walls.push_back(of_facet.front().facet);
    });
  }

  // The cells, and last of all the outside, joined where no wall parts them.
  DisjointSets joined() const {
    DisjointSets sets(cells.size() + 1);
    const std::set<Simplex> walled(walls.begin(), walls.end());
    for_each_facet(uses, [&](std::span<const FacetUse> of_facet) {
      if (walled.contains(of_facet.front().facet)) return;
      sets.unite(of_facet.front().simplex,
                 of_facet.size() == 2 ? of_facet.back().simplex : cells.size());
    });
    return sets;
  }
};

void assert_same_regions(const Arrangement& arrangement) {
  const auto& points = arrangement.points;
  const auto& cells = arrangement.cells;
  const auto& uses = arrangement.uses;
  const auto& walls = arrangement.walls;
  const Regions regions(points, walls, {}, DomainKind::kEnclosed);
  DisjointSets expected = arrangement.joined();
  std::map<std::size_t, std::size_t> region_of;
  region_of[expected.find(cells.size())] = Regions::kUnbounded;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto found = regions.region_at(barycentre(coordinates(points, cells[i])));
    RC_ASSERT(found.has_value());
    RC_ASSERT(region_of.try_emplace(expected.find(i), *found).first->second == *found);
  }
  // As many as there are: so none are joined that are apart.
  RC_ASSERT(region_of.size() == regions.size());
  const std::set<Simplex> walled(walls.begin(), walls.end());
  for_each_facet(uses, [&](std::span<const FacetUse> of_facet) {
    if (!walled.contains(of_facet.front().facet)) return;
    for (const FacetUse& use : of_facet) {
      const Simplex cell = positively_oriented(points, cells[use.simplex]);
      const auto place = static_cast<std::size_t>(
          std::find(cell.begin(), cell.end(), cells[use.simplex][use.opposite]) - cell.begin());
      const OrientedFacet facet = OrientedFacet::opposite(cell, place);
      RC_ASSERT(regions.in_front_of(facet) == region_of.at(expected.find(use.simplex)));
      if (of_facet.size() == 1) {
        RC_ASSERT(regions.in_front_of(facet.reverse()) == Regions::kUnbounded);
      }
    }
  });
}

TEST_CASE("regions are what can be reached without crossing a wall (Section 4.5.1)") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("regions of some facets of a triangulation", 150, [d] {
      const std::vector<Point> points = *generators::any_point_set(d, 14);
      RC_PRE(PointSet(points).dimension() == static_cast<int>(d));
      assert_same_regions(Arrangement(points, *rc::gen::inRange(1, 10)));
    }));
  }
}

}  // namespace

}  // namespace circumspect::properties
