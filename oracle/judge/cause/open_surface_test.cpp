// Causes of surfaces that are open, and of points that were taken for others.
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "oracle/judge/cause/planted_faults_test.hpp"
#include "oracle/judge/cause/surface_edges.hpp"

namespace circumspect::check {
namespace {

// The surface of an octahedron, each triangle cut into four, all turned one way.
Lists octahedron() {
  Lists lists{{{8, 0, 0}, {-8, 0, 0}, {0, 8, 0}, {0, -8, 0}, {0, 0, 8}, {0, 0, -8}}, {}};
  std::map<std::pair<Vertex, Vertex>, Vertex> middles;
  const auto middle = [&](Vertex a, Vertex b) {
    const auto [known, is_new] = middles.emplace(std::pair(std::min(a, b), std::max(a, b)),
                                                 static_cast<Vertex>(lists.points.size()));
    if (is_new) lists.points.push_back(barycentre({lists.at(a), lists.at(b)}));
    return known->second;
  };
  for (Vertex octant = 0; octant < 8; ++octant) {
    Simplex corners = {octant & 1, 2 + (octant >> 1 & 1), 4 + (octant >> 2)};
    const bool is_turned = ((octant & 1) + (octant >> 1 & 1) + (octant >> 2)) % 2 == 1;
    if (is_turned) std::swap(corners[0], corners[1]);
    const Vertex a = corners[0], b = corners[1], c = corners[2];
    const Vertex ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (Simplex triangle : {Simplex{ab, bc, ca}, {a, ab, ca}, {ab, b, bc}, {ca, bc, c}}) {
      lists.simplices.push_back(std::move(triangle));
    }
  }
  return lists;
}

std::string named_as_closed(const Lists& lists) {
  Options options;
  options.complex.closed = true;
  options.complex.oriented = Orientations::kSame;
  return named(lists, Claim::kComplex, options);
}

void remove(Lists& lists, const std::vector<std::size_t>& places) {
  std::vector<Simplex> kept;
  for (std::size_t i = 0; i < lists.simplices.size(); ++i) {
    const bool goes = std::find(places.begin(), places.end(), i) != places.end();
    if (!goes) kept.push_back(lists.simplices[i]);
  }
  lists.simplices = std::move(kept);
}

TEST_CASE("causes: holes of a surface") {
  CHECK(named_as_closed(octahedron()) == "none");
  Lists lists = octahedron();
  remove(lists, {0});
  CHECK(named_as_closed(lists) == "missing-simplex: 1 triangle is missing: 6 7 8 fills the hole");
  lists = octahedron();
  remove(lists, {0, 28});
  CHECK(
      named_as_closed(lists).starts_with("missing-simplex: 2 triangles are missing: 6 7 8 and 1 "
                                         "more fill the holes"));
  lists = octahedron();
  remove(lists, {0, 1});
  CHECK(named_as_closed(lists) == "holes: the 4 open edges go around 1 hole");
  lists = octahedron();
  remove(lists, {0, 1, 29});
  CHECK(named_as_closed(lists) == "holes: the 7 open edges go around 2 holes, 3 to 4 around each");
  // Two holes that meet in a vertex are none that edges go around.
  lists = octahedron();
  remove(lists, {1, 2});
  CHECK(named_as_closed(lists) == "none");
}

// The triangles on one side of x = 0 have the middle of an edge to themselves, a little further.
Lists split(const Rational& moved) {
  Lists lists = octahedron();
  std::map<Vertex, Vertex> own;
  for (Simplex& simplex : lists.simplices) {
    if (barycentre(lists.corners(simplex))[0] < 0) continue;
    for (Vertex& v : simplex) {
      const Point point = lists.at(v);
      if (v < 6 || point[0] != 0 || point[1] < 0 || point[2] < 0) continue;
      const auto [twin, is_new] = own.emplace(v, static_cast<Vertex>(lists.points.size()));
      if (is_new) {
        lists.points.push_back(point);
        lists.points.back()[0] += moved;
      }
      v = twin->second;
    }
  }
  return lists;
}

TEST_CASE("causes: what repeats a vertex or names no points is no triangle with edges") {
  const std::vector<Point> points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const std::vector<Simplex> none = {{0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {2, 2, 2}, {0, 1, 3}};
  CHECK(edge_uses(listed_mesh(points, none)).empty());
  std::vector<Simplex> one = none;
  one.insert(one.begin(), {2, 0, 1});
  const std::vector<EdgeUse> uses = edge_uses(listed_mesh(points, one));
  REQUIRE(uses.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(uses[i].low == (i == 2 ? 1 : 0));
    CHECK(uses[i].high == (i == 0 ? 1 : 2));
    CHECK(uses[i].goes_up == (i != 1));
  }
}

TEST_CASE("causes: cracks of a surface") {
  const Rational little(1, 1'000'000);
  CHECK(named_as_closed(split(little)) ==
        "cracks: 4 of 4 open edges are the sides of cracks, at most 1.0e-06 wide, as if their "
        "vertices had been rounded: joined, the surface is closed");
  Lists lists = split(little);
  remove(lists, {16});
  CHECK(named_as_closed(lists) ==
        "cracks: 4 of 7 open edges are the sides of cracks, at most 1.0e-06 wide, as if their "
        "vertices had been rounded: joined, the others remain in part");
  Options closed;
  closed.complex.closed = true;
  CHECK(text_of(causes_of(lists, Claim::kComplex, closed)) ==
        "cracks 4 of 7\nmissing-simplex 3 of 7\n");
  // What is wide is a hole.
  CHECK(named_as_closed(split(1)) == "holes: the 4 open edges go around 1 hole");
}

TEST_CASE("causes: triangles of a surface that are turned over") {
  Lists lists = octahedron();
  std::swap(lists.simplices[5][0], lists.simplices[5][1]);
  CHECK(named_as_closed(lists) ==
        "turned-over: 1 of 32 triangles is turned over against its neighbours: swap two of its "
        "vertices");
  for (const std::size_t place : {6U, 7U}) {
    std::swap(lists.simplices[place][0], lists.simplices[place][1]);
  }
  CHECK(named_as_closed(lists).starts_with("turned-over: 3 of 32 triangles are turned over"));
  // A strip of five triangles with a half twist.
  lists = {{{0, 0, 0}, {4, 0, 1}, {5, 4, 2}, {2, 6, 5}, {-2, 3, 7}}, {}};
  for (Vertex i = 0; i < 5; ++i) lists.simplices.push_back({i, (i + 1) % 5, (i + 2) % 5});
  Options options;
  options.complex.oriented = Orientations::kSame;
  CHECK(named(lists, Claim::kComplex, options).starts_with("one-sided: the surface has one side"));
}

TEST_CASE("causes: whichever triangle of a surface is turned over, it is one") {
  for (std::size_t place = 0; place < 32; ++place) {
    Lists lists = octahedron();
    std::swap(lists.simplices[place][0], lists.simplices[place][1]);
    CHECK(named_as_closed(lists).starts_with("turned-over: 1 of 32 triangles is turned over"));
  }
}

TEST_CASE("causes: points that were taken for others") {
  const Rational little(1, 1'000'000'000);
  for (const Claim claim : {Claim::kTriangulation, Claim::kDelaunay}) {
    Lists lists = grid<2>(5);
    Point point = lists.at(7);
    point[0] += little;
    lists.points.insert(lists.points.begin(), point);
    for (Simplex& simplex : lists.simplices) {
      for (Vertex& v : simplex) ++v;
    }
    CHECK(named(lists, claim) ==
          "near-points: 1 point is in no triangle, and at most 1.0e-09 from another point, as if "
          "taken for it: without it the claim holds");
    lists.points.push_back(lists.at(9) - Point{little, little});
    CHECK(named(lists, claim).ends_with("as if taken for that: without them the claim holds"));
    // One that is far was left out for another reason.
    lists.points.push_back({Rational(3, 2), Rational(5, 4)});
    CHECK(named(lists, claim) == "none");
    lists.points.pop_back();
    // They are not all that is wrong.
    lists.at(18)[0] += Rational(9, 4);
    for (const Cause& cause : causes_of(lists, claim)) {
      CHECK(cause.words.find("the claim holds") == std::string::npos);
      if (cause.name == "near-points") CHECK(cause.explains == 2);
    }
  }
}

}  // namespace
}  // namespace circumspect::check
