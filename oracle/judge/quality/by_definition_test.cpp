// What is required of the shape of simplices: the fast judge and the definition find the same
// simplices, and what was measured of them is the same number. docs/theory/quality.md.
#include <doctest/doctest.h>

#include "inputs/dice.hpp"
#include "kernel/exact/angle.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/judge/definition/quality.hpp"
#include "oracle/judge/quality/exact_measure.hpp"
#include "oracle/judge/quality/filtered.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::quality {
namespace {

using generators::Dice;

constexpr std::size_t kCases = 10'000;

// On a small grid, where much is equal and much is flat; on one that was moved off the numbers of a
// few bits; far from the origin; or with a corner near the flat of the others.
Point drawn_point(Dice& dice, std::size_t space, std::size_t kind) {
  Point point;
  for (std::size_t axis = 0; axis < space; ++axis) {
    const Rational on_grid(dice.within(-3L, 3L));
    switch (kind) {
      case 0:
        point.push_back(on_grid);
        break;
      case 1:
        point.push_back(exact_value(on_grid.get_d() * 0.1 + 0.7));
        break;
      case 2:
        point.push_back(on_grid + 1'000'000'007L);
        break;
      default:
        point.push_back(on_grid + Rational(dice.within(-1L, 1L)) / (1L << 40));
    }
  }
  return point;
}

struct Drawn {
  Mesh mesh;
  std::vector<Point> points;
  std::vector<Simplex> simplices;
  int dimension;
};

Drawn drawn(Dice& dice) {
  const std::size_t space = dice.below(2) + 2;
  const std::size_t dimension = space == 2 ? 2 : dice.below(3) + 1;
  const std::size_t kind = dice.below(4);
  Drawn drawn{{}, {}, {}, static_cast<int>(dimension)};
  for (std::size_t i = 0; i < 6; ++i) drawn.points.push_back(drawn_point(dice, space, kind));
  for (std::size_t i = 0; i < 4; ++i) {
    Simplex& simplex = drawn.simplices.emplace_back();
    for (std::size_t j = 0; j <= dimension; ++j) {
      simplex.push_back(static_cast<Vertex>(dice.below(dice.below(20) == 0 ? 8 : 6)));
    }
  }
  drawn.mesh.coordinates = numbers_of(drawn.points, space);
  drawn.mesh.simplices = IndexLists(drawn.simplices);
  return drawn;
}

// A bound that a simplex of the mesh measures exactly, if it is not an angle, or nearly; or any.
Requirement drawn_requirement(Dice& dice, const Drawn& from) {
  const MeasureEntry* of = nullptr;
  do {
    of = &measures()[dice.below(measures().size())];
  } while (!exists_for(of->measure, from.dimension));
  Requirement requirement{of->measure, 0, ""};
  const auto found = measured(of->measure, from.mesh,
                              from.simplices[dice.below(from.simplices.size())], from.dimension);
  const bool is_near = found && dice.below(4) != 0;
  if (of->is_angle) {
    requirement.bound = Rational(dice.within(0L, 1800L)) / 10;
    if (dice.below(2) == 0) requirement.bound = 15 * dice.within(0L, 12L);
    if (is_near) {
      requirement.bound =
          read_number(degrees_to_decimal(found->value), NumberReading::kDecimal).value();
    }
    return requirement;
  }
  requirement.bound = is_near ? found->value : Rational(dice.within(0L, 400L)) / 10;
  if (is_near && dice.below(3) == 0) requirement.bound *= 1 + Rational(1) / (1L << 52);
  return requirement;
}

TEST_CASE("fast and by definition the same simplices do not keep a requirement") {
  std::size_t kept = 0, broken = 0;
  for (std::size_t seed = 0; seed < kCases; ++seed) {
    if (seed % properties::kOneInputIn != 0) continue;
    Dice dice(seed);
    const Drawn from = drawn(dice);
    const Requirement requirement = drawn_requirement(dice, from);
    CAPTURE(seed);
    const auto fast = violators(from.mesh, {requirement}, 1);
    REQUIRE(fast.size() == 1);
    CHECK(fast[0] == definition::not_keeping(requirement, from.points, from.simplices));
    broken += fast[0].size();
    kept += from.simplices.size() - fast[0].size();
  }
  CHECK(kept > kCases / properties::kOneInputIn / 2);
  CHECK(broken > kCases / properties::kOneInputIn / 2);
}

TEST_CASE("what is measured by polynomials is what the definition measures") {
  std::size_t compared = 0;
  for (std::size_t seed = 0; seed < kCases; ++seed) {
    if (seed % properties::kOneInputIn != 0) continue;
    Dice dice(seed);
    const Drawn from = drawn(dice);
    const Simplex& simplex = from.simplices.front();
    std::vector<Point> corners;
    for (const Vertex v : simplex) {
      if (from.mesh.names(v)) corners.push_back(from.mesh.point(v));
    }
    for (const MeasureEntry& one : measures()) {
      if (!exists_for(one.measure, from.dimension)) continue;
      CAPTURE(seed);
      CAPTURE(one.name);
      const auto found = measured(one.measure, from.mesh, simplex, from.dimension);
      const auto expected = corners.size() == simplex.size()
                                ? definition::measured(one.measure, corners)
                                : std::nullopt;
      REQUIRE(found.has_value() == expected.has_value());
      if (!found) continue;
      CHECK(found->value == *expected);
      ++compared;
    }
  }
  CHECK(compared > kCases / properties::kOneInputIn);
}

// Simplices are looked at in chunks of some thousands, by threads.
TEST_CASE("of simplices that are listed a thousand times over the same is said a thousand times") {
  constexpr std::size_t kTimes = 3000;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    CAPTURE(seed);
    Dice dice(seed);
    const Drawn once = drawn(dice);
    const Requirement requirement = drawn_requirement(dice, once);
    const std::vector<std::size_t> expected =
        definition::not_keeping(requirement, once.points, once.simplices);
    std::vector<Simplex> often;
    for (std::size_t i = 0; i < kTimes; ++i) {
      often.insert(often.end(), once.simplices.begin(), once.simplices.end());
    }
    Mesh mesh;
    mesh.coordinates = numbers_of(once.points, once.points.front().size());
    mesh.simplices = IndexLists(often);
    const std::vector<std::size_t> found = violators(mesh, {requirement}, 2).front();
    REQUIRE(found.size() == kTimes * expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      REQUIRE(found[i] ==
              once.simplices.size() * (i / expected.size()) + expected[i % expected.size()]);
    }
  }
}

}  // namespace
}  // namespace circumspect::quality
