// A mesh that one process judges part after part has the verdict of the whole, word for word.
// The coordinates are small integers: points are equal but for the sign of a zero, sample points
// lie in planes of facets, weighted points are submerged or about to emerge, and there are more
// parts than simplices. ranks_property.cpp tries the catalogue of mutations, and ranks of MPI.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <doctest/doctest.h>

#include "kernel/exact/each_once.hpp"
#include "oracle/distributed/submerged.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"
#include "properties/dealt_meshes.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::properties {
namespace {

// The (weighted) Delaunay triangulation of some points of a grid. Each is a multiple of three, so
// that barycentres are points of a grid as well, and weights are multiples of squared distances, so
// that lifted points lie in the planes of others. Half of the sets are triangulated in a mirror:
// of several triangulations it is another one that is canonical there. One in eight is triangulated
// by other weights, and so not locally Delaunay. `taken`: points that are others.
std::optional<ArrayMesh> drawn_mesh(std::size_t d, bool weighted, std::set<Point>& taken,
                                    Dice& dice) {
  std::vector<Point> points;
  std::vector<Rational> weights;
  for (std::size_t more = d + 1 + dice.below(5); more > 0; --more) {
    Point point;
    for (std::size_t axis = 0; axis < d; ++axis) {
      point.push_back(3 * static_cast<long>(dice.below(4)) - 3);
    }
    if (!taken.insert(point).second) continue;
    points.push_back(point);
    weights.push_back(9 * static_cast<long>(dice.below(4)));
  }
  if (points.empty()) return std::nullopt;
  const PointSet set = weighted ? PointSet(points, weights) : PointSet(points);
  if (set.dimension() != static_cast<int>(d)) return std::nullopt;
  std::reverse(weights.begin(), weights.end());
  const PointSet& of = dice.below(8) == 0 ? PointSet(points, weights) : set;
  const Triangulation triangulation = delaunay::bowyer_watson(of);
  ArrayMesh mesh = array_mesh(set, triangulation.simplices());
  const bool is_mirrored = dice.below(2) == 0;
  for (std::size_t i = 0; is_mirrored && i < mesh.coordinates.size(); i += d) {
    mesh.coordinates[i] = 0 - mesh.coordinates[i];
  }
  return mesh;
}

void append(ArrayMesh& mesh, const ArrayMesh& other) {
  const auto before = static_cast<std::int64_t>(mesh.points());
  const auto add = [](std::vector<double>& all, const std::vector<double>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  add(mesh.coordinates, other.coordinates);
  add(mesh.weights, other.weights);
  for (const std::int64_t v : other.simplices) mesh.simplices.push_back(before + v);
}

// A point that no simplex names: it is equal to another, but for the signs of zeros.
void repeat_point(ArrayMesh& mesh, std::size_t v, Dice& dice) {
  for (std::size_t axis = 0; axis < mesh.dimension; ++axis) {
    const double x = mesh.coordinates[v * mesh.dimension + axis];
    mesh.coordinates.push_back(x == 0 ? -x : x);
  }
  if (!mesh.weights.empty()) mesh.weights.push_back(static_cast<double>(dice.below(20)));
}

// Points between vertices of one simplex: in it alone, or in what several have in common; hidden,
// or so heavy that they may not be.
void add_points_within(ArrayMesh& mesh, std::set<Point>& taken, Dice& dice) {
  const std::size_t d = mesh.dimension;
  for (std::size_t more = 1 + dice.below(9); more > 0; --more) {
    const auto row = mesh.row(dice.below(mesh.size()));
    const auto is_unknown = [&](std::int64_t v) {  // another alteration may have made one
      return v >= static_cast<std::int64_t>(mesh.points());
    };
    if (std::any_of(row.begin(), row.end(), is_unknown)) continue;
    const std::size_t corners = 2 + dice.below(d);
    std::vector<double> at(d, 0);
    for (std::size_t i = 0; i < corners; ++i) {
      for (std::size_t axis = 0; axis < d; ++axis) {
        at[axis] += mesh.coordinates[static_cast<std::size_t>(row[i]) * d + axis];
      }
    }
    Point point;
    for (double& x : at) point.push_back(exact_value(x /= static_cast<double>(corners)));
    if (!taken.insert(point).second) continue;
    mesh.coordinates.insert(mesh.coordinates.end(), at.begin(), at.end());
    mesh.weights.push_back(dice.below(8) == 0 ? 100 : -100);
  }
}

void alter(ArrayMesh& mesh, bool weighted, std::set<Point>& taken, Dice& dice) {
  switch (dice.below(10)) {
    case 0: {
      const std::size_t v = dice.below(mesh.points());
      for (std::size_t times = 1 + dice.below(3); times > 0; --times) repeat_point(mesh, v, dice);
      return;
    }
    case 1:  // what is covered twice
      if (const auto other = drawn_mesh(mesh.dimension, weighted, taken, dice))
        append(mesh, *other);
      return;
    case 2:
      if (mesh.size() > 1) mesh.simplices.resize(mesh.simplices.size() - mesh.width());
      return;
    case 3:  // two simplices on one side of a facet, if it is a vertex opposite one
      mesh.simplices[dice.below(mesh.simplices.size())] =
          static_cast<std::int64_t>(dice.below(mesh.points() + 1));
      return;
    case 4:
    case 5:  // of a point that no simplex names, if there is one
      for (std::size_t v = 0; weighted && v < mesh.points(); ++v) {
        const auto named = static_cast<std::int64_t>(v);
        if (std::count(mesh.simplices.begin(), mesh.simplices.end(), named) > 0) continue;
        mesh.weights[v] += static_cast<double>(9 * dice.below(3));
      }
      return;
    case 6:
      if (weighted) add_points_within(mesh, taken, dice);
      return;
    case 7:  // one part has finer numbers than the others
      mesh.coordinates[dice.below(mesh.coordinates.size())] += 0x1p-20;
      return;
    case 8: {  // the last one is listed again, perhaps by another part
      const std::vector<std::int64_t> last(
          mesh.simplices.end() - static_cast<std::ptrdiff_t>(mesh.width()), mesh.simplices.end());
      mesh.simplices.insert(mesh.simplices.begin(), last.begin(), last.end());
      return;
    }
    default:
      return;
  }
}

template <std::size_t kDimension>
void assert_found_in_box(Dice& dice) {
  std::vector<distributed::NumberedPoint<kDimension>> points(dice.below(20));
  const auto drawn = [&] {
    fast::Site<kDimension> site;
    for (double& x : site.at) x = static_cast<double>(dice.below(4));
    return site;
  };
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {i, drawn()};
  fast::SiteRow<kDimension> row;
  for (auto& site : row) site = drawn();
  std::set<std::uint64_t> expected, found;
  for (const auto& point : points) {
    bool is_in = true;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      const double x = point.site.at[axis];
      const auto is_less = [&](const auto& site) { return site.at[axis] < x; };
      const auto is_more = [&](const auto& site) { return site.at[axis] > x; };
      is_in &= !std::all_of(row.begin(), row.end(), is_less);
      is_in &= !std::all_of(row.begin(), row.end(), is_more);
    }
    if (is_in) expected.insert(point.index);
  }
  distributed::PointTree<kDimension>(points).for_each_in_box(
      row, [&](const auto& point) { found.insert(point.index); });
  RC_ASSERT(found == expected);
}

TEST_CASE("the points in the box of a simplex are found, though many have equal coordinates") {
  CHECK(holds("as by looking at each", 1000, [] {
    Dice dice(static_cast<std::uint64_t>(*generators::below(1'000'000'000)));
    assert_found_in_box<2>(dice);
    assert_found_in_box<3>(dice);
  }));
}

TEST_CASE("a mesh judged in parts has the verdict of the whole") {
  std::map<std::string, std::size_t> seen;
  CHECK(holds("on grids", 1400, [&] {
    Dice dice(static_cast<std::uint64_t>(*generators::below(1'000'000'000)));
    const std::size_t d = 2 + dice.below(2);
    const bool weighted = dice.below(2) == 0;
    std::set<Point> taken;
    std::optional<ArrayMesh> mesh = drawn_mesh(d, weighted, taken, dice);
    if (!mesh) return;
    for (std::size_t times = 1 + dice.below(2); times > 0; --times) {
      alter(*mesh, weighted, taken, dice);
    }
    const Claim claim = dice.below(4) == 0 ? Claim::kTriangulation
                        : weighted         ? Claim::kWeightedDelaunay
                                           : Claim::kDelaunay;
    const check::Options options{.max_violations = 1 + dice.below(20)};
    const std::string whole = said_by_one(claim, *mesh, options);
    RC_LOG() << whole;
    RC_ASSERT(said_in_turns(claim, *mesh, drawn_way(dice), dice, options, 8) == whole);
    ++seen[whole.substr(0, whole.find_first_of(" .:"))];
  }));
  CHECK(occurs(seen.size(), 3));
}

// Enough points that most belong to one part alone, which then tells what is wrong there.
TEST_CASE("every mutation of a larger mesh is told in parts as in the whole") {
  std::vector<Mutation> all = catalogue();
  std::erase_if(all, [](const Mutation& one) {
    return one.needs_weights || one.rules.contains(Rule::kWrongNeighbor);
  });
  std::map<std::string, std::size_t> seen;
  CHECK(holds("on doubles", 60, [&] {
    Dice dice(static_cast<std::uint64_t>(*generators::below(1'000'000'000)));
    const std::size_t d = 2 + dice.below(2);
    std::vector<Point> points;
    for (std::size_t i = 0; i < 30; ++i) {
      Point& point = points.emplace_back();
      for (std::size_t axis = 0; axis < d; ++axis) {
        point.push_back(static_cast<long>(dice.below(axis == 0 ? 1000 : 10)));
      }
    }
    keep_each_once(points);
    const PointSet set(points);
    ArrayMesh mesh = array_mesh(set, delaunay::bowyer_watson(set).simplices());
    list_neighbors(mesh);
    const Mutation& mutation = all[dice.below(all.size())];
    const ArrayMesh before = mesh;
    if (!mutation.apply(mesh, dice)) mesh = before;
    const Claim claim = dice.below(4) == 0 ? Claim::kTriangulation : Claim::kDelaunay;
    const check::Options options{.max_violations = 1 + dice.below(20)};
    const std::string whole = said_by_one(claim, mesh, options);
    RC_LOG() << whole;
    RC_ASSERT(said_in_turns(claim, mesh, Way::kAlongALine, dice, options, 5) == whole);
    ++seen[whole.substr(0, whole.find_first_of(": "))];
  }));
  CHECK(occurs(seen.size(), 3));
}

// Far more ridges at fault than a verdict shows: in each part, and between parts.
TEST_CASE("of many ridges at fault the first are shown, and the others counted, in parts too") {
  for (const std::size_t d : {2, 3}) {
    properties::Dice dice(d);
    std::vector<Point> points;
    for (std::size_t i = 0; i < 40; ++i) {
      Point& point = points.emplace_back();
      for (std::size_t axis = 0; axis < d; ++axis) {
        point.push_back(static_cast<long>(dice.below(1000)));
      }
    }
    const PointSet set(points);
    const std::vector<Simplex> all = delaunay::bowyer_watson(set).simplices();
    std::vector<Simplex> kept;
    for (std::size_t s = 0; s < all.size(); ++s) {
      if (s % 4 != 0) kept.push_back(all[s]);
    }
    const ArrayMesh mesh = array_mesh(set, kept);
    for (const std::size_t most : {1, 2, 3, 4, 5, 6, 7, 8, 9, 0}) {
      CAPTURE(most);
      const check::Options options{.max_violations = most};
      const std::string whole = said_by_one(Claim::kDelaunay, mesh, options);
      CHECK(whole.find("triangulation.hull-not-convex") != std::string::npos);
      CHECK(said_in_turns(Claim::kDelaunay, mesh, Way::kSlices, dice, options, 5) == whole);
      if (most > 2) continue;
      for (const Way way : {Way::kRoundRobin, Way::kAlongALine}) {
        CHECK(said_in_turns(Claim::kDelaunay, mesh, way, dice, options, 5) == whole);
      }
    }
  }
}

// A corner at the origin, one along each axis, and one beyond them; and a point of the first
// simplex that is not a vertex, of the weight with which it comes to lie in the witness plane.
ArrayMesh with_submerged_tie(const std::vector<double>& point) {
  const std::size_t d = point.size();
  ArrayMesh mesh{.dimension = d};
  for (std::size_t v = 0; v < d + 2; ++v) {
    for (std::size_t axis = 0; axis < d; ++axis) {
      mesh.coordinates.push_back(v == axis + 1 ? 6 : v == d + 1 ? 9 : 0);
    }
    mesh.weights.push_back(0);
  }
  for (std::size_t v = 0; v <= d; ++v) mesh.simplices.push_back(static_cast<std::int64_t>(v));
  for (std::size_t v = 1; v <= d + 1; ++v) mesh.simplices.push_back(static_cast<std::int64_t>(v));
  double weight = 0;
  for (const double x : point) weight += x * x - 6 * x;
  mesh.coordinates.insert(mesh.coordinates.end(), point.begin(), point.end());
  mesh.weights.push_back(weight);
  return mesh;
}

// Such a point is between the vertices that surround it, and never the first in the order by which
// ties are broken: it stays submerged, and the mesh is the canonical one.
TEST_CASE("a submerged point in a witness plane is a tie in parts as in the whole") {
  for (const std::vector<double>& point :
       {std::vector<double>{1, 2}, {0, 2}, {3, 3}, {1, 2, 2}, {0, 1, 2}, {2, 2, 2}, {0, 0, 3}}) {
    const ArrayMesh mesh = with_submerged_tie(point);
    const std::string whole = said_by_one(Claim::kWeightedDelaunay, mesh, {});
    CHECK(whole.find("holds: weighted-delaunay") != std::string::npos);
    CHECK(whole.find(" not-unique canonical") != std::string::npos);
    for (const Way way : {Way::kSlices, Way::kRoundRobin, Way::kAllToOne, Way::kSomeToNone}) {
      Dice dice(7);
      CHECK(said_in_turns(Claim::kWeightedDelaunay, mesh, way, dice, {}, 4) == whole);
    }
  }
}

// All squares but one have the same diagonal. One part alone sees that the other is not the
// canonical one.
TEST_CASE("the other diagonal of one square is not canonical in parts as in the whole") {
  constexpr std::int64_t kSquares = 3;  // along each axis
  std::set<bool> seen;
  for (std::int64_t other = 0; other <= kSquares * kSquares; ++other) {
    CAPTURE(other);
    ArrayMesh mesh{.dimension = 2};
    for (std::int64_t v = 0; v < (kSquares + 1) * (kSquares + 1); ++v) {
      mesh.coordinates.push_back(static_cast<double>(v % (kSquares + 1)));
      mesh.coordinates.push_back(static_cast<double>(v / (kSquares + 1)));
    }
    for (std::int64_t square = 0; square < kSquares * kSquares; ++square) {
      const std::int64_t a = square + square / kSquares, b = a + 1, c = b + kSquares, d = c + 1;
      const std::vector<std::int64_t> triangles =
          square == other ? std::vector{a, b, c, b, d, c} : std::vector{a, b, d, a, d, c};
      mesh.simplices.insert(mesh.simplices.end(), triangles.begin(), triangles.end());
    }
    const std::string whole = said_by_one(Claim::kDelaunay, mesh, {});
    CHECK(whole.find(" not-unique") != std::string::npos);
    seen.insert(whole.find(" canonical") != std::string::npos);
    Dice dice(static_cast<std::uint64_t>(other));
    for (const Way way : {Way::kSlices, Way::kRoundRobin, Way::kAllToOne, Way::kSomeToNone}) {
      for (const std::size_t parts : {2, 5, 8, 11}) {
        CHECK(said_in_turns(Claim::kDelaunay, mesh, way, dice, {}, parts) == whole);
      }
    }
  }
  CHECK(seen.size() == 2);
}

// Doubles decide nothing where one part has coarse coordinates, another one none, and the facet
// between them is locally Delaunay or not by the last bits.
TEST_CASE("four points nearly on one circle are told in parts as in the whole") {
  std::set<std::string> seen;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    ArrayMesh mesh{.dimension = 2};
    mesh.coordinates = {3, 4, -4, 3, -3, -4};
    const double angle = 0.1 * static_cast<double>(1 + dice.below(14)) - 0.9;
    mesh.coordinates.push_back(5 * std::cos(angle));
    mesh.coordinates.push_back(5 * std::sin(angle));
    const bool is_other = dice.below(2) == 0;
    mesh.simplices = is_other ? std::vector<std::int64_t>{0, 1, 3, 1, 2, 3}
                              : std::vector<std::int64_t>{0, 1, 2, 0, 2, 3};
    const std::string whole = said_by_one(Claim::kDelaunay, mesh, {});
    seen.insert(whole.substr(0, 5));
    for (const std::size_t parts : {2, 3}) {
      Dice same(7);
      CHECK(said_in_turns(Claim::kDelaunay, mesh, Way::kSlices, same, {}, parts) == whole);
    }
  }
  CHECK(seen.size() == 2);
}

// Their facets match, and each is convex: the sample point alone tells that one covers the other.
TEST_CASE("a simplex within another one is covered twice, though each part has but one") {
  for (const std::size_t d : {2, 3}) {
    ArrayMesh mesh{.dimension = d};
    for (const double size : {1.0, 100.0}) {
      mesh.coordinates.insert(mesh.coordinates.end(), d, -size / 4);
      for (std::size_t v = 0; v < d; ++v) {
        for (std::size_t axis = 0; axis < d; ++axis) {
          mesh.coordinates.push_back(axis == v ? size : -size / 4);
        }
      }
    }
    for (std::size_t v = 0; v < 2 * (d + 1); ++v) {
      mesh.simplices.push_back(static_cast<std::int64_t>(v));
    }
    for (const Claim claim : {Claim::kTriangulation, Claim::kDelaunay}) {
      const std::string whole = said_by_one(claim, mesh, {});
      CHECK(whole.find("triangulation.covered-twice") != std::string::npos);
      for (const std::size_t parts : {2, 4}) {
        Dice same(7);
        CHECK(said_in_turns(claim, mesh, Way::kSlices, same, {}, parts) == whole);
      }
    }
  }
}

// A small simplex among points that are far away: nothing but its facets tells that it is there
// twice, and whoever looks at them. The numbers of the points decide who does. The points are so
// many that the parts stay as they were dealt.
TEST_CASE("a simplex that is listed again, by a part of its own, is told as in the whole") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const std::size_t d = 2 + dice.below(2);
    std::vector<Point> points(d + 1, Point(d, -1));
    for (std::size_t axis = 0; axis < d; ++axis) points[axis][axis] = 3;
    while (points.size() < 50) {
      Point& point = points.emplace_back();
      for (std::size_t axis = 0; axis < d; ++axis) {
        point.push_back((dice.below(2) == 0 ? 1 : -1) * static_cast<long>(20 + dice.below(1000)));
      }
    }
    shuffle(points, dice);
    const PointSet set(points);
    std::vector<Simplex> simplices = delaunay::bowyer_watson(set).simplices();
    const auto is_small = [&](const Simplex& simplex) {
      return std::all_of(simplex.begin(), simplex.end(), [&](Vertex v) {
        return abs(points[static_cast<std::size_t>(v)][0]) < 20;
      });
    };
    std::iter_swap(std::find_if(simplices.begin(), simplices.end(), is_small),
                   std::prev(simplices.end()));
    simplices.insert(simplices.begin(), simplices.back());
    const ArrayMesh mesh = array_mesh(set, simplices);
    const std::string whole = said_by_one(Claim::kDelaunay, mesh, {});
    CHECK(whole.find("fails: delaunay") != std::string::npos);
    CHECK(said_in_turns(Claim::kDelaunay, mesh, Way::kEndsApart, dice, {}, 3) == whole);
  }
}

TEST_CASE("a point beyond the hull is found in parts beside a submerged one, whichever is first") {
  for (const bool is_first : {false, true}) {
    ArrayMesh mesh = with_submerged_tie({1, 2});
    const std::size_t place = mesh.points() - (is_first ? 1 : 0);
    mesh.coordinates.insert(mesh.coordinates.begin() + static_cast<std::ptrdiff_t>(2 * place),
                            {-5, -5});
    mesh.weights.insert(mesh.weights.begin() + static_cast<std::ptrdiff_t>(place), -1000);
    const std::string whole = said_by_one(Claim::kWeightedDelaunay, mesh, {});
    CHECK(whole.find("fails: weighted-delaunay") != std::string::npos);
    for (std::uint64_t seed = 0; seed < 8; ++seed) {  // which says how many parts there are
      Dice dice(seed);
      CHECK(said_in_turns(Claim::kWeightedDelaunay, mesh, Way::kSlices, dice, {}, 3) == whole);
    }
  }
}

}  // namespace
}  // namespace circumspect::properties
