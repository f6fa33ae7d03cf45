// What is found out of a mesh alone, by definition and by lemma.
#pragma once

#include <vector>

#include "oracle/judge/definition/complex.hpp"
#include "oracle/model/complex_demands.hpp"

namespace circumspect::check {

// Of the simplices that are compared; what nobody demands is not asked.
struct Findings {
  definition::SetApart apart = {};
  definition::ImproperPairs improper = {};
  std::vector<Simplex> open_facets = {};
  std::size_t parts = 0;
  std::vector<int> signs = {};             // if they have d + 1 vertices
  std::vector<Simplex> inconsistent = {};  // if they have fewer
  definition::NotManifold not_manifold = {};
};

// How many vertices a simplex is to have: as the largest of the list that is not larger than d + 1.
std::size_t size_of_simplices(const definition::ListedComplex& listed);

// What definition::set_apart says, in near-linear time. `points` are those of the list.
definition::SetApart sorted_apart(const definition::ListedComplex& listed,
                                  const Configuration& points, std::size_t size);

// Requires: `manifold` is demanded of at most four vertices each.
Findings findings_by_definition(const definition::ListedComplex& listed,
                                const ComplexDemands& demands);
Findings findings_by_lemma(const definition::ListedComplex& listed, const ComplexDemands& demands);

}  // namespace circumspect::check
