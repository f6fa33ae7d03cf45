// Does a piecewise linear complex have any triangulation without Steiner points, or any
// constrained Delaunay triangulation? A formula expresses the question, and CaDiCaL decides it.
// Book: Section 4.5, Sections 5.6 and 5.9.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "kernel/piecewise_linear/regions.hpp"
#include "reference/existence/refutation.hpp"

namespace circumspect::existence {

// ---- Solver ----
// Deciding a formula by the solver CaDiCaL (A. Biere).

struct Satisfied {
  std::vector<bool> assignment;  // of variable v in place v − 1
};
struct Refuted {
  Refutation refutation;
};
struct Undecided {};  // within the limit

// Satisfied, refuted, or undecided after so many conflicts (0: no limit). The answer is the
// solver's claim until `is_satisfied` or `replay` has confirmed it. Throws std::runtime_error if
// there is no memory for the solver's proof, or if the proof that it has written cannot be read.
std::variant<Satisfied, Refuted, Undecided> solve(const Formula& formula, int conflict_limit = 0);

// The name and the version of the solver.
std::string solver_version();

// ---- Existence ----
// Does a piecewise linear complex have any triangulation without Steiner points, or any constrained
// Delaunay triangulation? The former is NP-complete in general, the latter NP-hard where the
// complex is not generic. Book: Section 4.5, Sections 5.6 and 5.9.

// The tetrahedra of a triangulation, ascending, in lexicographic order.
struct Exists {
  std::vector<Simplex> tetrahedra;
};

// There is none: the formula over the candidates cannot be satisfied, and its refutation has been
// replayed.
struct Impossible {
  std::vector<Simplex> candidates;  // variable i + 1 is candidate i
  Formula formula;
  Refutation refutation;
};

// A limit was reached first.
struct Unknown {
  std::string limit;
};

using Existence = std::variant<Exists, Impossible, Unknown>;

struct Limits {
  std::size_t vertices = 60;  // of the complex; candidates grow with their fourth power
  int conflicts = 1'000'000;  // of the solver; 0: no limit
  // The limit on tetrahedra that respect the complex, because the clauses about them must fit into
  // memory.
  std::size_t candidates = 20'000;
};

// Is there any triangulation (Definition 4.4) of the polyhedra of the complex?
// Requires: the complex is in space; the regions are its own.
// Throws std::logic_error if the solver's claim is not confirmed, that is, its assignment does not
// satisfy all clauses or its refutation does not replay; and std::runtime_error as `solve`.
Existence any_triangulation(const PiecewiseLinearComplex& complex, const Regions& regions,
                            const Limits& limits = {});

// Is there any constrained Delaunay triangulation (Definition 4.7), in the unperturbed sense?
// Dangling polygons do not matter, because they always have planar CDTs. Requires and throws as
// above.
Existence any_cdt(const PiecewiseLinearComplex& complex, const Regions& regions,
                  const Limits& limits = {});

}  // namespace circumspect::existence
