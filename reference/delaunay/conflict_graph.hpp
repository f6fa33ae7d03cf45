// The conflict graph, and the analysis of randomized incremental insertion. Book: Section 5.4.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/exact/number.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/point_location.hpp"

namespace circumspect::delaunay {

// ---- Conflict graph ----
// Point location by a conflict graph. Book: Section 5.4.

// For each uninserted vertex, one simplex in conflict with it, and for each simplex the vertices
// that chose it. A vertex inside the triangulation is filed with a solid simplex that contains it,
// a vertex outside with a ghost simplex whose outer halfspace contains it, one on the boundary with
// either. In a weighted set a vertex is filed with any simplex in conflict with it, and with none
// once it is submerged; it stays submerged, because insertions only lower the hull.
class ConflictGraph {
 public:
  // Files every uninserted vertex, by looking at all simplices of the triangulation. The graph
  // keeps references to the points, the triangulation and the statistics.
  ConflictGraph(const PointSet& points, const SimplexDictionary& triangulation,
                const std::vector<Vertex>& uninserted, Statistics& statistics);

  // The simplex that an uninserted vertex is filed with; nothing if it is submerged.
  std::optional<Simplex> conflict_of(Vertex w) const;

  // Refiles the vertices that were filed with simplices that the insertion deleted. To be called
  // after each insertion.
  //
  // A vertex w is filed where a search through the deleted simplices in conflict with it leads: in
  // a new simplex, or in a ghost beyond the cavity. Each simplex that the search visits is one
  // conflict less, so all searches together take time proportional to the conflicts created.
  //
  // The search finds the new simplex that contains w. Let w be in a deleted solid simplex and
  // follow the ray from the inserted vertex u through w, onwards from w, until it leaves the cavity
  // through a facet: that facet's new simplex contains w. A simplex that the ray meets at a point x
  // on the way was deleted, so its ball holds u, and the closed ball holds x; hence the open ball
  // holds w, which lies between. If w is outside and the insertion takes it inside, then every
  // ghost simplex in conflict with w has been deleted; these are connected, and the ray goes
  // through one of them. If w stays outside, the ghost simplices in conflict with it, old and new,
  // are connected too, and a new one shares a ridge with an old one. With weights, the last
  // argument applies to all simplices: w stays in conflict with some simplex until it is submerged.
  void update(const Insertion& insertion);

 private:
  void file(Vertex w, const Simplex& simplex);
  bool is_conflict(const Simplex& simplex, Vertex w);
  bool has_room(const Simplex& simplex, Vertex w);
  std::optional<Simplex> search(Vertex w, const class Cavity& cavity, std::size_t start);

  const PointSet& points_;
  const SimplexDictionary& triangulation_;
  Statistics& statistics_;
  // Simplices by their vertices ascending: two simplices of a triangulation never share all of
  // them.
  struct Hash {
    std::size_t operator()(const Simplex& ascending) const;
  };
  std::unordered_map<Simplex, std::vector<Vertex>, Hash> filed_with_;
  std::vector<Simplex> conflict_of_;  // by vertex; empty: none
};

// ---- Triggers and stoppers ----
// The analysis of randomized incremental insertion, by brute force on small sets. Book: Section 5.4
// (d = 3); here for any dimension k.

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
