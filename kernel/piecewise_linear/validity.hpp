// Whether an input is a piecewise linear complex, and what is wrong with it if not. Book: Section
// 4.5.1, Definition 4.3.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/exact/progress.hpp"
#include "kernel/piecewise_linear/breach_kind.hpp"
#include "kernel/piecewise_linear/piecewise_linear_complex.hpp"

namespace circumspect {

// What is wrong with an input that is not a piecewise linear complex. Book: Definition 4.3.

// One breach with its witness: breaches.def says what each kind sets. Vertices are indices of the
// input, segments ascending pairs of them, polygons places in its list of polygons.
//
// The offset of a point q from the plane through a, b, c: with n = (b − a) × (c − a) and i the
// first axis on which |n_i| is greatest, n·(q − a) / n_i. It is the distance of q from the plane
// along axis i, positive in the direction of the axis.
struct Breach {
  BreachKind kind;
  std::vector<Vertex> vertices = {};
  std::vector<Simplex> segments = {};
  std::vector<std::size_t> polygons = {};
  std::optional<Point> point = {};
  std::optional<Rational> offset = {};
  std::optional<Rational> squared_distance = {};

  bool operator==(const Breach&) const = default;
};

inline constexpr std::size_t kBreachLimit = 20;

// Collects breaches up to a limit, at which the search may end.
class BreachList {
 public:
  // A limit of 0 means all. A caller that listens to each breach at once does not need all of them
  // kept, and there may be more than memory holds; then only the first kBreachLimit are kept.
  explicit BreachList(std::size_t limit, std::function<void(const Breach&)> on_breach = {})
      : limit_(limit), on_breach_(std::move(on_breach)) {}
  void add(Breach breach) {
    if (is_full()) return;
    ++count_;
    if (on_breach_) on_breach_(breach);
    if (!on_breach_ || count_ <= kBreachLimit) breaches_.push_back(std::move(breach));
  }
  bool is_full() const { return limit_ != 0 && count_ >= limit_; }
  bool empty() const { return count_ == 0; }
  std::size_t count() const { return count_; }
  const std::vector<Breach>& breaches() const { return breaches_; }  // those that are kept

 private:
  std::size_t limit_;
  std::function<void(const Breach&)> on_breach_;
  std::size_t count_ = 0;
  std::vector<Breach> breaches_;
};

// With n = (b − a) × (c − a) and i the first axis on which |n_i| is greatest, n·(q − a) / n_i: the
// distance of q from the plane through a, b, c along axis i, positive in the direction of the axis.
// Requires: three points of space that are not on one line.
Rational offset_from_plane(const std::vector<Point>& plane, const Point& q);

// The stages of `validated` that compare polygons with other cells. Book: Section 4.5.1, Definition
// 4.3.

// Each adds what it finds and ends early when the list is full.
// Stage 4. Requires: no breach of stage 3.
void find_piercing_segments(const PiecewiseLinearComplex& complex, const Progress& progress,
                            BreachList& found);

// Stage 5. Requires: no breach of stage 4.
void find_polygon_pair_breaches(const PiecewiseLinearComplex& complex, const Progress& progress,
                                BreachList& found);
void find_hole_seed_breaches(const PiecewiseLinearComplex& complex, BreachList& found);

// The listener of `validated`.
struct ValidityWatch {
  Progress progress = {};
  // Called with each breach as soon as it is found. Then at most kBreachLimit are returned.
  std::function<void(const Breach&)> on_breach = {};
};

// The complex that an input describes, or what keeps it from being one: at most `limit` breaches,
// or all if that is 0. Judged in stages, so that breaches are causes and not their consequences:
//
// 1. the lists: indices, duplicates, ends of segments;
// 2. every polygon's plane, and vertices and segments against one another: they must form a
//    simplicial complex (first condition of Definition 4.3);
// 3. what the lines of every polygon enclose, and its hole seeds;
// 4. segments against polygons: one that has an interior point in a polygon must lie in it
//    (Exercise 1 of Chapter 4), which it does unless it pierces the polygon, for to leave it within
//    its plane it would have to cross its boundary;
// 5. polygons against polygons, and the hole seeds of the domain against polygons.
//
// Legal are dangling polygons and segments, isolated vertices, open surfaces, slits, several lines
// a polygon, lines of two vertices or one, a segment listed twice or also an edge of a polygon, a
// line that passes an edge or a vertex again (not immediately), polygons that touch in a vertex.
// Anything that a polygon lists but that lies outside it belongs to the complex, not to the
// polygon. Requires: points and hole seeds all have the same dimension, 2 or 3; in the plane no
// polygon.
tl::expected<PiecewiseLinearComplex, std::vector<Breach>> validated(
    const PiecewiseLinearInput& input, std::size_t limit = kBreachLimit,
    const ValidityWatch& watch = {});

// How the polygons of a complex differ from what their lines list.
struct Adoption {
  std::size_t polygon;
  std::vector<Vertex> vertices;       // that lie in it, and were not listed
  std::vector<Simplex> segments;      // the same for slits
  std::vector<Vertex> left_vertices;  // that are listed and do not lie in it
  std::vector<Simplex> left_segments;
};

// The adoptions of polygons that differ, ascending. Requires: the complex is what validated or
// assemble made of the input.
std::vector<Adoption> adoptions(const PiecewiseLinearInput& input,
                                const PiecewiseLinearComplex& complex);

}  // namespace circumspect
