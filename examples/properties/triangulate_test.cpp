// Four properties of a Delaunay triangulation, on a thousand inputs each.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "../triangulate.hpp"

#include <circumspect/properties.hpp>
#include <doctest/doctest.h>

// The program computes in doubles, so it is right where nothing is rounded: on small integers. To
// see it fail, and on how few points, remove the line `.families`.
CIRCUMSPECT_DELAUNAY_PROPERTIES("triangulate", circumspect::from_arrays<2>(example::triangulate),
                                {
                                    .dimension = 2,
                                    .min_points = 3,
                                    .flat_sets = false,
                                    .families = {"integers", "grid"},
                                })
