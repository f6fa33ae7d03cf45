// Vertices that are inserted into CDTs. Book: Section 5.7.
#include "reference/constrained/vertex_in_cdt.hpp"

#include <doctest/doctest.h>

#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"

namespace circumspect::constrained {

// Inserting a vertex into a CDT, and why it cannot be done. Book: Section 5.7.

namespace {

struct Start {
  EvolvingCdt cdt;
  PointSet larger;  // the same points and the one to be inserted
  Vertex v;
};

Start start(const std::vector<Point>& points, const std::vector<std::vector<Vertex>>& polygons,
            const std::vector<std::vector<Vertex>>& segments, const Point& point) {
  PiecewiseLinearInput input{points, segments, {}, {}, DomainKind::kHull};
  for (const auto& line : polygons) input.polygons.push_back({{line}, {}});
  std::vector<Point> more = points;
  more.push_back(point);
  return {hull_cdt_by_polygon_insertion(assemble(input)).value(), PointSet(more),
          static_cast<Vertex>(points.size())};
}

// Inserts the vertex, and deletes it again, which must restore; or why it cannot be.
std::optional<NoChange> answer_to_insertion(Start& s) {
  const EvolvingCdt before = s.cdt;
  const auto wrong = insert_vertex(s.larger, s.cdt, s.v);
  if (wrong) {
    CHECK(s.cdt == before);
    return wrong;
  }
  EvolvingCdt back = s.cdt;
  CHECK(!delete_vertex(s.larger, back, s.v));
  CHECK(back == before);
  return std::nullopt;
}

const std::vector<Point> kPierced = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {1, 1, -1}};

TEST_CASE("a wall keeps its far side as it is") {
  Start s = start(kPierced, {{0, 1, 2}}, {}, {1, 1, Rational(1, 2)});
  CHECK(!answer_to_insertion(s));
  CHECK(s.cdt.tetrahedra.star({5}).size() == 4);
  CHECK(s.cdt.tetrahedra.has({0, 1, 2, 4}));
}

TEST_CASE("in a polygon, in the hull and in a segment") {
  Start s = start(kPierced, {{0, 1, 2}}, {}, {1, 1, 0});
  CHECK(!answer_to_insertion(s));
  CHECK(s.cdt.walls == std::set<Simplex>{{0, 1, 5}, {0, 2, 5}, {1, 2, 5}});
  CHECK(s.cdt.tetrahedra.size() == 6);

  s = start(kPierced, {{0, 1, 2}, {0, 1, 3}}, {}, {1, 0, 0});
  CHECK(!answer_to_insertion(s));
  CHECK(s.cdt.segments.contains({0, 5}));
  CHECK(s.cdt.segments.contains({1, 5}));
  CHECK(!s.cdt.segments.contains({0, 1}));
  CHECK(s.cdt.walls == std::set<Simplex>{{0, 2, 5}, {0, 3, 5}, {1, 2, 5}, {1, 3, 5}});

  // In the middle of the facet 0 1 3 of the hull.
  s = start(kPierced, {{0, 1, 2}}, {}, {Rational(5, 3), Rational(1, 3), Rational(1, 3)});
  CHECK(!answer_to_insertion(s));
  CHECK(s.cdt.tetrahedra.size() == 4);
}

TEST_CASE("outside the hull, and there already") {
  Start s = start(kPierced, {}, {}, {9, 9, 9});
  CHECK(answer_to_insertion(s) == NoChange{WhyNoChange::kOutsideHull, {5}});
  s.v = 3;
  CHECK(answer_to_insertion(s) == NoChange{WhyNoChange::kVertexAlreadyThere, {3}});
}

TEST_CASE("a segment runs through the cavity") {
  // The segment 3 4 in the tetrahedra around it; the vertex is in all their balls.
  std::vector<Point> points = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, {0, 0, 8}, {0, 0, -8}};
  Start s = start(points, {}, {{3, 4}}, {0, Rational(1, 4), 0});
  CHECK(answer_to_insertion(s) == NoChange{WhyNoChange::kSegmentInCavity, {3, 4}});
}

TEST_CASE("a third sign: a cavity that is star-shaped and empty does not suffice") {
  // The new vertex lies beyond a segment at which two polygons meet.
  const std::vector<Point> points = {{1, 5, 3}, {0, 1, 3}, {0, 1, 4}, {2, 1, 3}, {1, 2, 2}};
  const Point point = {Rational(3, 4), 2, Rational(7, 2)};
  Start s = start(points, {{1, 2, 4}, {2, 3, 4}}, {}, point);
  CHECK(answer_to_insertion(s) == NoChange{WhyNoChange::kNotLocallyDelaunay, {2, 4, 5}});
  // There is no CDT, by gift-wrapping.
  PiecewiseLinearInput larger{
      s.larger.points(), {}, {{{{1, 2, 4}}, {}}, {{{2, 3, 4}}, {}}}, {}, DomainKind::kHull};
  CHECK(!gift_wrapping_cdt(assemble(larger)).has_value());
}

TEST_CASE("vertices that cannot be deleted") {
  Start s = start(kPierced, {{0, 1, 2}}, {}, {1, 1, Rational(1, 2)});
  CHECK(!insert_vertex(s.larger, s.cdt, 5));
  const EvolvingCdt before = s.cdt;
  CHECK(delete_vertex(s.larger, s.cdt, 0)->why == WhyNoChange::kVertexNeeded);
  CHECK(delete_vertex(s.larger, s.cdt, 4)->why == WhyNoChange::kExtremeVertex);
  CHECK(s.cdt == before);
  CHECK(!delete_vertex(s.larger, s.cdt, 5));
  CHECK(delete_vertex(s.larger, s.cdt, 5)->why == WhyNoChange::kVertexNeeded);
}

}  // namespace
}  // namespace circumspect::constrained
