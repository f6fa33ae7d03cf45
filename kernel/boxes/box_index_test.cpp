// Boxes around exact points, and their index.
#include "kernel/boxes/box_index.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "kernel/boxes/point_search.hpp"

namespace circumspect {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Rational rational_power_of_two(unsigned exponent) {
  Integer power = 1;
  power <<= exponent;
  return power;
}

TEST_CASE("lower_double, upper_double: neighbours around what is not a double") {
  const std::vector<Rational> values = {Rational(1, 3),
                                        Rational(-1, 3),
                                        Rational(22, 7),
                                        Rational(-1, 10),
                                        Rational(1) / rational_power_of_two(2000),
                                        Rational(-1) / rational_power_of_two(2000)};
  for (const Rational& value : values) {
    CHECK(exact_value(lower_double(value)) < value);
    CHECK(exact_value(upper_double(value)) > value);
    CHECK(std::nextafter(lower_double(value), kInfinity) == upper_double(value));
  }
}

TEST_CASE("lower_double, upper_double: a double is itself") {
  for (const double value : {0.0, 1.0, -0.1, 5e-324, -5e-324, 1e308}) {
    CHECK(lower_double(exact_value(value)) == value);
    CHECK(upper_double(exact_value(value)) == value);
  }
}

TEST_CASE("lower_double, upper_double: beyond all doubles") {
  CHECK(upper_double(rational_power_of_two(5000)) == kInfinity);
  CHECK(lower_double(rational_power_of_two(5000)) == std::numeric_limits<double>::max());
  CHECK(lower_double(-rational_power_of_two(5000)) == -kInfinity);
  CHECK(upper_double(-rational_power_of_two(5000)) == std::numeric_limits<double>::lowest());
}

TEST_CASE("box_around: points and boxes") {
  const Box box = box_around(box_around(Point{0, 5}), box_around(Point{Rational(1, 3), 2}));
  CHECK(box.low[0] == 0);
  CHECK(box.high[0] > 0.333);
  CHECK((box.low[1] == 2 && box.high[1] == 5));
  CHECK((box.low[2] == 0 && box.high[2] == 0));
  CHECK(box.low[4] == -5);  // x − y
}

TEST_CASE("box_around: the doubles next to each coordinate") {
  const std::vector<Rational> values = {0,
                                        -3,
                                        Rational(1, 3),
                                        Rational(-22, 7),
                                        exact_value(5e-324) / 3,
                                        exact_value(-1e-310) / 3,
                                        Rational(-1) / rational_power_of_two(2000),
                                        rational_power_of_two(5000),
                                        -rational_power_of_two(5000)};
  for (const Rational& value : values) {
    const Box box = box_around(Point{value, 1});
    CHECK(box.low[0] == lower_double(value));
    CHECK(box.high[0] == upper_double(value));
  }
}

TEST_CASE("may_meet: in a point, past each other, aslant past each other") {
  const auto segment = [](const Point& a, const Point& b) {
    return box_around(box_around(a), box_around(b));
  };
  const Box diagonal = segment({0, 0, 0}, {9, 9, 0});
  CHECK(may_meet(diagonal, segment({9, 9, 0}, {10, 0, 3})));
  CHECK_FALSE(may_meet(diagonal, segment({10, 0, 0}, {11, 9, 0})));
  CHECK_FALSE(may_meet(diagonal, segment({1, 0, 0}, {10, 9, 0})));
  CHECK_FALSE(may_meet(segment({0, 0, 0}, {0, 9, -9}), segment({0, 0, 1}, {0, 9, -8})));
}

TEST_CASE("may_meet_inside: what touches in a plane does not, unless all of the cell lies in it") {
  const auto segment = [](const Point& a, const Point& b) {
    return box_around(box_around(a), box_around(b));
  };
  const Box rising = segment({0, 0, 0}, {4, 2, 1}), falling = segment({0, 2, 0}, {4, 0, -1});
  const Box flat = segment({0, 2, 0}, {4, 0, 0});
  CHECK(may_meet(rising, falling));
  CHECK_FALSE(may_meet_inside(rising, falling));
  CHECK(may_meet_inside(flat, rising));
  CHECK_FALSE(may_meet_inside(rising, flat));
  CHECK(may_meet_inside(flat, segment({0, 1, -1}, {4, 1, 1})));
  // No double is a third, so the rounded bounds are not attained.
  const Rational third(1, 3);
  CHECK(may_meet_inside(segment({0, 0, third}, {4, 2, third}),
                        segment({0, 1, third}, {4, 1, third})));
}

// Boxes on a small grid, so that many touch in a face, an edge or a corner; every tenth is
// unbounded.
std::vector<Box> some_boxes(std::size_t count) {
  std::vector<Box> boxes;
  Rational far = 1;
  for (int i = 0; i < 5000; ++i) far *= 2;
  unsigned state = 7;
  const auto next = [&] { return (state = state * 1103515245u + 12345u) >> 16 & 15u; };
  for (std::size_t i = 0; i < count; ++i) {
    const Point low = {next(), next(), i % 10 == 0 ? -far : Rational(next())};
    const Point high = {low[0] + next() % 4, i % 20 == 0 ? far : low[1] + next() % 4, low[2] + 1};
    boxes.push_back(box_around(box_around(low), box_around(high)));
  }
  return boxes;
}

TEST_CASE("BoxIndex: finds exactly the boxes that meet") {
  const std::vector<Box> boxes = some_boxes(400);
  const BoxIndex index(boxes);
  for (const Box& box : boxes) {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (may_meet(boxes[i], box)) expected.push_back(i);
    }
    CHECK(index.meeting(box) == expected);
  }
}

TEST_CASE("BoxIndex: of nothing") { CHECK(BoxIndex({}).meeting(box_around(Point{0, 0})).empty()); }

}  // namespace
}  // namespace circumspect
