// Any bytes give points, and the mutator turns bytes into bytes.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <circumspect/fuzz.hpp>
#include <doctest/doctest.h>

#include "fuzz/harness/cases.hpp"
#include "inputs/dice.hpp"

namespace circumspect {
namespace {

using Bytes = std::vector<std::uint8_t>;

PointArray points_of(const Bytes& bytes, std::size_t dimension, bool weighted = false) {
  return points_from_bytes(bytes.data(), bytes.size(), dimension, weighted);
}

Bytes random_bytes(std::size_t count, generators::Dice& dice) {
  Bytes bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(dice.below(256));
  return bytes;
}

void check_sound(const PointArray& points, std::size_t dimension, bool weighted) {
  REQUIRE(points.size() <= 64);
  REQUIRE(points.dimension == dimension);
  REQUIRE(points.weights.size() == (weighted ? points.size() : 0));
  std::set<std::vector<double>> distinct;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<double> point(points.point(i), points.point(i) + dimension);
    REQUIRE(distinct.insert(point).second);
    REQUIRE(std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); }));
  }
}

TEST_CASE("any bytes are distinct, finite points") {
  generators::Dice dice(1);
  for (int i = 0; i < 500; ++i) {
    const Bytes bytes = random_bytes(dice.below(400), dice);
    for (const std::size_t dimension : {2, 3}) {
      check_sound(points_of(bytes, dimension), dimension, false);
      check_sound(points_of(bytes, dimension, true), dimension, true);
    }
  }
  CHECK(points_from_bytes(nullptr, 0, 3).size() == 0);
  CHECK(points_of({1, 2, 3, 4}, 3).size() == 0);
}

TEST_CASE("each kind of step makes the point that it promises") {
  const auto last = [](const Bytes& bytes) {
    const PointArray points = points_of(bytes, 3);
    const double* const point = points.point(points.size() - 1);
    return std::vector<double>(point, point + 3);
  };
  const Bytes first = {0, 9, 10, 11, 0};
  const auto after_first = [&](const Bytes& step) {
    Bytes bytes = first;
    bytes.insert(bytes.end(), step.begin(), step.end());
    return last(bytes);
  };
  using Point = std::vector<double>;
  CHECK(last(first) == Point{1, 2, 3});
  CHECK(last({1, 127, 128, 255, 0}) == Point{127, -128, -1});
  CHECK(after_first({3, 0, 1, 0, 0}) == Point{1, std::nextafter(2.0, 3.0), 3});
  CHECK(after_first({3, 0, 1, 1, 0}) == Point{1, std::nextafter(2.0, 1.0), 3});
  CHECK(after_first({5, 0, 4, 0, 0}) == Point{16, 32, 48});
  CHECK(after_first({6, 0, 2, 8, 0}) == Point{1, 2, 19});
  CHECK(after_first({7, 0, 3, 0, 0}) == Point{-1, -2, 3});
  CHECK(last({0, 9, 8, 8, 0, 0, 8, 9, 8, 0, 0, 8, 8, 8, 0, 4, 0, 1, 2, 0}) == Point{1, 1, 0});
}

TEST_CASE("round steps lie on one sphere exactly") {
  generators::Dice dice(2);
  for (const std::size_t dimension : {2, 3}) {
    Bytes bytes;
    for (int i = 0; i < 60; ++i) {
      const Bytes step = random_bytes(5, dice);
      bytes.insert(bytes.end(), step.begin(), step.end());
      bytes[bytes.size() - 5] = 2;
    }
    const PointArray points = points_of(bytes, dimension);
    CHECK(points.size() > 10);
    for (std::size_t i = 0; i < points.size(); ++i) {
      double square = 0;
      for (std::size_t axis = 0; axis < dimension; ++axis) {
        square += points.point(i)[axis] * points.point(i)[axis];
      }
      CHECK(square == (dimension == 2 ? 65.0 * 65.0 : 81.0));
    }
  }
}

TEST_CASE("the mutator keeps within bounds, is repeatable, and changes things") {
  generators::Dice dice(3);
  std::size_t changed = 0;
  for (unsigned int seed = 0; seed < 2000; ++seed) {
    const std::size_t room = dice.below(100);
    Bytes bytes = random_bytes(dice.below(room + 1), dice);
    const std::size_t size = bytes.size();
    const Bytes before = bytes;
    bytes.resize(room, 0xee);
    bytes.resize(room + 8, 0xcc);
    Bytes again = bytes;
    const std::size_t now = mutate_bytes(bytes.data(), size, room, seed);
    REQUIRE(now <= room);
    REQUIRE(now % 5 == 0);
    REQUIRE(std::all_of(bytes.begin() + static_cast<std::ptrdiff_t>(room), bytes.end(),
                        [](std::uint8_t byte) { return byte == 0xcc; }));
    REQUIRE(mutate_bytes(again.data(), size, room, seed) == now);
    REQUIRE(again == bytes);
    bytes.resize(now);
    changed += bytes == before ? 0u : 1u;
  }
  CHECK(changed > 1500);
}

TEST_CASE("a right program passes, and inputs that are not wanted do not reach it") {
  const Bytes line = {0, 8, 8, 8, 0, 0, 9, 8, 8, 0};  // two points of space
  std::size_t calls = 0;
  const Triangulator joins = [&](const PointArray& points) -> SimplexArray {
    ++calls;
    if (points.size() == 1) return {{0}};
    return {{0, 1}};
  };
  const auto run = [&](const FuzzOptions& options) {
    return fuzz_once(joins, options, line.data(), line.size());
  };
  CHECK(run({}) == 0);
  CHECK(calls == 1);
  CHECK(run({.flat_sets = false}) == 0);
  CHECK(run({.min_points = 3}) == 0);
  CHECK(fuzz_once(joins, {}, line.data(), 0) == 0);
  CHECK(calls == 1);
}

}  // namespace
}  // namespace circumspect
