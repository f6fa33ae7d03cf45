// Arrays of points, and predicates on them with doubles, as people write them.
#pragma once

#include <span>
#include <utility>

#include <circumspect/subject.hpp>

#include "kernel/complex/point_set.hpp"

namespace circumspect::faulty {

// From the doubles that a program takes to the exact points that judge it, and right answers to
// begin with.

// The exact points, weights included. Requires: no duplicates.
PointSet exact_points(const PointArray& points);

// The canonical (weighted) Delaunay triangulation. Of points that coincide, the first stands for
// all.
SimplexArray right_answer(const PointArray& points);

// The same points without, or with only, some of them.
PointArray selection(const PointArray& points, const std::vector<Vertex>& kept);

// The simplices of a selection, in the numbers of the whole.
SimplexArray renumbered(SimplexArray simplices, const std::vector<Vertex>& kept);

// All indices of the points, ascending.
std::vector<Vertex> every_index(const PointArray& points);

// The least and the largest coordinate on an axis. Requires: points.size() > 0.
std::pair<double, double> extent(const PointArray& points, std::size_t axis);

// Orientation and in-ball tests as people write them, over the number type of one's choice and with
// the mistake of one's choice.

// The 64 bits wrap round, as those of processors do.
enum class Numbers { kExact, kLongDouble, kDouble, kFloat, kWrapping };

// Without any of the mistakes, and with exact numbers, the tests are right.
struct Arithmetic {
  Numbers numbers = Numbers::kExact;
  double in_ball_tolerance = 0;        // a determinant must exceed it to put a point into a ball
  double orientation_tolerance = 0;    // one of at most this size is called zero
  double trusted_beyond = 0;           // > 0: only smaller determinants are computed exactly
  bool by_circumcentre = false;        // compares distances from a circumcentre computed in doubles
  bool circumballs_in_floats = false;  // and stores it, with its radius, in single precision
  bool forgets_last_axis = false;      // in the height |p|² of a point
  bool heights_from_the_origin = false;  // |p|² − |q|² for |p − q|², each computed first
};

// The vertices of an array, and possibly more, as numbers for both ways to compute.
class PlainPredicates {
 public:
  PlainPredicates(const PointArray& points, const PointSet& exact, const Arithmetic& arithmetic)
      : points_(points), exact_(exact), arithmetic_(arithmetic) {}

  // The signs of orientation.hpp and in_ball.hpp, or what the mistakes make of them.
  int orientation(std::span<const std::size_t> axes, std::span<const Vertex> simplex) const;
  int in_ball(std::span<const std::size_t> axes, std::span<const Vertex> simplex, Vertex q) const;

 private:
  template <typename Number>
  Number orientation_of(std::span<const std::size_t> axes, std::span<const Vertex> simplex) const;
  template <typename Number>
  Number in_ball_of(std::span<const std::size_t> axes, std::span<const Vertex> simplex,
                    Vertex q) const;
  int in_computed_ball(std::span<const std::size_t> axes, std::span<const Vertex> simplex,
                       Vertex q) const;
  long double in_numbers(bool is_orientation, std::span<const std::size_t> axes,
                         std::span<const Vertex> simplex, Vertex q) const;

  const PointArray& points_;
  const PointSet& exact_;
  Arithmetic arithmetic_;
};

}  // namespace circumspect::faulty
