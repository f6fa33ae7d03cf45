// The parts of which the families of point sets are made.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

#include "inputs/dice.hpp"
#include "inputs/point_sets.hpp"

namespace circumspect::generators {

// Integers from -bound to bound.
Rational integer_number(Dice& dice, long bound);

// Numerator at most 12 in absolute value, denominator at most 6.
Rational small_rational(Dice& dice);

Rational power_of_two(long exponent);

// The results of `count` calls of draw().
template <class Draw>
auto several(std::size_t count, const Draw& draw) {
  std::vector<decltype(draw())> drawn;
  drawn.reserve(count);
  for (std::size_t i = 0; i < count; ++i) drawn.push_back(draw());
  return drawn;
}

// Integer coordinates from -bound to bound; those of a part of a grid.
Point integer_point(Dice& dice, std::size_t dimension, long bound);

// The points in the order given, without repetition.
std::vector<Point> distinct(const std::vector<Point>& points);

// Points that draw() returns, without repetition.
template <class Draw>
std::vector<Point> set_of(Dice& dice, Count count, const Draw& draw) {
  return distinct(several(count.drawn(dice), draw));
}

// A set of one of the families, all equally likely.
using Sets = std::vector<Point> (*)(Dice& dice, std::size_t dimension, Count count);
std::vector<Point> one_of(std::initializer_list<Sets> families, Dice& dice, std::size_t dimension,
                          Count count);

// The points, which may have fewer coordinates, carried into R^dimension by a random similarity
// with integer coefficients, so that grids stay grids and circles circles.
std::vector<Point> carried(Dice& dice, const std::vector<Point>& points, std::size_t dimension);

// The point of the unit sphere in R^{n+1} that stereographic projection sends to `image` in R^n.
Point from_stereographic(const Point& image);

// The number of symmetries of the cube in R^d, d! · 2^d, and the image of a point under one of
// them: a permutation of the coordinates and a choice of signs. Requires: dimension <= 16.
std::size_t cube_symmetries(std::size_t dimension);
Point symmetric_image(const Point& point, std::size_t code);

}  // namespace circumspect::generators
