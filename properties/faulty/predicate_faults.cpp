// Bowyer–Watson with predicates that are wrong.
#include "properties/faulty/fault.hpp"
#include "properties/faulty/plain_delaunay.hpp"

namespace circumspect::faulty {
namespace {

Fault deciding_with(std::string name, std::string about, const Mistakes& mistakes) {
  return {std::move(name), std::move(about), Kind::kPredicate, Claim::kDelaunay,
          [mistakes](const PointArray& points) { return plain_delaunay(points, mistakes); }};
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

}  // namespace circumspect::faulty
