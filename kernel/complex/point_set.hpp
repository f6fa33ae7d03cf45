// Finite point sets, and the affine hulls of some of their points.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/complex/simplex.hpp"
#include "kernel/exact/point.hpp"
#include "kernel/predicates/configuration.hpp"

namespace circumspect {

// Two indices that name one and the same point.
struct Duplicate {
  Vertex kept;  // the first of them
  Vertex again;
};

// Every point that repeats an earlier one, in order of `again`.
std::vector<Duplicate> duplicates(const std::vector<Point>& points);

// A finite *set* of points, weighted or not, with exact rational coordinates: no two points are
// equal. All points have one dimension. Book: Section 4.1 (point sets in R^d), Section 5.2
// (weights).
class PointSet {
 public:
  // Requires: no duplicates; one dimension; weights empty or one a point. (Violations are
  // programming errors; call `duplicates` first on a user's points.)
  explicit PointSet(std::vector<Point> points, std::vector<Rational> weights = {});

  std::size_t size() const { return points_.size(); }
  bool empty() const { return points_.empty(); }
  bool is_weighted() const { return !weights_.empty(); }
  const std::vector<Point>& points() const { return points_; }
  const Point& operator[](Vertex v) const { return points_[static_cast<std::size_t>(v)]; }
  Rational weight(Vertex v) const {
    return weights_.empty() ? Rational(0) : weights_[static_cast<std::size_t>(v)];
  }
  // The number of coordinates, d (0 for the empty set), and the dimension of the affine hull, k.
  std::size_t ambient_dimension() const { return configuration_.ambient_dimension(); }
  int dimension() const { return configuration_.dimension(); }
  bool names(Vertex v) const { return v >= 0 && v < static_cast<Vertex>(size()); }

  // The same points as integers, for the predicates.
  const Configuration& configuration() const { return configuration_; }

 private:
  std::vector<Point> points_;
  std::vector<Rational> weights_;
  Configuration configuration_;
};

// The coordinates of the vertices of a simplex. Requires: the set names all of them.
std::vector<Point> coordinates(const PointSet& points, const Simplex& simplex);

// The arithmetic mean of its vertices, a point of its relative interior.
Point barycentre(const PointSet& points, const Simplex& simplex);

// The simplex with two vertices swapped if that makes its orientation positive.
// Requires: simplex.size() == points.dimension() + 1, not degenerate; a single vertex is positive.
Simplex positively_oriented(const PointSet& points, Simplex simplex);
// The same on some axes, a coordinate system of the simplex's affine hull.
Simplex positively_oriented(const PointSet& points, std::span<const std::size_t> axes,
                            Simplex simplex);

// The affine hull of some points of a set: where a face of a polyhedral complex lives. Book:
// Section 4.1 ("if the affine hull of S is k-dimensional …"). k+1 affinely independent points of
// it, and k axes that are a coordinate system of it.
struct Flat {
  Simplex basis;  // the first independent points in the order given
  std::vector<std::size_t> axes;

  std::size_t dimension() const { return axes.size(); }
};

// Requires: members is not empty.
Flat flat_through(const PointSet& points, const std::vector<Vertex>& members);

// The same for the members projected on some axes only.
Flat flat_through(const PointSet& points, const std::vector<std::size_t>& axes,
                  const std::vector<Vertex>& members);

// The vertices 0, 1, …, n−1.
std::vector<Vertex> all_vertices(const PointSet& points);

}  // namespace circumspect
