// The inputs of inputs/ as arguments of RapidCheck's properties: RapidCheck says with which seed
// they are drawn, and a failing one is made small as campaigns do it.
#pragma once

#include <utility>
#include <vector>

#include <rapidcheck.h>

#include "inputs/dice.hpp"
#include "inputs/minimise.hpp"
#include "kernel/exact/number.hpp"

namespace circumspect::generators {

// What `minimised` asks about if the case fails, as long as the answer is no: all cases that are
// simpler by one step. RapidCheck goes on with the first that fails.
template <class Case>
std::vector<Case> simpler(const Case& whole) {
  std::vector<Case> asked;
  minimised(whole, [&asked](const Case& candidate) {
    asked.push_back(candidate);
    return false;
  });
  return asked;
}

inline std::vector<std::vector<Point>> simpler(const std::vector<Point>& points) {
  std::vector<std::vector<Point>> asked;
  for (PointsCase& set : simpler(PointsCase{points})) asked.push_back(std::move(set.points));
  return asked;
}

// The same cases, but a failing one shrinks as `simpler` says, whatever it was made of.
template <class Case>
rc::Gen<Case> shrinking(const rc::Gen<Case>& cases) {
  return [cases](const rc::Random& random, int size) {
    return rc::shrinkable::shrinkRecur(cases(random, size).value(), [](const Case& whole) {
      return rc::seq::fromContainer(simpler(whole));
    });
  };
}

// What draw(dice) returns: points, weighted points or a complex.
template <class Draw>
auto generated(const Draw& draw) {
  using Case = decltype(draw(std::declval<Dice&>()));
  return shrinking(rc::Gen<Case>([draw](const rc::Random& random, int) {
    rc::Random seeds = random;
    Dice dice(seeds.next());
    return rc::shrinkable::just(Case(draw(dice)));
  }));
}

// Random numbers for properties. All shrink towards 0.

// Uniform in [0, count), whatever RapidCheck's size. Requires: count > 0.
inline rc::Gen<long> below(long count) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<long>(0, count));
}

// Uniform in [-bound, bound].
inline rc::Gen<long> integer_within(long bound) {
  // 0, 1, −1, 2, −2, …: RapidCheck shrinks the place in this row towards 0.
  return rc::gen::map(below(2 * bound + 1),
                      [](long place) { return place % 2 == 0 ? -place / 2 : (place + 1) / 2; });
}

inline rc::Gen<Rational> integer_number(long bound) {
  return rc::gen::map(integer_within(bound), [](long value) { return Rational(value); });
}

// Numerator at most 12 in absolute value, denominator at most 6.
inline rc::Gen<Rational> small_rational() {
  return rc::gen::map(rc::gen::pair(integer_within(12), below(6)),
                      [](const std::pair<long, long>& parts) {
                        Rational value(parts.first, parts.second + 1);
                        value.canonicalize();
                        return value;
                      });
}

}  // namespace circumspect::generators
