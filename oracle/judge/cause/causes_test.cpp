// One cause is planted in a good mesh, in the plane and in space, and is named; what looks like a
// cause and is none is not.
#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "oracle/judge/cause/bare_facets.hpp"
#include "oracle/judge/cause/planted_faults_test.hpp"

namespace circumspect::check {
namespace {

// A vertex that only inner simplices have.
template <std::size_t kDimension>
Vertex inner(const Lists& lists) {
  return lists.simplices.back().front();
}

template <std::size_t kDimension>
void check_planted(std::size_t side) {
  const Lists good = grid<kDimension>(side);
  const bool is_plane = kDimension == 2;
  for (const Claim claim : {Claim::kTriangulation, Claim::kDelaunay, Claim::kComplex}) {
    CAPTURE(name(claim));
    CHECK(named(good, claim) == "none");

    Lists moved = good;
    const Vertex v = inner<kDimension>(good);
    moved.at(v)[0] += Rational(9, 4);
    moved.at(v)[1] += Rational(1, 3);
    CHECK(named(moved, claim).find("name vertex " + std::to_string(v) + ", which is not between") !=
          std::string::npos);

    Lists later = good;
    for (Simplex& simplex : later.simplices) {
      for (Vertex& w : simplex) ++w;
    }
    CHECK(
        named(later, claim) ==
        "indices-begin-elsewhere: indices seem to begin at 1, not at 0: so read, the claim holds");
    for (Simplex& simplex : later.simplices) {
      for (Vertex& w : simplex) w -= 2;
    }
    CHECK(named(later, claim) ==
          "indices-begin-elsewhere: indices seem to begin at -1, not at 0: so read, the claim "
          "holds");

    Lists others = good;
    std::mt19937 random(1);
    std::shuffle(others.points.begin(), others.points.end(), random);
    CHECK(named(others, claim)
              .starts_with("points-of-another-mesh: the points seem to be those of another mesh"));

    Lists turned = good;
    std::swap(turned.simplices.back()[0], turned.simplices.back()[1]);
    Options same;
    same.oriented = true;
    same.complex.oriented = Orientations::kSame;
    CHECK(named(turned, claim, same)
              .find(is_plane ? "triangles lists its vertices in the other"
                             : "tetrahedra lists its vertices in the other") != std::string::npos);

    Lists labelled = good;
    for (std::size_t s = 0; s < good.simplices.size(); ++s) {
      labelled.simplices[s].push_back(static_cast<Vertex>(s % 2));
    }
    if (claim != Claim::kComplex) {
      CHECK(named(labelled, claim) ==
            "last-column-is-a-label: the last column of the simplices is a label: without it, the "
            "claim holds");
    }
  }
}

TEST_CASE("causes: one that is planted is named, under each claim") {
  check_planted<2>(7);
  check_planted<3>(5);
}

std::string listed_in(const Simplex& simplex) {
  std::string words;
  for (const Vertex v : simplex) words += " " + std::to_string(v);
  return words;
}

template <std::size_t kDimension>
void check_lists(std::size_t side) {
  const Lists good = grid<kDimension>(side);
  for (const Claim claim : {Claim::kDelaunay, Claim::kComplex}) {
    CAPTURE(name(claim));
    Lists twice = good;
    Simplex again = good.simplices.back();
    twice.simplices.push_back(again);
    CHECK(causes_of(twice, claim).front().words ==
          std::string(kDimension == 2 ? "1 triangle" : "1 tetrahedron") +
              " is listed twice:" + listed_in(again) + "; listed once, the claim holds");
    // In another order of its vertices, and another one, too.
    std::reverse(again.begin(), again.end());
    twice.simplices.back() = again;
    twice.simplices.push_back(good.simplices.front());
    CHECK(named(twice, claim).find("are listed again:" + listed_in(again)) != std::string::npos);
    std::swap(twice.simplices.back(), twice.simplices[twice.simplices.size() - 2]);
    CHECK(named(twice, claim).find("are listed again:" + listed_in(good.simplices.front())) !=
          std::string::npos);

    // Half of the points are not there. One index that names no point tells nothing.
    Lists fewer = good;
    fewer.points.resize(good.points.size() / 2);
    const std::string last = std::to_string(fewer.points.size() - 1);
    CHECK(named(fewer, claim) ==
          "points-of-another-mesh: the points seem to be those of another "
          "mesh, or not all of them: the last one is " +
              last + ", and simplices name vertices up to " +
              std::to_string(good.points.size() - 1));
    // Even if one simplex lies on most others, which would explain more.
    for (std::size_t i = 0; i <= kDimension; ++i) {
      Point& corner = fewer.at(fewer.simplices[0][i]);
      corner = Point(kDimension, Rational(-100));
      if (i > 0) corner[i - 1] = 1000;
    }
    CHECK(causes_of(fewer, claim).front().name == "points-of-another-mesh");
    Lists wrong = good;
    wrong.simplices.back().back() = static_cast<Vertex>(good.points.size()) + 3;
    CHECK(named(wrong, claim) == "none");
  }
}

TEST_CASE("causes: simplices that are listed twice, and points that are not there") {
  check_lists<2>(7);
  check_lists<3>(5);
}

template <std::size_t kDimension>
void check_missing(std::size_t side) {
  Lists lists = grid<kDimension>(side);
  const Simplex lost = lists.simplices.back();
  lists.simplices.pop_back();
  const std::string noun = kDimension == 2 ? "triangle" : "tetrahedron";
  const Simplex ascending = sorted(lost);
  const std::string words = listed_in(ascending);
  CHECK(named(lists, Claim::kDelaunay) ==
        "missing-simplex: 1 " + noun + " is missing:" + words + " fills the hole");
  // As a complex nothing is missing.
  CHECK(named(lists, Claim::kComplex) == "none");
  // By exact numbers, too.
  for (Point& point : lists.points) {
    for (Rational& x : point) x /= 3;
  }
  CHECK(named(lists, Claim::kTriangulation) ==
        "missing-simplex: 1 " + noun + " is missing:" + words + " fills the hole");
  // At a corner, whose vertex no other simplex has, and one that touches the first.
  lists = grid<kDimension>(side);
  std::erase_if(lists.simplices, [&](const Simplex& simplex) {
    return contains(simplex, lost[0]) && contains(simplex, lost[1]) && sorted(simplex) != ascending;
  });
  CHECK(causes_of(lists, Claim::kTriangulation).size() <= 1);
}

TEST_CASE("causes: a simplex that is missing, inside and at the hull") {
  check_missing<2>(7);
  check_missing<3>(6);
  Lists corner = grid<2>(4);
  std::erase_if(corner.simplices, [](const Simplex& simplex) { return contains(simplex, 3); });
  CHECK(named(corner, Claim::kDelaunay) ==
        "missing-simplex: 1 triangle is missing: 2 3 7 fills the hole");
  corner = grid<2>(4);
  std::erase_if(corner.simplices, [](const Simplex& simplex) {
    return contains(simplex, 0) || contains(simplex, 15);
  });
  CHECK(named(corner, Claim::kDelaunay) == "none");  // two triangles each: no hole of one
}

// The last point is beside the middle of the edge or triangle of the first ones.
std::string named_beside_hull(const Rational& height, std::size_t d) {
  Lists lists;
  if (d == 2) {
    lists.points = {{0, 0}, {4, 0}, {2, 3}, {2, height}};
    lists.simplices = {{0, 3, 2}, {3, 1, 2}};
  } else {
    lists.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, {1, 1, height}};
    lists.simplices = {{0, 1, 4, 3}, {1, 2, 4, 3}, {0, 4, 2, 3}};
  }
  return named(lists, Claim::kTriangulation);
}

TEST_CASE("causes: of slivers that are missing it is said how high they are") {
  const Rational tiny(1, 1L << 50);
  CHECK(named_beside_hull(tiny, 2) ==
        "missing-simplex: 1 triangle is missing: 0 1 3 fills the hole, at most 8.9e-16 high, as if "
        "its corners were taken for collinear");
  CHECK(named_beside_hull(tiny, 3) ==
        "missing-simplex: 1 tetrahedron is missing: 0 1 2 4 fills the hole, at most 8.9e-16 high, "
        "as if its corners were taken for coplanar");
  for (const std::size_t d : {2u, 3u}) {
    CHECK(named_beside_hull(Rational(1, 1L << 16), d).ends_with("fills the hole"));
  }
}

TEST_CASE("causes: a mesh that is folded has not the points of another one") {
  Lists folded = grid<2>(7);
  for (Point& point : folded.points) {
    if (point[0] <= 3) continue;
    point[1] += point[0] / 1000;
    point[0] = 6 - point[0];
  }
  for (const Claim claim : {Claim::kTriangulation, Claim::kComplex}) {
    CHECK(!named(folded, claim).starts_with("points-of-another-mesh"));
  }
}

TEST_CASE("causes: a part that is left out on purpose is not missing") {
  // Of a ring around a square hole, no triangle is.
  Lists ring = grid<2>(5);
  std::erase_if(ring.simplices, [&](const Simplex& simplex) {
    const Point middle = barycentre(ring.corners(simplex));
    return middle[0] > 1 && middle[0] < 3 && middle[1] > 1 && middle[1] < 3;
  });
  for (const Cause& cause : causes_of(ring, Claim::kTriangulation)) {
    CHECK(cause.name != "missing-simplex");
  }
}

TEST_CASE("causes: points with a column that is not a coordinate") {
  Lists labelled = grid<2>(5);
  for (std::size_t v = 0; v < labelled.points.size(); ++v) {
    labelled.points[v].push_back(static_cast<long>(v % 2));
  }
  CHECK(named(labelled, Claim::kDelaunay) ==
        "last-coordinate-does-not-count: the last column of the points is a label: without it, the "
        "claim holds");
  // Many heights, or few that are not whole numbers.
  for (const std::size_t count : {1000U, 2U}) {
    for (std::size_t v = 0; v < labelled.points.size(); ++v) {
      labelled.points[v].back() = Rational(static_cast<long>(v * v % count), 7);
    }
    CHECK(named(labelled, Claim::kDelaunay) ==
          "last-coordinate-does-not-count: the last coordinate is a height: seen along that axis, "
          "the claim holds");
  }
}

TEST_CASE("causes: signs that are all the other way") {
  Options positive;
  positive.complex.oriented = Orientations::kPositive;
  Lists lists = grid<2>(4);
  CHECK(named(lists, Claim::kComplex, positive) == "none");
  for (Simplex& simplex : lists.simplices) std::swap(simplex[0], simplex[1]);
  CHECK(named(lists, Claim::kComplex, positive) ==
        "all-inverted: all 18 triangles list their vertices in the other order: "
        "--oriented=negative holds of them");
}

// The claim `complex` goes on where an index names no point, and its causes with it.
TEST_CASE("causes: indices that name no points are never looked up") {
  constexpr Vertex kFar = Vertex{1} << 40;
  std::size_t told = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    generators::Dice dice(seed);
    Lists lists = dice.below(3) == 0 ? grid<3>(3) : grid<2>(4);
    const auto any = [&]() -> Simplex& {
      return lists.simplices[dice.below(lists.simplices.size())];
    };
    for (std::size_t faults = dice.below(4); faults > 0; --faults) {
      std::swap(any(), lists.simplices.back());
      lists.simplices.pop_back();
    }
    for (std::size_t faults = dice.below(4) + 1; faults > 0; --faults) {
      const Vertex others[] = {-1, std::ssize(lists.points), kFar, 0};
      Simplex& simplex = any();
      simplex[dice.below(simplex.size())] = others[dice.below(4)];
    }
    for (const Claim claim : {Claim::kComplex, Claim::kTriangulation, Claim::kDelaunay}) {
      for (const Cause& cause : causes_of(lists, claim)) {
        CHECK(cause.explains <= cause.of);
        ++told;
      }
    }
  }
  CHECK(told > 50);
  const Mesh mesh = in_arrays(grid<2>(3));
  for (const Vertex other : {Vertex{-1}, Vertex{9}, kFar}) {
    CHECK(orientation_in(mesh, Simplex{0, 1, other}) == 0);
    CHECK(orientation_in(mesh, Simplex{other, 0, 1}) == 0);
  }
}

}  // namespace
}  // namespace circumspect::check
