// A property of RapidCheck's, on points of two families, which shrink.
#include <circumspect/properties.hpp>
#include <circumspect/rapidcheck.hpp>

#include "../triangulate.hpp"

int main() {
  const auto triangulate = circumspect::from_arrays<2>(example::triangulate);
  return rc::check(
             "triangulate",
             [&] {
               const auto points = *circumspect::points_of_families(2, 12, {"integers", "grid"});
               RC_PRE(!circumspect::are_flat(points));
               circumspect::assert_holds("delaunay", points, triangulate(points));
             })
             ? 0
             : 1;
}
