// The extremes of all measures of a mesh, and how its simplices are distributed, exactly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/judge/quality/exact_measure.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::quality {

// What the simplices of a mesh measure at least or at most.
struct Extreme {
  Measure measure;
  bool is_largest;  // else the least: of angles and edges the one that some simplex has anywhere
  Found found;
  std::size_t simplex;  // the first that measures it
};

// How many simplices measure how much: counts[i] of them at least bounds[i − 1] and less than
// bounds[i], as Requirement::bound has them; the first from below, the last without an end.
struct Histogram {
  Measure measure;
  std::vector<Rational> bounds;
  std::vector<std::size_t> counts;

  // "10deg", "1.5": a bound in words.
  std::string word(std::size_t bound) const;
};

struct Survey {
  int dimension = -1;         // of the simplices
  std::size_t measured = 0;   // simplices
  std::size_t set_apart = 0;  // exact_measure.hpp says which
  std::vector<Extreme> extremes = {};
  std::vector<Histogram> histograms = {};
};

// Nothing is measured of simplices of other dimensions than 1, 2 and 3. Requires: threads ≥ 1.
Survey survey(const Mesh& mesh, unsigned threads);

}  // namespace circumspect::quality
