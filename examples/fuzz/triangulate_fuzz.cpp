// A libFuzzer target that finds wrong triangulations, not only crashes. This program rounds, and
// the fuzzer finds points on which that matters within seconds.
#include <circumspect/fuzz.hpp>
#include <circumspect/properties.hpp>

#include "../triangulate.hpp"

CIRCUMSPECT_FUZZ(circumspect::from_arrays<2>(example::triangulate),
                 {.dimension = 2, .min_points = 3, .flat_sets = false})
