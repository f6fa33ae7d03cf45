// What floating-point predicates are held against.
#pragma once

#include <cstddef>
#include <vector>

#include <circumspect/predicates.hpp>

namespace circumspect::harness {

// How many points a predicate takes.
std::size_t argument_count(PredicateKind kind, std::size_t dimension);

// The sign that predicates.hpp defines. Requires: finite coordinates of argument_count points.
int exact_sign(PredicateKind kind, std::size_t dimension, const std::vector<double>& coordinates);

}  // namespace circumspect::harness
