// Laws of polygons that are not flat: those that are joined are as flat as was asked, and what a
// rounded polygon is cut into has its boundary.
#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/judge/definition/distance.hpp"
#include "oracle/judge/within/moved_meshes_test.hpp"
#include "oracle/judge/within/nearly_coplanar.hpp"
#include "oracle/judge/within/rounded_polygons.hpp"

namespace circumspect::check {
namespace {

using generators::Dice;

Rational some_bits(Dice& dice, long most) { return bits(dice.within(-most, most)); }

// A sheet of triangles some bits off a plane or bent along a line; pages stand on some segments,
// some segments are listed, and a few points hover above.
PiecewiseLinearInput drawn_sheet(Dice& dice) {
  PiecewiseLinearInput sheet;
  const Rational bend = dice.below(3) == 0 ? Rational(1, 8) : Rational(0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      sheet.points.push_back({i, j, some_bits(dice, 3) + (i == 2 ? bend : Rational(0))});
    }
  }
  for (Vertex i = 0; i < 2; ++i) {
    for (Vertex j = 0; j < 2; ++j) {
      const Vertex a = 3 * i + j, b = a + 3, c = a + 4, d = a + 1;
      sheet.polygons.push_back({{{a, b, c}}, {}});
      sheet.polygons.push_back({{{a, c, d}}, {}});
    }
  }
  if (dice.below(2) == 0) {
    sheet.points.push_back({Rational(1, 2), Rational(1, 2), 1});
    sheet.polygons.push_back({{{0, 4, 9}}, {}});
  }
  if (dice.below(2) == 0) sheet.segments.push_back({1, 4});
  for (std::size_t more = dice.below(3); more > 0; --more) {
    const Rational x = Rational(static_cast<long>(1 + 2 * dice.below(4)), 4);
    sheet.points.push_back({x, Rational(static_cast<long>(more), 4), bits(dice.within(10L, 400L))});
  }
  return sheet;
}

// Makes no triangle more than 5 degrees with the first?
bool is_not_steep(const PiecewiseLinearComplex& complex, const Polygon& joined) {
  const auto normal = [&](const Simplex& triangle) {
    const std::vector<Point> t = coordinates(complex.points, triangle);
    return cross_product(t[1] - t[0], t[2] - t[0]);
  };
  const Point first = normal(joined.triangles.front());
  return std::all_of(joined.triangles.begin(), joined.triangles.end(), [&](const Simplex& t) {
    const Point other = normal(t);
    const Rational along = inner_product(first, other);
    return squared_length(cross_product(first, other)) <= Rational(77, 10'000) * along * along;
  });
}

// How far the vertices of some polygons are at most from the plane of the first triangle, squared.
Rational squared_height_of(const PiecewiseLinearComplex& complex, const Polygon& joined) {
  const std::vector<Point> t = coordinates(complex.points, joined.triangles.front());
  const Point normal = cross_product(t[1] - t[0], t[2] - t[0]);
  Rational most = 0;
  for (const Vertex v : joined.vertices) {
    const Rational height = inner_product(normal, complex.points[v] - t[0]);
    most = std::max(most, Rational(height * height / squared_length(normal)));
  }
  return most;
}

// The square of the nearest cell without a common vertex, if it is within a hundred heights.
std::optional<Rational> squared_room(const PiecewiseLinearComplex& complex, const Polygon& joined,
                                     const Rational& squared_height) {
  std::vector<Simplex> others;
  for (Vertex v = 0; complex.points.names(v); ++v) others.push_back({v});
  for (const Polygon& polygon : complex.polygons) {
    others.insert(others.end(), polygon.triangles.begin(), polygon.triangles.end());
  }
  std::optional<Rational> least;
  for (const Simplex& other : others) {
    const bool is_beside = std::any_of(other.begin(), other.end(),
                                       [&](Vertex v) { return contains(joined.vertices, v); });
    for (const Simplex& own : joined.triangles) {
      if (is_beside) continue;
      const Rational apart = definition::squared_distance_between(
          coordinates(complex.points, own), coordinates(complex.points, other));
      if (apart <= 10'000 * squared_height && (!least || apart < *least)) least = apart;
    }
  }
  return least;
}

TEST_CASE("polygons that are joined are as flat and as far from others as was asked") {
  std::size_t joined_sets = 0, limited = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const PiecewiseLinearInput input = drawn_sheet(dice);
    const PiecewiseLinearComplex complex = assemble(input);
    const std::vector<Simplex> listed = listed_segments(input);
    const Rational distance = dice.below(4) == 0 ? Rational(1, 4) : bits(dice.within(2L, 9L));
    const Flatness flatness{Rational(1, 20), distance * distance};
    const NearlyJoined joined = nearly_coplanar_polygons_joined(complex, listed, flatness);
    std::map<std::size_t, std::size_t> set_of;
    Rational highest = 0;
    std::optional<Rational> limit;
    for (std::size_t s = 0; s < joined.members.size(); ++s) {
      for (const std::size_t p : joined.members[s]) CHECK(set_of.emplace(p, s).second);
      if (joined.members[s].size() == 1) continue;
      ++joined_sets;
      const Polygon& polygon = joined.complex.polygons[s];
      CHECK(is_not_steep(complex, polygon));
      const Rational height = squared_height_of(complex, polygon);
      CHECK(height <= flatness.squared_distance);
      highest = std::max(highest, height);
      const auto room = squared_room(complex, polygon, height);
      if (!room) continue;
      CHECK(*room > 64 * height);
      if (!limit || *room / 32 < *limit) limit = *room / 32;
    }
    CHECK(set_of.size() == complex.polygons.size());
    CHECK(joined.squared_height == highest);
    CHECK(joined.squared_limit == limit);
    limited += limit ? 1 : 0;
    // A segment is gone iff two polygons have it, nobody lists it, and both are in one set.
    for (const Simplex& segment : complex.segments) {
      std::vector<std::size_t> sets;
      for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
        const auto& own = complex.polygons[p].segments;
        if (std::count(own.begin(), own.end(), segment) > 0) sets.push_back(set_of.at(p));
      }
      const bool is_listed = std::binary_search(listed.begin(), listed.end(), segment);
      const bool is_gone = !is_listed && sets.size() == 2 && sets[0] == sets[1];
      const auto& left = joined.complex.segments;
      CHECK(std::binary_search(left.begin(), left.end(), segment) != is_gone);
    }
  }
  CHECK(joined_sets > 10);
  CHECK(limited > 3);
}

// A polygon with a reflex corner, in a plane across an axis or a slanted one, seen from either
// side; each corner some bits off.
PiecewiseLinearInput drawn_rounded(Dice& dice, long off) {
  const std::vector<Point> flat = {{0, 0}, {6, 0}, {7, 5}, {3, 2}, {0, 6}};
  const std::vector<std::pair<Point, Point>> planes = {
      {{1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 0, 1}}, {{0, 0, 1}, {1, 0, 0}},
      {{1, 0, 0}, {0, 0, 1}}, {{0, 1, 0}, {1, 0, 0}}, {{1, 2, 0}, {0, -1, 3}}};
  const auto& [u, v] = planes[dice.below(planes.size())];
  PiecewiseLinearInput input;
  std::vector<Vertex> line;
  for (const Point& p : flat) {
    line.push_back(static_cast<Vertex>(input.points.size()));
    input.points.push_back(p[0] * u + p[1] * v);
    for (Rational& x : input.points.back()) x += some_bits(dice, off);
  }
  input.polygons.push_back({{line}, {}});
  return input;
}

TEST_CASE("a rounded polygon is cut up to its distance from a plane, and its pieces cover it") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    PiecewiseLinearInput input = drawn_rounded(dice, 4);
    const auto cut = rounded_polygons_cut(input, 1);
    REQUIRE(cut);
    CHECK(cut->cut == 1);
    CHECK(cut->input.polygons.size() == 3);
    CHECK(cut->cut_of == std::vector<std::size_t>(3, 0));
    std::map<Simplex, int> uses;
    for (const PolygonLines& piece : cut->input.polygons) {
      for (std::size_t i = 0; i < 3; ++i) {
        ++uses[sorted({piece.lines[0][i], piece.lines[0][(i + 1) % 3]})];
      }
    }
    const std::size_t corners = input.points.size();
    CHECK(uses.size() == corners + 2);
    for (std::size_t i = 0; i < corners; ++i) {
      CHECK(uses[sorted({static_cast<Vertex>(i), static_cast<Vertex>((i + 1) % corners)})] == 1);
    }
    // Each piece has the reflex corner: no other diagonals are inside.
    for (const PolygonLines& piece : cut->input.polygons) CHECK(contains(piece.lines[0], 3));
    CHECK(sign(cut->squared_height) > 0);
    CHECK(rounded_polygons_cut(input, cut->squared_height));
    CHECK(!rounded_polygons_cut(input, cut->squared_height - bits(1) * bits(1) * bits(1)));
    PiecewiseLinearInput twisted = input;  // its outline crosses itself
    std::swap(twisted.points[1], twisted.points[2]);
    CHECK(!rounded_polygons_cut(twisted, 1));
    PiecewiseLinearInput twice = input;
    twice.points[4] = twice.points[2];
    CHECK(!rounded_polygons_cut(twice, 1));
    const PiecewiseLinearInput flat = drawn_rounded(dice, 0);
    const auto same = rounded_polygons_cut(flat, 0);
    REQUIRE(same);
    CHECK(same->cut == 0);
    CHECK(same->input.polygons.size() == 1);
  }
}

}  // namespace
}  // namespace circumspect::check
