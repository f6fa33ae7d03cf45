// Simplices as tuples of vertices, and all subsets of a given size, for what is done "for every k+1
// points".
#pragma once

#include <vector>

#include "reference/kernel/predicates/configuration.hpp"

namespace circumspect {

// The vertices of a simplex, in the order somebody gave them. What a user hands in is meant as a
// set; where orientation matters, the order carries it.
using Simplex = std::vector<Vertex>;

// The same set of vertices in ascending order.
Simplex sorted(Simplex simplex);

// The facet opposite vertex number `place`: all other vertices, in their order.
Simplex facet_opposite(const Simplex& simplex, std::size_t place);

// The simplex with vertex number `place` replaced.
Simplex with_vertex_replaced(Simplex simplex, std::size_t place, Vertex vertex);

bool contains(const Simplex& simplex, Vertex vertex);
bool has_repeated_vertex(const Simplex& simplex);

// Is the permutation that sorts the vertices odd? Requires: no repeated vertex.
bool is_odd_permutation(const Simplex& simplex);

// {0, 1, …, size − 1}.
Simplex first_subset(std::size_t size);

// Turns a subset of {0, …, n−1}, in ascending order, into the next one of the same size in
// lexicographic order; false after the last.
bool next_subset(Simplex& subset, std::size_t n);

}  // namespace circumspect
