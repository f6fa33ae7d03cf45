// One cause is planted in a good mesh, in the plane and in space, and is named; what looks like a
// cause and is none is not.
#include "oracle/judge/cause/causes.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "oracle/judge/fast/grid_mesh_test.hpp"
#include "oracle/judge/judge.hpp"

namespace circumspect::check {
namespace {

struct Lists {
  std::vector<Point> points;
  std::vector<Simplex> simplices;

  std::size_t dimension() const { return points.front().size(); }
  Point& at(Vertex v) { return points[static_cast<std::size_t>(v)]; }
  std::vector<Point> corners(const Simplex& simplex) const {
    std::vector<Point> corners;
    for (const Vertex v : simplex) corners.push_back(points[static_cast<std::size_t>(v)]);
    return corners;
  }
};

// A Delaunay mesh of `side` points along each axis, with a simplex in the middle last.
template <std::size_t kDimension>
Lists grid(std::size_t side) {
  const auto arrays = fast::grid_mesh<kDimension>(side);
  Lists lists;
  for (std::size_t i = 0; i < arrays.coordinates.size(); ++i) {
    if (i % kDimension == 0) lists.points.emplace_back();
    lists.points.back().push_back(static_cast<long>(arrays.coordinates[i]));
  }
  for (std::size_t i = 0; i < arrays.simplices.size(); ++i) {
    if (i % (kDimension + 1) == 0) lists.simplices.emplace_back();
    lists.simplices.back().push_back(arrays.simplices[i]);
  }
  const auto half = lists.simplices.begin() + std::ssize(lists.simplices) / 2;
  std::rotate(half, half + 1, lists.simplices.end());
  return lists;
}

Mesh in_arrays(const Lists& lists) {
  Mesh mesh;
  mesh.coordinates = numbers_of(lists.points, lists.dimension());
  mesh.simplices = IndexLists(lists.simplices);
  return mesh;
}

std::vector<Cause> causes_of(const Lists& lists, Claim claim, const Options& options = {}) {
  const Mesh mesh = in_arrays(lists);
  const auto judged = [&](const Mesh& one) -> std::optional<Verdict> {
    auto verdict = judge(claim, one, nullptr, options);
    if (!verdict) return std::nullopt;
    return std::move(*verdict);
  };
  const auto verdict = judged(mesh);
  REQUIRE(verdict.has_value());
  std::vector<Cause> found = causes(*verdict, mesh, judged).found;
  std::size_t all = 0, of_all = 0;
  for (const auto& [rule, tally] : verdict->tallies()) all += tally.count;
  for (const Cause& cause : found) {
    CHECK(0 < cause.explains);
    CHECK(cause.explains <= cause.of);
    CHECK(cause.of_listed == (cause.of < all));
    of_all += cause.explains == all ? 1 : 0;
  }
  CHECK(of_all <= 1);  // what all is wrong has no second cause
  return found;
}

// The same mesh in a mirror, and one and a half times as large; its simplices in the reverse order,
// each with two vertices exchanged, so that it keeps its sign.
Lists seen_otherwise(Lists lists) {
  for (Point& point : lists.points) {
    for (Rational& x : point) x *= Rational(3, 2);
    std::swap(point[0], point[1]);
  }
  for (Simplex& simplex : lists.simplices) std::swap(simplex[0], simplex[1]);
  std::reverse(lists.simplices.begin(), lists.simplices.end());
  return lists;
}

// Of all causes, in their order, what they explain of how much.
std::string text_of(const std::vector<Cause>& causes) {
  std::string text;
  for (const Cause& cause : causes) {
    text += cause.name + " " + std::to_string(cause.explains) + " of " + std::to_string(cause.of) +
            "\n";
  }
  return text;
}

// Of the cause that explains most. Nothing depends on how the mesh is placed and listed, which is
// seen in the plane, where it takes less time.
std::string named(const Lists& lists, Claim claim, const Options& options = {}) {
  const std::vector<Cause> found = causes_of(lists, claim, options);
  if (lists.dimension() == 2) {
    CHECK(text_of(causes_of(seen_otherwise(lists), claim, options)) == text_of(found));
  }
  CHECK(found.size() <= 3);
  CHECK(std::is_sorted(found.begin(), found.end(),
                       [](const Cause& a, const Cause& b) { return a.explains > b.explains; }));
  if (found.empty()) return "none";
  const Cause& first = found.front();
  return first.name + ": " + first.words + (first.explains == first.of ? "" : " in part");
}

// The half beyond the middle has points of its own there, which are moved along the last axis; if
// they are, the first and the last are left.
void part(Lists& lists, const Rational& moved) {
  const Rational middle(static_cast<long>(lists.points.back()[0].get_d()) / 2);
  const std::size_t most = lists.points.size() - 1;
  std::map<Vertex, Vertex> own;
  for (Simplex& simplex : lists.simplices) {
    if (barycentre(lists.corners(simplex))[0] < middle) continue;
    for (Vertex& v : simplex) {
      const Rational last = lists.at(v).back();
      const bool is_end = last == 0 || last == lists.points[most].back();
      if (lists.at(v)[0] != middle || (moved != 0 && is_end)) continue;
      const auto [twin, is_new] = own.emplace(v, static_cast<Vertex>(lists.points.size()));
      if (is_new) {
        const Point point = lists.at(v);
        lists.points.push_back(point);
        lists.points.back().back() += moved;
      }
      v = twin->second;
    }
  }
}

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

template <std::size_t kDimension>
void check_lists(std::size_t side) {
  const Lists good = grid<kDimension>(side);
  for (const Claim claim : {Claim::kDelaunay, Claim::kComplex}) {
    CAPTURE(name(claim));
    Lists twice = good;
    Simplex again = good.simplices.back();
    const std::string listed = [&] {
      std::string words;
      for (const Vertex v : again) words += " " + std::to_string(v);
      return words;
    }();
    twice.simplices.push_back(again);
    CHECK(causes_of(twice, claim).front().words ==
          std::string(kDimension == 2 ? "1 triangle" : "1 tetrahedron") +
              " is listed twice:" + listed + "; listed once, the claim holds");
    // In another order of its vertices, and another one, too.
    std::reverse(again.begin(), again.end());
    twice.simplices.back() = again;
    twice.simplices.push_back(good.simplices.front());
    CHECK(named(twice, claim).find("are listed again:") != std::string::npos);

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
  Simplex ascending = sorted(lost);
  std::string words;
  for (const Vertex v : ascending) words += " " + std::to_string(v);
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
        "missing-simplex: 1 triangle is missing: 2 7 3 fills the hole");
  corner = grid<2>(4);
  std::erase_if(corner.simplices, [](const Simplex& simplex) {
    return contains(simplex, 0) || contains(simplex, 15);
  });
  CHECK(named(corner, Claim::kDelaunay) == "none");  // two triangles each: no hole of one
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

template <std::size_t kDimension>
void check_apart(std::size_t side) {
  Lists equal = grid<kDimension>(side);
  part(equal, 0);
  CHECK(named(equal, Claim::kComplex)
            .find(" equal another one, exactly: with --duplicates merge "
                  "the claim holds") != std::string::npos);
  Lists hanging = grid<kDimension>(side);
  Simplex& cut = hanging.simplices.back();
  hanging.points.push_back(barycentre({hanging.at(cut[0]), hanging.at(cut[1])}));
  Simplex half = cut;
  half[0] = cut[1] = static_cast<Vertex>(hanging.points.size()) - 1;
  hanging.simplices.push_back(half);
  for (const Claim claim : {Claim::kTriangulation, Claim::kComplex}) {
    CAPTURE(name(claim));
    CHECK(named(hanging, claim).find("1 vertex lies inside faces of simplices that are not cut") !=
          std::string::npos);
  }
}

TEST_CASE("causes: equal points and hanging vertices") {
  check_apart<2>(7);
  check_apart<3>(6);
}

TEST_CASE("causes: what is left when one is mended is counted and not explained") {
  Lists equal = grid<2>(7);
  part(equal, 0);
  equal.simplices.push_back(equal.simplices.front());
  CHECK(named(equal, Claim::kComplex).ends_with("count as one, and the rest remains in part"));
  Lists later = grid<2>(7);  // with two points that no simplex has
  later.points.insert(later.points.begin(), {{9, 9}, {10, 9}});
  for (Simplex& simplex : later.simplices) {
    for (Vertex& v : simplex) v += 3;
  }
  CHECK(named(later, Claim::kComplex)
            .ends_with("so read, all name points, and 2 violations are left in part"));
  const Cause cause = causes_of(later, Claim::kComplex).front();
  CHECK(cause.explains + 2 == cause.of);
}

TEST_CASE("causes: parts that were meshed apart") {
  // In the plane their vertices differ where they meet.
  Lists plane = grid<2>(7);
  part(plane, Rational(1, 4));
  // In space the diagonals do: the one half is the mirror image of what it was.
  Lists space = grid<3>(5);
  const long most = 4;
  for (Simplex& simplex : space.simplices) {
    if (barycentre(space.corners(simplex))[0] < 2) continue;
    for (Vertex& v : simplex) v += 5 * (most - 2 * (v / 5 % 5));
  }
  for (const Claim claim : {Claim::kTriangulation, Claim::kDelaunay, Claim::kComplex}) {
    CAPTURE(name(claim));
    CHECK(named(plane, claim).find("parts that were meshed apart meet: 10 vertices lie inside") !=
          std::string::npos);
    CHECK(named(space, claim)
              .find("parts that were meshed apart meet in 16 quadrilaterals with different "
                    "diagonals") != std::string::npos);
  }
}

TEST_CASE("causes: points with a column that is no coordinate") {
  Lists labelled = grid<2>(5);
  for (std::size_t v = 0; v < labelled.points.size(); ++v) {
    labelled.points[v].push_back(static_cast<long>(v % 2));
  }
  CHECK(named(labelled, Claim::kDelaunay) ==
        "last-coordinate-does-not-count: the last column of the points is a label: without it, the "
        "claim holds");
  for (std::size_t v = 0; v < labelled.points.size(); ++v) {
    labelled.points[v].back() = Rational(static_cast<long>(v * v), 7);
  }
  CHECK(
      named(labelled, Claim::kDelaunay) ==
      "last-coordinate-does-not-count: the last coordinate is a height: seen along that axis, the "
      "claim holds");
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

}  // namespace
}  // namespace circumspect::check
