// Untidy domains: what is done to them, and that it is undone.
#include "inputs/untidy.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "inputs/cases.hpp"
#include "inputs/dice.hpp"
#include "inputs/in_doubles.hpp"
#include "kernel/piecewise_linear/arrangement.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "properties/arguments/generated.hpp"

namespace circumspect::generators {
namespace {

ComplexCase notched_square() {
  ComplexCase whole;
  whole.input.points = {{0, 0}, {8, 0}, {8, 8}, {4, 4}, {0, 8}};
  whole.input.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}};
  return whole;
}

// The first thing that is wrong with it; nothing if it is valid.
std::optional<BreachKind> breach(const PiecewiseLinearInput& input) {
  const auto valid = validated(input, 1);
  return valid ? std::nullopt : std::optional(valid.error().front().kind);
}

TEST_CASE("each kind of untidiness is what it says, and its arrangement is valid and of doubles") {
  const std::map<Untidiness, std::set<BreachKind>> expected = {
      {Untidiness::kTouching, {BreachKind::kVertexInSegment}},
      {Untidiness::kCrossing, {BreachKind::kVertexInSegment, BreachKind::kCrossingSegments}},
      {Untidiness::kOverlapping, {BreachKind::kVertexInSegment, BreachKind::kDuplicateVertex}},
      {Untidiness::kRepetition, {BreachKind::kDuplicateVertex}}};
  for (const auto& [untidiness, breaches] : expected) {
    const Untidiness kind = untidiness;
    std::set<BreachKind> met;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      Dice dice(seed);
      const ComplexCase untidy = untidied(dice, notched_square(), {kind});
      CHECK(!breach(arranged(untidy.input)));
      if (const auto found = breach(untidy.input)) met.insert(*found);
    }
    CAPTURE(name(kind));
    for (const BreachKind one : breaches) CHECK(met.count(one) == 1);
  }
}

TEST_CASE("in space: each kind of untidiness, and an arrangement that is valid and of doubles") {
  const std::map<Untidiness, std::set<BreachKind>> expected = {
      {Untidiness::kTouching, {BreachKind::kVertexInSegment}},
      {Untidiness::kCrossing, {BreachKind::kCrossingSegments, BreachKind::kSegmentPiercesPolygon}},
      {Untidiness::kOverlapping, {BreachKind::kVertexInSegment, BreachKind::kDuplicateVertex}},
      {Untidiness::kRepetition, {BreachKind::kDuplicateVertex}}};
  // A tetrahedron with a slit in its floor.
  ComplexCase whole;
  whole.input.points = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {1, 1, 0}, {2, 1, 0}};
  whole.input.polygons = {
      {{{0, 1, 2}, {4, 5}}, {}}, {{{0, 1, 3}}, {}}, {{{0, 2, 3}}, {}}, {{{1, 2, 3}}, {}}};
  for (const auto& [untidiness, breaches] : expected) {
    const Untidiness kind = untidiness;
    std::set<BreachKind> met;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      Dice dice(seed);
      const ComplexCase untidy = untidied(dice, whole, {kind});
      CHECK(untidy.input.polygons.size() == 4);
      const PiecewiseLinearInput tidy = arranged(untidy.input);
      CHECK(!breach(tidy));
      for (const Point& point : tidy.points)
        CHECK(std::all_of(point.begin(), point.end(), is_double));
      if (const auto found = breach(untidy.input)) met.insert(*found);
    }
    CAPTURE(name(kind));
    for (const BreachKind one : breaches) CHECK(met.count(one) == 1);
  }
}

TEST_CASE("a domain without segments stays as it is") {
  ComplexCase whole;
  whole.input.points = {{0, 0}, {1, 0}};
  Dice dice(1);
  CHECK(untidied(dice, whole, {Untidiness::kCrossing}).input.points.size() == 2);
}

}  // namespace
}  // namespace circumspect::generators
