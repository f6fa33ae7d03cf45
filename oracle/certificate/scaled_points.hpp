// Points as integers with one common scale, as a certificate lists them, and their sides of facets.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/boxes/interval.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/judge/fast/predicates/site.hpp"
#include "oracle/model/index_lists.hpp"

namespace circumspect::certificate {

// Points as integers over one scale, as small as they can be: what a certificate lists.

// Ten gigabytes of digits make no file that anyone would keep.
inline constexpr double kMostBits = 3e10;

// The points are the integer points times P/Q, the weights the integer weights times (P/Q)².
struct ScaledPoints {
  std::size_t dimension = 0;  // the number of coordinates, d
  Integer scale_numerator = 1;
  Integer scale_denominator = 1;
  std::vector<Integer> coordinates = {};  // d a point
  std::vector<Integer> weights = {};      // empty, or one a point

  std::size_t size() const { return dimension == 0 ? 0 : coordinates.size() / dimension; }
  const Integer& coordinate(Vertex v, std::size_t axis) const {
    return coordinates[static_cast<std::size_t>(v) * dimension + axis];
  }
};

// Multiplies by the least common denominator of all coordinates and divides by what they have in
// common; both are positive. Weights may make the scale finer. Error: denominators that have so
// little in common that the coordinates may take more than `most_bits` together.
tl::expected<ScaledPoints, std::string> scaled_to_integers(const PointSet& points,
                                                           double most_bits = kMostBits);

// The same of one point a row, without weights. Requires: finite numbers.
tl::expected<ScaledPoints, std::string> scaled_to_integers(const Rows<double>& points,
                                                           double most_bits = kMostBits);

// A point with rational coordinates among the integer points: numerators over a positive
// denominator.
struct HomogeneousPoint {
  std::vector<Integer> numerators;
  Integer denominator = 1;
};

// A point with rational coordinates as integers over one denominator, and back.
HomogeneousPoint homogeneous(const Point& point);
Point ordinary(const HomogeneousPoint& point);

// Divides by what numerators and denominator have in common.
HomogeneousPoint in_lowest_terms(HomogeneousPoint point);

// A point among the integer points. `point` is in the user's own coordinates.
HomogeneousPoint scaled(const ScaledPoints& points, const Point& point);

// Some of these points, in their scale. Requires: `those` are among the points.
ScaledPoints in_scale_of(const ScaledPoints& points, const PointSet& those);

// The barycentre of some of the points. Requires: vertices is not empty.
HomogeneousPoint barycentre(const ScaledPoints& points, const Simplex& vertices);

// On which side of the facets of simplices a point lies: the sign that most of a certificate is
// about. Book: Section 3.1 (Orient2D, Orient3D).

// Orientations in the plane and in space, of integer points and one rational point among them. The
// numbers in between keep their memory, so that millions of calls allocate nothing. After some
// calls, doubles are asked first: the points themselves, if all coordinates are doubles, or doubles
// that enclose them.
class Sidedness {
 public:
  // Requires: points of dimension 2 or 3, which outlive this.
  explicit Sidedness(const ScaledPoints& points) : points_(points) {}

  // The sign of det[v_i − v_d]. Requires: d+1 vertices.
  int orientation(std::span<const Vertex> simplex);

  // Likewise with vertex number `place` moved to q.
  int orientation_with(std::span<const Vertex> simplex, std::size_t place,
                       const HomogeneousPoint& q);

  // A place whose opposite facet has q strictly on its outer side; none if the closed simplex
  // contains q. `own` is the orientation of the simplex, not 0; place `first` is tried first.
  std::optional<std::size_t> separating_place(std::span<const Vertex> simplex, int own,
                                              const HomogeneousPoint& q, std::size_t first = 0);

 private:
  int sign_of_determinant();
  bool has_enclosed_points();
  Interval enclosed(Vertex v, std::size_t axis) const {
    return enclosed_[static_cast<std::size_t>(v) * points_.dimension + axis];
  }
  template <std::size_t kDimension>
  fast::SiteRow<kDimension> row_of_doubles(std::span<const Vertex> simplex) const;
  // With vertex number `place` moved to enclosed_moved_; 0: doubles do not tell.
  template <std::size_t kDimension>
  int certain_orientation_with(std::span<const Vertex> simplex, std::size_t place) const;
  void enclose(const HomogeneousPoint& q);
  int certain_sign_of_determinant() const;

  const ScaledPoints& points_;
  std::size_t calls_ = 0;
  std::vector<Interval> enclosed_;  // coordinates, once they are known
  std::vector<double> doubles_;     // the same, if all of them are doubles
  fast::Stages stages_;
  HomogeneousPoint moved_to_;  // the point that the next was made of
  std::array<Interval, 3> enclosed_moved_;
  std::array<std::array<Interval, 3>, 3> enclosed_rows_;
  std::array<std::array<Integer, 3>, 3> rows_;
  Integer minor_;
  Integer determinant_;
};

}  // namespace circumspect::certificate
