// The analysis of randomized incremental insertion, by brute force on small sets. Book: Section 5.4
// (d = 3); here for any dimension k.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/exact/number.hpp"
#include "reference/delaunay/dictionary.hpp"

namespace circumspect::delaunay {

// The triggers of a simplex are its vertices, its stoppers the vertices that its open circumball
// contains. "A tetrahedron is constructed if and only if all of its triggers precede all of its
// stoppers in the insertion order." A point set that is not generic is perturbed canonically, as in
// the algorithm (Exercise 3). Requires: the simplex has dimension k, not degenerate.
Simplex stoppers(const PointSet& points, const Simplex& simplex);

// f_0, f_1, …, f_{n−k−1}, f_j being the number of j-simplices: k-simplices with j stoppers. f_0 is
// the number of simplices of the Delaunay triangulation. Takes n^(k+2) predicates.
std::vector<std::uint64_t> numbers_of_j_simplices(const PointSet& points);

// n over m; 0 if m > n.
Integer binomial(std::uint64_t n, std::uint64_t m);

// The probability that a j-simplex is constructed, over all permutations: 1 / C(j + k + 1, k + 1),
// which is less than (k+1)! / j^(k+1). Book: Proposition 5.2.
Rational probability_in_random_order(int dimension, std::uint64_t j);

// The upper bound of that probability if the order is a BRIO: (2^(k+1) (k+1)! + 1) / j^(k+1), or 1
// if that is smaller. Book: Proposition 5.3.
Rational bound_in_brio(int dimension, std::uint64_t j);

// Theorem 5.4: Σ q_j f_j and Σ j q_j f_j, the expected numbers of simplices and of conflicts
// created. `probability` is one of the two functions above; the second gives upper bounds.
struct Expectation {
  Rational simplices = 0;
  Rational conflicts = 0;
};
Expectation expectation(int dimension, const std::vector<std::uint64_t>& numbers,
                        Rational (*probability)(int dimension, std::uint64_t j));

}  // namespace circumspect::delaunay
