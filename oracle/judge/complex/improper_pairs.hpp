// All pairs of simplices that do not meet as they should, by a tree of boxes.
#pragma once

#include "kernel/predicates/configuration.hpp"
#include "oracle/judge/definition/complex.hpp"

namespace circumspect::check {

// The answer of definition::improper_pairs. `points` are those of the list. Only pairs with one in
// `among` are looked at: places in apart.compared, ascending. It ends where 50,000
// pairs overlap: a list of simplices and points that do not belong together has billions of these.
definition::ImproperPairs improper_pairs(const Configuration& points,
                                         const definition::ListedComplex& listed,
                                         const definition::SetApart& apart,
                                         const std::vector<std::size_t>& among);

}  // namespace circumspect::check
