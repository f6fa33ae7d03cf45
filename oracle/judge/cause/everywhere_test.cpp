// A cause is named wherever in the mesh it is: at the first simplex and the last, along each axis,
// in large meshes too.
#include <algorithm>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "oracle/judge/cause/planted_faults_test.hpp"

namespace circumspect::check {
namespace {

std::string listed(const Simplex& simplex) {
  std::string words;
  for (const Vertex v : simplex) words += " " + std::to_string(v);
  return words;
}

// A vertex inside is the first one, or, as in the grid, a corner.
template <std::size_t kDimension>
void check_each_left_out(std::size_t side, bool is_inside_first) {
  Lists good = grid<kDimension>(side);
  if (is_inside_first) {
    Vertex inside = 0;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      inside = inside * static_cast<Vertex>(side) + 1;
    }
    std::rotate(good.points.begin(), good.points.begin() + inside, good.points.end());
    for (Simplex& simplex : good.simplices) {
      for (Vertex& v : simplex)
        v = (v + std::ssize(good.points) - inside) % std::ssize(good.points);
    }
  }
  const std::string noun = kDimension == 2 ? "triangle" : "tetrahedron";
  for (std::size_t s = 0; s < good.simplices.size(); ++s) {
    Lists lists = good;
    lists.simplices.erase(lists.simplices.begin() + static_cast<std::ptrdiff_t>(s));
    const std::string expected = "missing-simplex: 1 " + noun +
                                 " is missing:" + listed(sorted(good.simplices[s])) +
                                 " fills the hole";
    CHECK(named(lists, Claim::kTriangulation) == expected);
    CHECK(named(seen_otherwise(lists), Claim::kDelaunay) == expected);
  }
}

TEST_CASE("causes: whichever simplex is left out, it is missing") {
  for (const bool is_inside_first : {false, true}) {
    check_each_left_out<2>(4, is_inside_first);
    check_each_left_out<3>(3, is_inside_first);
  }
}

TEST_CASE("causes: whichever simplex inside is left out, it is missing, whatever else is wrong") {
  const Lists good = grid<2>(6);
  for (std::size_t s = 0; s < good.simplices.size(); ++s) {
    const Point middle = barycentre(good.corners(good.simplices[s]));
    const auto is_inside = [](const Rational& x) { return 1 < x && x < 4; };
    if (!std::all_of(middle.begin(), middle.end(), is_inside)) continue;
    Lists lists = good;
    lists.simplices.erase(lists.simplices.begin() + static_cast<std::ptrdiff_t>(s));
    std::erase_if(lists.simplices, [&](const Simplex& simplex) {
      const Point at = barycentre(lists.corners(simplex));
      return at[0] < 1 && 4 < at[1];
    });
    const std::string said = named(lists, Claim::kTriangulation);
    CHECK(said.starts_with("missing-simplex: 1 triangle is missing:" +
                           listed(sorted(good.simplices[s])) + " fills the hole"));
    CHECK(said.ends_with(" in part"));
  }
}

TEST_CASE("causes: what is missing in a large mesh explains the violations at its faces") {
  Lists lists = grid<2>(170);
  const Simplex lost = lists.simplices.back();
  lists.simplices.pop_back();
  REQUIRE(lists.simplices.size() > 50'000);
  const std::vector<Cause> all = causes_of(lists, Claim::kTriangulation);
  REQUIRE(all.size() == 1);
  CHECK(all.front().words == "1 triangle is missing:" + listed(sorted(lost)) + " fills the hole");
  CHECK(all.front().explains == all.front().of);
  CHECK(!all.front().of_listed);
  const Cause first = causes_of(lists, Claim::kTriangulation, {.max_violations = 1}).front();
  CHECK(first.of == 1);
  CHECK(first.explains == 1);
  CHECK(first.of_listed);
}

template <std::size_t kDimension>
void check_each_listed_again(std::size_t side) {
  const Lists good = grid<kDimension>(side);
  for (std::size_t s = 0; s < good.simplices.size(); ++s) {
    for (const bool is_first : {false, true}) {
      Lists lists = good;
      const Simplex again = good.simplices[s];
      lists.simplices.insert(is_first ? lists.simplices.begin() : lists.simplices.end(), again);
      CHECK(named(lists, Claim::kTriangulation)
                .ends_with("is listed twice:" + listed(again) + "; listed once, the claim holds"));
    }
  }
}

TEST_CASE("causes: whichever simplex is listed again, it is named") {
  check_each_listed_again<2>(4);
  check_each_listed_again<3>(3);
}

// The simplices across the facets opposite the vertex, if there is one across each.
std::vector<std::pair<Simplex, Vertex>> across(const Lists& lists, Vertex v) {
  std::vector<std::pair<Simplex, Vertex>> found;
  for (const Simplex& own : lists.simplices) {
    const auto at = std::find(own.begin(), own.end(), v);
    if (at == own.end()) continue;
    const Simplex facet = facet_opposite(own, static_cast<std::size_t>(at - own.begin()));
    for (const Simplex& other : lists.simplices) {
      if (contains(other, v) || !has_face(other, facet)) continue;
      const auto apex =
          std::find_if(other.begin(), other.end(), [&](Vertex w) { return !contains(facet, w); });
      found.emplace_back(facet, *apex);
    }
  }
  return found;
}

template <std::size_t kDimension>
void check_moved_across_each(std::size_t side) {
  const Lists good = grid<kDimension>(side);
  const auto is_inside = [side](const Rational& x) {
    return 0 < x && x < static_cast<long>(side) - 1;
  };
  for (Vertex v = 0; v < std::ssize(good.points); ++v) {
    const Point& place = good.points[static_cast<std::size_t>(v)];
    if (!std::all_of(place.begin(), place.end(), is_inside)) continue;
    if (kDimension == 3 && (place[0] != place[1] || place[0] != place[2])) continue;  // some
    for (const auto& [facet, apex] : across(good, v)) {
      Lists lists = good;
      const Point middle = barycentre(good.corners(facet));
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        lists.at(v)[axis] = (3 * middle[axis] + lists.at(apex)[axis]) / 4;
      }
      const std::string said = named(lists, Claim::kTriangulation);
      CAPTURE(said);
      CAPTURE(v);
      CHECK(said.find("name vertex " + std::to_string(v) + ", which is not between") != said.npos);
    }
  }
}

TEST_CASE("causes: an inner vertex that is moved across any facet opposite it is named") {
  check_moved_across_each<2>(5);
  check_moved_across_each<3>(4);
}

TEST_CASE("causes: a vertex of more than a thousand simplices is not tried elsewhere") {
  for (const long count : {900L, 1100L}) {
    Lists lists{{{5000, 1}}, {}};  // should be near (0, 0), in the middle of the others
    for (long i = 0; i < count; ++i) {
      const bool is_upper = 2 * i < count;
      const long x = is_upper ? count - 4 * i : 4 * i - 3 * count;
      lists.points.push_back({x, (is_upper ? 1 : -1) * Rational(count * count - x * x, count)});
      lists.simplices.push_back({0, i + 1, (i + 1) % count + 1});
    }
    // Around it are as many triangles again, so that it is not in most of them.
    for (long i = 0; i < count; ++i) {
      const Point inside = lists.at(i + 1);
      lists.points.push_back({2 * inside[0], 2 * inside[1]});
      const Vertex out = count + i + 1, next_out = count + (i + 1) % count + 1;
      lists.simplices.push_back({i + 1, out, (i + 1) % count + 1});
      lists.simplices.push_back({out, next_out, (i + 1) % count + 1});
    }
    bool is_tried = false;
    for (const Cause& cause : causes_of(lists, Claim::kTriangulation)) {
      is_tried |= cause.name == "vertex-out-of-place";
    }
    CHECK(is_tried == (count < 1000));
  }
}

TEST_CASE("causes: how near a point is to another one is seen along every axis") {
  // A thousandth of a thousandth of the length is near, and more than of the height.
  Lists lists = grid<2>(5);
  for (Point& point : lists.points) point[0] *= 1000;
  lists.points.push_back(lists.points.front() + Point{Rational(1, 1000), 0});
  CHECK(named(lists, Claim::kTriangulation).starts_with("near-points: 1 point is in no triangle"));
}

TEST_CASE("causes: how near is near depends on the size of the mesh") {
  for (const Rational& size : {Rational(1, 1'000'000'000), Rational(1), Rational(1'000'000'000)}) {
    for (const bool is_near : {false, true}) {
      Lists lists = grid<2>(5);
      lists.points.push_back({Rational(3, 2) + Rational(is_near ? 0 : 1, 100), Rational(5, 4)});
      if (is_near) lists.points.back() = lists.points.front() + Point{Rational(1, 10'000'000), 0};
      for (Point& point : lists.points) {
        for (Rational& x : point) x *= size;
      }
      CHECK(named(lists, Claim::kTriangulation).starts_with("near-points") == is_near);
    }
  }
}

TEST_CASE("causes: one simplex too many, which lies on others, is named") {
  for (const std::size_t place : {0, 1, 2}) {
    Lists lists = grid<2>(6);
    const Simplex large = {7, 10, 25};
    lists.simplices.insert(lists.simplices.begin() + static_cast<std::ptrdiff_t>(20 * place),
                           large);
    const std::string said = named(lists, Claim::kComplex);
    CHECK(said.starts_with("one-simplex: all "));
    CHECK(said.ends_with(" name the triangle 7 10 25"));
  }
}

}  // namespace
}  // namespace circumspect::check
