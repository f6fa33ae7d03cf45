// Bowyer–Watson with predicates that are wrong.
#include <algorithm>
#include <cmath>
#include <functional>

#include "properties/faulty/fault.hpp"
#include "properties/faulty/plain_delaunay.hpp"

namespace circumspect::faulty {

namespace {

Fault deciding_with(std::string name, std::string about, const Mistakes& mistakes) {
  return {std::move(name), std::move(about), Kind::kPredicate, Claim::kDelaunay,
          [mistakes](const PointArray& points) { return plain_delaunay(points, mistakes); }};
}

bool is_a_short_integer(double x) { return x == std::trunc(x) && std::abs(x) < 0x1p31; }

SimplexArray in_wrapping_integers(const PointArray& points) {
  const auto& all = points.coordinates;
  if (!std::all_of(all.begin(), all.end(), is_a_short_integer)) return right_answer(points);
  return plain_delaunay(points, {.arithmetic = {.numbers = Numbers::kWrapping}});
}

}  // namespace

std::vector<Fault> predicate_faults() {
  return {
      deciding_with(
          "double-predicates",
          "Determinants of both tests in doubles, believed whatever their size: the first version "
          "of every mesher.",
          {.arithmetic = {.numbers = Numbers::kDouble}}),
      deciding_with(
          "float-predicates",
          "The same in single precision: coordinates that come from a graphics card or a `.obj` "
          "reader.",
          {.arithmetic = {.numbers = Numbers::kFloat}}),
      deciding_with("long-double-predicates",
                    "The same in the 80 bits of an x87: \"a few more bits will do\".",
                    {.arithmetic = {.numbers = Numbers::kLongDouble}}),
      deciding_with(
          "in-ball-tolerance",
          "A point is in a ball only if the determinant exceeds 1e-10, whatever the size of the "
          "coordinates: an epsilon that made one example work.",
          {.arithmetic = {.in_ball_tolerance = 1e-10}}),
      deciding_with(
          "orientation-tolerance",
          "Volumes of at most 1e-10 count as flat, so that points near the plane of a hull facet "
          "count as in it.",
          {.arithmetic = {.orientation_tolerance = 1e-10}}),
      deciding_with(
          "filter-for-unit-coordinates",
          "Exact arithmetic behind a filter whose error bound, 1e-14, was derived for coordinates "
          "between 0 and 1 and is used for all.",
          {.arithmetic = {.numbers = Numbers::kDouble, .trusted_beyond = 1e-14}}),
      deciding_with(
          "circumcentre-and-radius",
          "Compares a distance from a computed circumcentre with a computed radius, instead of the "
          "sign of a determinant: textbook formulas, cached circumballs.",
          {.arithmetic = {.by_circumcentre = true}}),
      deciding_with(
          "circumballs-in-floats",
          "Circumcentre and radius are computed in doubles and stored in single precision: half "
          "the memory, on graphics cards a habit.",
          {.arithmetic = {.by_circumcentre = true, .circumballs_in_floats = true}}),
      deciding_with(
          "heights-from-the-origin",
          "|p|² is computed once a point, in doubles, and the heights are subtracted later: far "
          "from the origin nothing is left of the difference.",
          {.arithmetic = {.numbers = Numbers::kDouble, .heights_from_the_origin = true}}),
      {"determinants-of-64-bits",
       "Integer coordinates, and determinants in integers of 64 bits, which wrap round: exact "
       "arithmetic, as long as the coordinates are short.",
       Kind::kPredicate, Claim::kDelaunay, in_wrapping_integers},
      deciding_with(
          "height-forgets-an-axis",
          "The lifted height |p|² without its last term: an in-circle test extended by hand to "
          "in-sphere.",
          {.arithmetic = {.numbers = Numbers::kDouble, .forgets_last_axis = true}}),
      deciding_with(
          "wrong-sign-on-a-tie",
          "A point on a circumsphere counts as inside (>= for >): the new simplices of cospherical "
          "points are flat or overlap, for the cavity is not star-shaped.",
          {.tie = Tie::kYes}),
      deciding_with(
          "tie-by-local-order",
          "A cospherical tie is broken by the order in which each simplex happens to list its "
          "vertices: a symbolic perturbation that is not the same in all cells.",
          {.tie = Tie::kByVertexOrder}),
  };
}

// Weighted Delaunay triangulations with the weights misread. Book: Section 5.2.

namespace {

Fault weighing_fault(std::string name, std::string about, Triangulator triangulate) {
  return {std::move(name), std::move(about), Kind::kImplementation, Claim::kWeightedDelaunay,
          std::move(triangulate)};
}

Fault reading(std::string name, std::string about, const std::function<double(double)>& read) {
  return weighing_fault(std::move(name), std::move(about), [read](const PointArray& points) {
    PointArray misread = points;
    for (double& weight : misread.weights) {
      const double now = read(weight);
      if (std::isfinite(now)) weight = now;
    }
    return right_answer(misread);
  });
}

}  // namespace

std::vector<Fault> weight_faults() {
  return {
      reading("weights-ignored", "The weights are read and never used.",
              [](double) { return 0.0; }),
      reading("weight-sign-swapped", "The height is |p|² + w for |p|² − w.",
              [](double weight) { return -weight; }),
      reading("weights-squared", "Squared radii are taken for radii, and squared once more.",
              [](double weight) { return weight * weight; }),
      reading("weights-as-radii", "Square roots of the weights are used: the opposite mix-up.",
              [](double weight) { return std::sqrt(std::abs(weight)); }),
      reading("weights-in-floats", "The weights are stored in single precision, the points not.",
              [](double weight) { return static_cast<double>(static_cast<float>(weight)); }),
      weighing_fault("weights-one-row-late",
                     "Each point is given the weight of the one before it: a header was read as "
                     "the first row.",
                     [](const PointArray& points) {
                       PointArray late = points;
                       if (!late.weights.empty()) {
                         late.weights.pop_back();
                         late.weights.insert(late.weights.begin(), 0.0);
                       }
                       return right_answer(late);
                     }),
      weighing_fault(
          "inserts-submerged-points",
          "A point that conflicts with nothing, because it is submerged, is inserted into the "
          "simplex around it all the same: unweighted code with a power test.",
          [](const PointArray& points) {
            return plain_delaunay(points, {.keeps_submerged_points = true});
          }),
      weighing_fault(
          "never-submerges-a-vertex",
          "A vertex that a new point submerges keeps a simplex: in unweighted code vertices never "
          "vanish.",
          [](const PointArray& points) {
            return plain_delaunay(points, {.never_removes_vertices = true});
          }),
  };
}

}  // namespace circumspect::faulty
