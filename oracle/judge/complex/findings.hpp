// What is found out of a mesh alone, by definition and by lemma.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "oracle/judge/definition/complex.hpp"
#include "oracle/model/complex_demands.hpp"

namespace circumspect::check {

// Of the simplices that are compared; what nobody demands is not asked.
struct Findings {
  definition::SetApart apart = {};
  definition::ImproperPairs improper = {};
  std::vector<Simplex> open_facets = {};
  std::size_t boundary_facets = 0;  // how many these are
  std::size_t parts = 0;
  std::vector<std::size_t> part_of = {};   // the same number for two of one part
  std::vector<int> signs = {};             // if they have d + 1 vertices
  std::size_t positive = 0, negative = 0;  // how many of these are
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
// Of simplices without equal vertices that are not flat, the places of those that do not meet
// another as they should; nothing if it cannot tell. It may be empty.
using ImproperAmong =
    std::function<std::optional<std::vector<std::size_t>>(const std::vector<Simplex>&)>;
Findings findings_by_lemma(const definition::ListedComplex& listed, const ComplexDemands& demands,
                           const ImproperAmong& improper_among = {});

// Of a part of a mesh, for which it is known who is in a pair that does not meet as it should: only
// among simplices that `may_be_improper` says yes of, by their places in the list. What facets say,
// of the whole mesh, is left to others.
Findings findings_of_part(const definition::ListedComplex& part,
                          const std::vector<bool>& may_be_improper);

}  // namespace circumspect::check
