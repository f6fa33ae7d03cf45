// Arguments on which floating-point predicates go wrong, with the exact signs.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <circumspect/predicates.hpp>

#include "fuzz/harness/cases.hpp"

namespace circumspect::harness {

// The signs with which floating-point predicates are compared.

// How many points a predicate takes.
std::size_t argument_count(PredicateKind kind, std::size_t dimension);

// The sign that predicates.hpp defines. Requires: finite coordinates of argument_count points.
int exact_sign(PredicateKind kind, std::size_t dimension, const std::vector<double>& coordinates);

struct ArgumentFamily {
  std::string_view name;
  std::vector<double> (*made)(const PredicateOptions& options, Dice& dice);
};

// The kinds in the order in which they take turns. Their arguments are within the limits of the
// options.
const std::vector<ArgumentFamily>& argument_families();

// Does every nonzero coordinate have an exponent within the limits of the options?
bool is_within_limits(const PredicateOptions& options, const std::vector<double>& coordinates);

}  // namespace circumspect::harness
