#include <utility>

#include "inputs/families.hpp"
#include "inputs/point_sets.hpp"
#include "inputs/round_sets.hpp"
#include "inputs/set_parts.hpp"

namespace circumspect::generators {
namespace {

// In dimensions from `first` to `last`.
struct Dimensions {
  std::size_t first = 1;
  std::size_t last = 16;

  bool operator()(std::size_t dimension) const { return first <= dimension && dimension <= last; }
};
constexpr Dimensions kAll = {1}, kPlane = {2}, kSpace = {3};

Family plain(std::string name, Dimensions exists_in, Sets sets, std::string about) {
  return {std::move(name), std::move(about), exists_in,
          [sets](Dice& dice, std::size_t dimension, Count count) {
            return PointsCase{sets(dice, dimension, count)};
          }};
}

std::vector<Family> generic_families() {
  return {
      plain("uniform", kAll, uniform_points,
            "uniform in [-1, 1]^d, in steps of 2^-30: generic (Book: Definition 4.2)"),
      plain("integers", kAll, integer_points,
            "integers from -20 to 20: generic, or by accident not (Book: Definition 4.2)"),
      plain("rationals", kAll, rational_points,
            "fractions with denominators up to 6 (Book: Definition 4.2)"),
      plain("dyadic", kAll, dyadic_points,
            "doubles of 53 bits and up to 60 binary orders of magnitude (Book: Section 2.9)"),
      plain("moment-curve", kPlane, moment_curve_points,
            "(t, t^2, ..., t^d): in space every pair is an edge (Book: Section 4.1, the bound)"),
      plain("skew-lines", kSpace, skew_line_points,
            "points of two skew lines: quadratically many simplices (Book: Section 4.1)"),
      plain("unrelated-denominators", kAll, unrelated_denominator_points,
            "fractions over coprime denominators of 900 bits; doubles only after rounding"),
  };
}

std::vector<Family> cospherical_families() {
  return {
      plain(
          "grid", kAll, grid_points,
          "part of {0, 1, 2}^d, or of a larger grid: cells that are not simplices (Book: Sections "
          "2.9 and 4.2)"),
      plain("cube", {1, 10}, cube_points,
            "corners, centre and facet centres of a cube, or of several (Book: Section 2.9)"),
      plain(
          "polytopes", kPlane, polytope_points,
          "vertices and centre of a regular polytope with integer coordinates (Book: Section 2.9)"),
      plain("circle", kPlane, circle_points,
            "rational points of a circle, in space of its axis too (Book: Section 2.9)"),
      plain("sphere", kPlane, sphere_points,
            "rational points of a sphere, cospherical before rounding (Book: Section 2.9)"),
      plain("symmetric-sphere", kPlane, integer_sphere_points,
            "images of a point under the symmetries of the cube (Book: Section 2.9)"),
      plain("pythagorean-sphere", {2, 6}, pythagorean_points,
            "integer points of a sphere, cospherical as doubles too (Book: Section 2.9)"),
      plain("cylinder", kSpace, cylinder_points,
            "rational points of a cylinder, in cocircular rings (Book: Section 2.9)"),
      plain("twisted-prism", {3, 3}, twisted_prism_points,
            "a ring and its turned image; Schoenhardt's corners (Book: Figure 4.10)"),
      plain("cubic-lattice", kAll, cubic_lattice_points,
            "Z^d near the origin: cells are cubes (Book: Section 4.2, Delaunay subdivision)"),
      plain("body-centred-lattice", kAll, body_centred_lattice_points,
            "Z^d and the centres of its cubes (Book: Section 4.2, Delaunay subdivision)"),
      plain("face-centred-lattice", kPlane, face_centred_lattice_points,
            "integers of even sum: octahedra and tetrahedra (Book: Section 4.2)"),
      plain("hexagonal-lattice", kPlane, hexagonal_lattice_points,
            "hexagonal layers, cocircular up to the rounding of sqrt(3) (Book: Section 4.2)"),
  };
}

std::vector<Family> flat_families() {
  return {
      plain("collinear", kPlane, line_points,
            "points of a line: the affine hull is 1-dimensional (Book: Section 4.1)"),
      plain("coplanar", kSpace, plane_points,
            "grids, circles and others in a plane of space (Book: Section 4.1)"),
      plain("lower-dimensional", kPlane, lower_dimensional_points,
            "points of a flat of any dimension less than d (Book: Section 4.1)"),
      plain("pyramid", kPlane, pyramid_points,
            "points of a hyperplane and up to two others: coplanar points on the hull"),
      plain(
          "box-boundary", kPlane, box_boundary_points,
          "points of the boundary of a cube, which need not be its corners: coplanar hull facets"),
      plain("slab", kPlane, slab_points,
            "integers with one coordinate times 2^-10 to 2^-50: almost coplanar, slivers"),
  };
}

std::vector<Family> scale_families() {
  return {
      plain("clusters", kAll, cluster_points, "three clusters, 2^-10 wide, up to 1000 apart"),
      plain("ulp-clusters", kAll, clustered_points,
            "three clusters of points that are at most two ulps from an integer point"),
      plain("nested-clusters", kAll, nested_points,
            "integers from -3 to 3 times 2^0 to 2^-50, each point its own"),
      plain("huge", kAll, huge_points, "small integers times 2^990 (1e298): squares overflow"),
      plain("tiny", kAll, tiny_points, "small integers times 2^-1000 (1e-301): squares underflow"),
      plain("mixed-exponents", kAll, extreme_points,
            "each coordinate with an exponent of its own, 2^-300 to 2^300"),
      plain("extreme-exponents", kAll, far_apart_exponent_points,
            "each coordinate with an exponent of its own, 2^-995 to 2^995 (1e-300 to 1e300)"),
  };
}

std::vector<Family> weighted_families() {
  return {
      {"small-weights", "integers, weights from -100 to 100 (Book: Section 5.2)", kPlane,
       integer_weights, true},
      {"parallel-lifted",
       "weights that lift all points to two parallel hyperplanes (Book: Section 5.2)", kPlane,
       lifted_to_parallel_planes, true},
      {"submerged", "half of the inner points submerged, no vertices (Book: Section 5.2)", kPlane,
       submerged_points, true},
  };
}

void append(std::vector<Family>& all, std::vector<Family> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

std::vector<Family> family_table() {
  std::vector<Family> all = generic_families();
  append(all, cospherical_families());
  append(all, flat_families());
  append(all, scale_families());
  append(all, {{"duplicates", "small integers, some points twice or more often (to be reported)",
                kAll, duplicate_points, false, true}});
  append(all, weighted_families());
  return all;
}

}  // namespace circumspect::generators
