// What an incremental insertion did, in numbers. Book: Sections 5.2, 5.4 and 5.5.
#pragma once

#include <cstdint>

namespace circumspect::delaunay {

// The simplices of the start count as created. "The total running time of the algorithm is
// proportional to the number of tetrahedra created plus the number of conflicts created" (proof of
// Theorem 5.4); walking has its steps in place of the conflicts.
struct Statistics {
  std::uint64_t solid_simplices_created = 0;
  std::uint64_t ghost_simplices_created = 0;
  std::uint64_t solid_simplices_deleted = 0;
  std::uint64_t ghost_simplices_deleted = 0;
  // How often the conflict graph filed a vertex with a simplex.
  std::uint64_t conflicts_created = 0;
  // How often a walk went from one simplex to the next.
  std::uint64_t walk_steps = 0;
  // Questions whether a vertex and a simplex are in conflict, whoever asked them.
  std::uint64_t conflict_tests = 0;

  bool operator==(const Statistics&) const = default;
};

}  // namespace circumspect::delaunay
