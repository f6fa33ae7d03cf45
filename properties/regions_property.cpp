// Regions against walking from cell to cell of a triangulation whose facets the walls are. Book:
// Section 4.5.1.
#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties {
namespace {

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
    for (const auto of_facet : ByFacet(uses)) {
      if (*rc::gen::inRange(0, 10) < share) walls.push_back(of_facet.front().facet);
    }
  }

  // The cells, and last of all the outside, joined where no wall parts them.
  DisjointSets joined() const {
    DisjointSets sets(cells.size() + 1);
    const std::set<Simplex> walled(walls.begin(), walls.end());
    for (const auto of_facet : ByFacet(uses)) {
      if (walled.contains(of_facet.front().facet)) continue;
      sets.unite(of_facet.front().simplex,
                 of_facet.size() == 2 ? of_facet.back().simplex : cells.size());
    }
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
  for (const auto of_facet : ByFacet(uses)) {
    if (!walled.contains(of_facet.front().facet)) continue;
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
  }
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
