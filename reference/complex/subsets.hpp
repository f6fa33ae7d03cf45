// All subsets of a given size, for what is done "for every k+1 points".
#pragma once

#include "reference/complex/simplex.hpp"

namespace circumspect {

// {0, 1, …, size − 1}.
Simplex first_subset(std::size_t size);

// Turns a subset of {0, …, n−1}, in ascending order, into the next one of the same size in
// lexicographic order; false after the last.
bool next_subset(Simplex& subset, std::size_t n);

}  // namespace circumspect
