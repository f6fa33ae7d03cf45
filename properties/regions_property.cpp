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
#include "kernel/predicates/intersection.hpp"
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
    const auto found = regions.region_at(barycentre(points, cells[i]));
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

// Where a segment meets a wall, and how.
struct Met {
  std::optional<Point> at = {};  // one of the points
  bool is_crossing = false;      // in the interior of the wall, from one side to the other
  bool is_in_its_plane = false;  // is the segment?
};
Met meeting_of(const WallSet& walls, std::size_t wall, const Point& from, const Point& to) {
  const std::vector<Point> corners = walls.corners(wall);
  const std::vector<Point> common = intersection(corners, {from, to});
  Met met{.is_in_its_plane = walls.side_of(wall, from) == 0 && walls.side_of(wall, to) == 0};
  if (common.empty()) return met;
  met.at = common.front();
  met.is_crossing = !met.is_in_its_plane;
  for (std::size_t place = 0; place < corners.size(); ++place) {
    std::vector<Point> facet = corners;
    facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(place));
    if (!intersection(facet, {common.front()}).empty()) met.is_crossing = false;
  }
  return met;
}

void assert_crossings(const WallSet& walls, const Point& from, const Point& to) {
  bool may_be_none = false, must_be_none = false;
  std::map<std::size_t, Point> expected;
  for (std::size_t wall = 0; wall < walls.size(); ++wall) {
    const Met met = meeting_of(walls, wall, from, to);
    may_be_none |= met.is_in_its_plane;
    must_be_none |= met.at && !met.is_crossing;
    if (met.is_crossing) expected.emplace(wall, *met.at);
  }
  const auto found = walls.crossings(from, to);
  RC_ASSERT(!(found && must_be_none));
  RC_ASSERT(found || must_be_none || may_be_none);
  if (!found) return;
  RC_ASSERT(found->size() == expected.size());
  for (std::size_t i = 0; i < found->size(); ++i) {
    const Crossing& one = (*found)[i];
    const bool is_later = i == 0 || (*found)[i - 1].at <= one.at;
    RC_ASSERT(is_later);
    RC_ASSERT(expected.contains(one.wall));
    const Point at = from + one.at * (to - from);
    RC_ASSERT(at == expected[one.wall]);
    RC_ASSERT(one.from_front == (walls.side_of(one.wall, from) > walls.side_of(one.wall, to)));
  }
}

// From the middle of a wall: as far as no other wall is met, and not half of that.
void assert_free_part(const WallSet& walls, std::size_t own, const Point& way) {
  const Point from = walls.centre(own);
  const auto meets_another = [&](const Rational& part) {
    bool meets = false;
    for (std::size_t wall = 0; wall < walls.size(); ++wall) {
      meets |= wall != own && meeting_of(walls, wall, from, from + part * way).at;
    }
    return meets;
  };
  bool may_be_none = false;
  for (std::size_t wall = 0; wall < walls.size(); ++wall) {
    may_be_none |= meeting_of(walls, wall, from, from + way).is_in_its_plane;
  }
  const auto part = walls.free_part(from, way);
  RC_ASSERT(part || may_be_none);
  RC_ASSERT(!part || walls.side_of(own, from + way) != 0);
  if (!part) return;
  RC_ASSERT(!meets_another(*part));
  RC_ASSERT(*part == 1 || meets_another(2 * *part));
}

// The ends are vertices or midway between some, where much is in one line or one plane.
TEST_CASE("a way crosses walls in inner points of them, or is none") {
  for (const std::size_t d : {2u, 3u}) {
    CAPTURE(d);
    CHECK(holds("ways through facets of a triangulation", 120, [d] {
      const std::vector<Point> points = *generators::any_point_set(d, 9);
      RC_PRE(PointSet(points).dimension() == static_cast<int>(d));
      const Arrangement arrangement(points, 5);
      RC_PRE(!arrangement.walls.empty());
      const WallSet walls(arrangement.points, arrangement.walls);
      const auto any = [&] {
        std::vector<Point> some;
        for (long more = *generators::below(3); more >= 0; --more) {
          some.push_back(points[static_cast<std::size_t>(*generators::below(std::ssize(points)))]);
        }
        return barycentre(some);
      };
      for (int i = 0; i < 8; ++i) {
        const Point from = any(), to = any();
        if (from == to) continue;
        assert_crossings(walls, from, to);
        const auto own =
            static_cast<std::size_t>(*generators::below(std::ssize(arrangement.walls)));
        assert_free_part(walls, own, to - from);
      }
    }));
  }
}

}  // namespace
}  // namespace circumspect::properties
