// Changes of an input after which a program has to be as right as before: metamorphic relations. All are exact.
#pragma once

#include <optional>
#include <string_view>

#include "inputs/cases.hpp"

namespace circumspect::generators {

enum class Relation {
  kOrder,        // the same points in another order
  kTranslation,  // moved by a power of two along the first axis
  kReflection,   // the first coordinate turned round
  kScaling,      // times a power of two, weights times its square
  kRepetition,   // every third point comes once more, in the end
};

std::string_view name(Relation relation);

// The changed input, which follows from the input alone. Nothing where there is none that is exact in doubles, or that
// is another input: an order of one point, a repeated vertex of a domain. Requires: doubles.
std::optional<PointsCase> image(Relation relation, const PointsCase& set);
std::optional<ComplexCase> image(Relation relation, const ComplexCase& whole);

}  // namespace circumspect::generators
