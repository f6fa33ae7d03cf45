// Does a piecewise linear complex have any triangulation without Steiner points, or any constrained
// Delaunay triangulation? The former is NP-complete in general, the latter NP-hard where the
// complex is not generic. Book: Section 4.5, Sections 5.6 and 5.9.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "kernel/piecewise_linear/regions.hpp"
#include "reference/existence/formula.hpp"
#include "reference/existence/refutation.hpp"

namespace circumspect::existence {

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
