// One property of one program on one set of points.
#pragma once

#include <string>

#include <circumspect/properties.hpp>

#include "inputs/points_case.hpp"

namespace circumspect::harness {

// What is broken, and how; an empty rule if nothing is.
struct Broken {
  std::string rule = {};
  std::string report = {};
};

// The properties beside the claim compare answers, and only where the first one is right: a wrong
// answer is the claim's business. `seed` is for the order in which the points are handed over.
// Requires: the numbers of `set` are doubles.
Broken broken_rule(const Triangulator& subject, Property property, const PropertyOptions& options,
                   const generators::PointsCase& set, std::uint64_t seed);

}  // namespace circumspect::harness
