// Is an input a piecewise linear complex? Book: Section 4.5.1, Definition 4.3.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "reference/kernel/exact/progress.hpp"
#include "reference/kernel/piecewise_linear/breach.hpp"
#include "reference/kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// Who waits for `validated`.
struct ValidityWatch {
  Progress progress = {};
  // Hears of each breach as soon as it is found. Then no more than kBreachLimit come back.
  std::function<void(const Breach&)> on_breach = {};
};

// The complex that an input describes, or what keeps it from being one: at most `limit` breaches, or
// all if that is 0. Judged in stages, so that breaches are causes and not their consequences:
//
// 1. the lists: indices, duplicates, ends of segments;
// 2. every polygon's plane, and vertices and segments against one another: they must form a
//    simplicial complex (first condition of Definition 4.3);
// 3. what the lines of every polygon enclose, and its hole seeds;
// 4. segments against polygons: one that has an interior point in a polygon must lie in it (Exercise
//    1 of Chapter 4), which it does unless it pierces the polygon, for to leave it within its plane it
//    would have to cross its boundary;
// 5. polygons against polygons, and the hole seeds of the domain against polygons.
//
// Legal are dangling polygons and segments, isolated vertices, open surfaces, slits, several lines a
// polygon, lines of two vertices or one, a segment listed twice or also an edge of a polygon, a line
// that passes an edge or a vertex again (not at once), polygons that touch in a vertex. What a polygon
// lists but what lies outside it belongs to the complex, not to the polygon.
// Requires: points and hole seeds all have the same dimension, 2 or 3; in the plane no polygon.
tl::expected<PiecewiseLinearComplex, std::vector<Breach>> validated(
    const PiecewiseLinearInput& input, std::size_t limit = kBreachLimit,
    const ValidityWatch& watch = {});

// How the polygons of a complex differ from what their lines list.
struct Adoption {
  std::size_t polygon;
  std::vector<Vertex> vertices;       // that lie in it, and were not listed
  std::vector<Simplex> segments;      // likewise: slits
  std::vector<Vertex> left_vertices;  // that are listed and do not lie in it
  std::vector<Simplex> left_segments;
};

// Those of polygons that differ, ascending.
// Requires: the complex is what validated or assemble made of the input.
std::vector<Adoption> adoptions(const PiecewiseLinearInput& input,
                                const PiecewiseLinearComplex& complex);

}  // namespace circumspect
