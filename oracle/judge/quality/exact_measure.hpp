// Measures of single simplices of a mesh, in rational numbers.
#pragma once

#include <optional>

#include "oracle/judge/quality/measures.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::quality {

// The dimension of the simplices of a mesh: one less than the most vertices that one has.
int dimension_of_simplices(const Mesh& mesh);

// What was measured: the extreme of its values, and the first place that has it.
struct Found {
  Rational value;
  Place place;
};

// None if the simplex is set apart: if it has another dimension, names no point somewhere, or is
// flat. Requires: the measure exists for the dimension.
std::optional<Found> measured(Measure measure, const Mesh& mesh, const Simplex& simplex,
                              int dimension);

// The same, of the corners of a simplex that is not set apart.
Found measured(Measure measure, const std::vector<Point>& corners);

// What shows it: the simplex, and the corner or the edge where it was measured.
Witness witness_of(Measure measure, const Found& found, const Simplex& simplex, std::size_t place);

}  // namespace circumspect::quality
