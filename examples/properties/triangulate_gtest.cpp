// The same properties for GoogleTest, and one mesh.
#include <circumspect/properties.hpp>
#include <gtest/gtest.h>

#include "../triangulate.hpp"

CIRCUMSPECT_DELAUNAY_TESTS(Triangulate, circumspect::from_arrays<2>(example::triangulate),
                           {
                               .dimension = 2,
                               .min_points = 3,
                               .flat_sets = false,
                               .families = {"integers", "grid"},
                           })

TEST(Triangulate, Square) {
  const circumspect::PointArray square{2, {0, 0, 1, 0, 1, 1, 0, 1}};
  circumspect::assert_holds("delaunay", square,
                            circumspect::from_arrays<2>(example::triangulate)(square));
}
