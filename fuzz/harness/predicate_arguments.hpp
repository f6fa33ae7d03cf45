// Arguments on which floating-point predicates go wrong.
#pragma once

#include <string_view>
#include <vector>

#include <circumspect/predicates.hpp>

#include "inputs/dice.hpp"

namespace circumspect::harness {

using generators::Dice;

struct ArgumentFamily {
  std::string_view name;
  std::vector<double> (*made)(const PredicateOptions& options, Dice& dice);
};

// In the order in which they take turns. What they make is within the limits of the options.
const std::vector<ArgumentFamily>& argument_families();

// Has every coordinate that is not 0 an exponent within the limits of the options?
bool is_within_limits(const PredicateOptions& options, const std::vector<double>& coordinates);

}  // namespace circumspect::harness
