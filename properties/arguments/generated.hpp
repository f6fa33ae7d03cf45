// The inputs of inputs/ as arguments of RapidCheck's properties: RapidCheck says with which seed they are
// drawn, and a failing one is made small as campaigns do it.
#pragma once

#include <vector>

#include <rapidcheck.h>

#include "inputs/dice.hpp"
#include "inputs/minimise.hpp"

namespace circumspect::generators {

// What `minimised` asks about if the case fails, as long as the answer is no: all cases that are simpler by one
// step. RapidCheck goes on with the first that fails.
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

}  // namespace circumspect::generators
