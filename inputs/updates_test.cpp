#include "inputs/updates.hpp"

#include <algorithm>

#include <doctest/doctest.h>

#include "inputs/minimise.hpp"
#include "inputs/relations.hpp"

namespace circumspect::generators {
namespace {

const std::set<UpdateKind> kAll = {UpdateKind::kInsert, UpdateKind::kDelete, UpdateKind::kRestore};

PointsCase on_parabola(int count) {
  PointsCase set;
  for (int i = 0; i < count; ++i) set.points.push_back({Rational(i), Rational(i * i)});
  return set;
}

std::size_t count_of(const UpdatesCase& whole, UpdateKind kind) {
  return static_cast<std::size_t>(
      std::count_if(whole.updates.begin(), whole.updates.end(),
                    [kind](const Update& update) { return update.kind == kind; }));
}

TEST_CASE("updates that are drawn are possible, of the kinds asked for, and bring all points") {
  bool some_come_back = false;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Dice dice(seed);
    const UpdatesCase whole = with_updates(dice, on_parabola(12), kAll);
    REQUIRE(is_sound(whole));
    CHECK(whole.set.points.size() >= 12);
    CHECK(first_places(whole).size() + count_of(whole, UpdateKind::kInsert) ==
          whole.set.points.size());
    CHECK(last_places(whole).size() + count_of(whole, UpdateKind::kDelete) ==
          whole.set.points.size());
    some_come_back = some_come_back || whole.set.points.size() > 12;
    Dice again(seed);
    const UpdatesCase only = with_updates(again, on_parabola(12), {UpdateKind::kInsert});
    CHECK(count_of(only, UpdateKind::kInsert) == only.updates.size());
    CHECK(last_places(only).size() == 12);
  }
  CHECK(some_come_back);
  Dice dice(1);
  CHECK(with_updates(dice, {}, kAll).set.points.empty());
}

TEST_CASE("what is there in the end comes in the order in which it came") {
  const UpdatesCase whole = {on_parabola(4),
                             {{UpdateKind::kInsert, 1},
                              {UpdateKind::kDelete, 2},
                              {UpdateKind::kRestore},
                              {UpdateKind::kInsert, 0}}};
  CHECK(is_sound(whole));
  CHECK(first_places(whole) == std::vector<std::size_t>{2, 3});
  CHECK(last_places(whole) == std::vector<std::size_t>{3, 1, 0});
  CHECK(is_ever_flat(whole, 2));
}

TEST_CASE("updates that cannot be are none") {
  const PointsCase set = on_parabola(3);
  CHECK(!is_sound({set, {{UpdateKind::kDelete, 3}}}));
  CHECK(!is_sound({set, {{UpdateKind::kDelete, 1}, {UpdateKind::kDelete, 1}}}));
  CHECK(!is_sound({set, {{UpdateKind::kInsert, 1}, {UpdateKind::kInsert, 1}}}));
  CHECK(!is_sound({set, {{UpdateKind::kDelete, 1}, {UpdateKind::kInsert, 1}}}));
  PointsCase twice = set;
  twice.points.push_back(set.points[0]);
  CHECK(!is_sound({twice}));
  CHECK(!is_sound({twice, {{UpdateKind::kInsert, 3}}}));
  CHECK(is_sound({twice, {{UpdateKind::kDelete, 0}, {UpdateKind::kInsert, 3}}}));
}

TEST_CASE("a time at which the points lie in a hyperplane is found") {
  // The fourth point is on the line of the first two.
  const PointsCase set = {{{0, 0}, {1, 0}, {0, 1}, {2, 0}}, {}};
  CHECK(!is_ever_flat({set}, 2));
  CHECK(is_ever_flat({set, {{UpdateKind::kDelete, 2}}}, 2));
  CHECK(is_ever_flat({set, {{UpdateKind::kInsert, 2}}}, 2));
  CHECK(!is_ever_flat({set, {{UpdateKind::kDelete, 0}}}, 2));
  CHECK(is_ever_flat({set, {{UpdateKind::kDelete, 0}, {UpdateKind::kDelete, 1}}}, 2));
}

TEST_CASE("of many updates those are left that do it") {
  // A point was deleted and came back. Only possible updates are asked about.
  const auto fails = [](const UpdatesCase& candidate) {
    CHECK(is_sound(candidate));
    for (std::size_t i = 0; i < candidate.updates.size(); ++i) {
      if (candidate.updates[i].kind != UpdateKind::kDelete) continue;
      for (std::size_t k = i; k < candidate.updates.size(); ++k) {
        const bool is_back = candidate.updates[k].kind == UpdateKind::kInsert &&
                             candidate.set.points[candidate.updates[k].point] ==
                                 candidate.set.points[candidate.updates[i].point];
        if (is_back) return true;
      }
    }
    return false;
  };
  UpdatesCase whole;
  for (std::uint64_t seed = 0; !fails(whole); ++seed) {
    REQUIRE(seed < 100);
    Dice dice(seed);
    whole = with_updates(dice, on_parabola(30), kAll);
  }
  const UpdatesCase small = minimised(whole, fails);
  CHECK(is_sound(small));
  CHECK(small.set.points == std::vector<Point>{{0, 0}, {0, 0}});
  CHECK(small.updates == std::vector<Update>{{UpdateKind::kDelete, 0}, {UpdateKind::kInsert, 1}});
}

TEST_CASE("each relation changes the points exactly, and as it says") {
  const PointsCase set = {{{1, 0}, {Rational(5, 4), 3}, {-2, 7}, {8, 9}}, {1, 2, 3, 4}};
  const PointsCase other = *image(Relation::kOrder, set);
  CHECK(other.points != set.points);
  CHECK(std::is_permutation(other.points.begin(), other.points.end(), set.points.begin()));
  for (std::size_t v = 0; v < 4; ++v) {
    const auto at = std::find(set.points.begin(), set.points.end(), other.points[v]);
    CHECK(other.weights[v] == set.weights[static_cast<std::size_t>(at - set.points.begin())]);
  }
  CHECK(image(Relation::kReflection, set)->points[2] == Point{2, 7});
  const PointsCase moved = *image(Relation::kTranslation, set);
  CHECK(moved.points[1] - moved.points[0] == set.points[1] - set.points[0]);
  CHECK(moved.points[0][0] == 65);  // 64 is four times as much as the least power of two above all
  CHECK(moved.weights == set.weights);
  const PointsCase smaller = *image(Relation::kScaling, set);
  CHECK(smaller.points[3] == Point{Rational(1, 16384), Rational(9, 131072)});
  CHECK(smaller.weights[0] * 131072 * 131072 == 1);
  const PointsCase repeated = *image(Relation::kRepetition, set);
  CHECK(repeated.points.size() == 6);
  CHECK(repeated.points[5] == set.points[3]);
  CHECK(repeated.weights[5] == 4);
}

TEST_CASE("where there is no exact image there is none") {
  CHECK(!image(Relation::kOrder, PointsCase{{{1, 2}}, {}}));
  CHECK(!image(Relation::kRepetition, PointsCase{}));
  // Four times the size is beyond the doubles, and so are all moves down to this one.
  const PointsCase far{{{exact_value(0x1p1023), 0}, {0, 1}}, {}};
  CHECK(image(Relation::kTranslation, far)->points[0][0] == exact_value(0x1.8p1023));
  CHECK(!image(Relation::kTranslation, PointsCase{}));
  // One number uses all 53 bits, and another has a bit far below: any translation loses a bit.
  const Rational long_number = exact_value(0x1.ffffffffffffdp0);
  CHECK(!image(Relation::kTranslation,
               PointsCase{{{long_number, 0}, {exact_value(0x1.8p-140), 0}}, {}}));
  CHECK(!image(Relation::kScaling,
               PointsCase{{{exact_value(0x1.8p3), exact_value(0x1.8p-1073)}}, {}}));
}

TEST_CASE("a domain in another order has the same cells") {
  ComplexCase whole;
  whole.input.points = {{0, 0}, {4, 0}, {0, 4}, {1, 1}};
  whole.input.segments = {{0, 1}, {1, 2}, {0, 2}};
  whole.input.hole_seeds = {{1, 2}};
  const auto ends = [](const ComplexCase& one) {
    std::set<std::set<Point>> all;
    for (const auto& segment : one.input.segments) {
      all.insert({one.input.points[static_cast<std::size_t>(segment[0])],
                  one.input.points[static_cast<std::size_t>(segment[1])]});
    }
    return all;
  };
  const ComplexCase other = *image(Relation::kOrder, whole);
  CHECK(other.input.points != whole.input.points);
  CHECK(ends(other) == ends(whole));
  CHECK(image(Relation::kReflection, whole)->input.hole_seeds[0] == Point{-1, 2});
  CHECK(!image(Relation::kRepetition, whole));
}

}  // namespace
}  // namespace circumspect::generators
