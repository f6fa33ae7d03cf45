// Arguments on which floating-point predicates go wrong, with the exact signs.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <circumspect/predicates.hpp>

#include "fuzz/harness/cases.hpp"

namespace circumspect::harness {

// ---- Exact signs ----
// What floating-point predicates are held against.

// How many points a predicate takes.
std::size_t argument_count(PredicateKind kind, std::size_t dimension);

// The sign that predicates.hpp defines. Requires: finite coordinates of argument_count points.
int exact_sign(PredicateKind kind, std::size_t dimension, const std::vector<double>& coordinates);

// ---- Predicate arguments ----

struct ArgumentFamily {
  std::string_view name;
  std::vector<double> (*made)(const PredicateOptions& options, Dice& dice);
};

// In the order in which they take turns. What they make is within the limits of the options.
const std::vector<ArgumentFamily>& argument_families();

// Has every coordinate that is not 0 an exponent within the limits of the options?
bool is_within_limits(const PredicateOptions& options, const std::vector<double>& coordinates);

}  // namespace circumspect::harness
