// Event times. Book: Section 5.8, Certify.
#include "reference/constrained/event_time.hpp"

#include <doctest/doctest.h>

namespace circumspect::constrained {
namespace {

// Three tetrahedra around the edge 3 4, which pierces the triangle 0 1 2.
struct Pierced {
  PointSet points{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1, 1, -1}}};
  Polygon triangle{{0, 1, 2}, {{0, 1}, {0, 2}, {1, 2}}, {}, {0, 1}, {{0, 1, 2}}};
  PolygonInSpace polygon{points, triangle};
};

TEST_CASE("when two tetrahedra become cohyperplanar, to the last infinitesimal") {
  const Pierced p;
  // (p3 + p4) / 2 = p0 / 2 + p1 / 4 + p2 / 4; the means of |v|² are 3 and 8, the vertex on the right
  // is at distance 1, so 3 + κ/2 = 8.
  const auto time = event_time(p.polygon, {0, 1, 3, 4}, 2);
  REQUIRE(time.has_value());
  CHECK(time->standard == 10);
  // The lexicographic order is 0, 2, 4, 3, 1.
  const std::vector<std::pair<std::size_t, Rational>> infinitesimal = {
      {0, -1}, {1, Rational(-1, 2)}, {2, 1}, {3, 1}, {4, Rational(-1, 2)}};
  CHECK(time->infinitesimal == infinitesimal);
  // The other two facets at the edge belong to the same flip.
  CHECK(event_time(p.polygon, {0, 2, 3, 4}, 1) == time);
  CHECK(event_time(p.polygon, {1, 2, 3, 4}, 0) == time);
}

TEST_CASE("no event for a facet that will not have to go") {
  const Pierced p;
  CHECK(!event_time(p.polygon, {0, 1, 2, 3}, 4));
}

TEST_CASE("times are ordered by the first number in which they differ") {
  const EventTime early{1, {{0, 1}}}, late{2, {}};
  CHECK(early < late);
  const EventTime none{1, {}}, less{1, {{0, -1}}}, later{1, {{3, 1}}}, more{1, {{0, 1}, {3, -9}}};
  CHECK(less < none);
  CHECK(none < later);
  CHECK(later < more);
  CHECK(less < more);
  CHECK(more < early);
  CHECK(early == EventTime{1, {{0, 1}}});
}

}  // namespace
}  // namespace circumspect::constrained
