// What the other properties rest on: random complexes are valid, those that are said to be edge-
// protected are, in the reading that is said, and each family holds what it is there for.
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
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "properties/arguments/complexes.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/constrained/edge_protection.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties {
namespace {

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

}  // namespace
}  // namespace circumspect::properties
