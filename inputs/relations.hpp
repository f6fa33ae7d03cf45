// Changes of an input after which a program has to be as right as before: metamorphic relations.
// All are exact.
#pragma once

#include <optional>
#include <string_view>

#include "inputs/cases.hpp"

namespace circumspect::generators {

enum class Relation {
  kOrder,        // the same points in another order
  kTranslation,  // moved by a power of two along the first axis
  kReflection,   // the first coordinate with the opposite sign
  kScaling,      // times a power of two, weights times its square
  kRepetition,   // every third point is repeated at the end
};

std::string_view name(Relation relation);

// The changed input, which depends only on the input. Nothing if there is none that is exact in
// doubles, or none that differs from the input, such as an order of one point or a repeated vertex
// of a domain. Requires: doubles.
std::optional<PointsCase> image(Relation relation, const PointsCase& set);
std::optional<ComplexCase> image(Relation relation, const ComplexCase& whole);

}  // namespace circumspect::generators
