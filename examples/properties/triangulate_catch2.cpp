// The same properties for Catch2.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#include <circumspect/properties.hpp>

#include "../triangulate.hpp"

CIRCUMSPECT_DELAUNAY_PROPERTIES("triangulate", circumspect::from_arrays<2>(example::triangulate),
                                {
                                    .dimension = 2,
                                    .min_points = 3,
                                    .flat_sets = false,
                                    .families = {"integers", "grid"},
                                })
