// The simplices of a mesh that lie outside its domain.
#pragma once

#include <set>
#include <vector>

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// domain.outside, once for each simplex, however many of its facets or vertices show it.
class OutsideSimplices {
 public:
  explicit OutsideSimplices(const MeshedDomain& in) : in_(in) {}

  // `witness`: what shows it, without the simplex.
  void add(std::size_t simplex, Witness witness, Verdict& verdict);

  // Those from which no wall separates the ones that were added. Requires: matched facets, and the
  // pieces of all walls in order of their vertices.
  void add_those_beside(const std::vector<WallPiece>& pieces, Verdict& verdict);

 private:
  std::vector<std::vector<std::size_t>> neighbours(const std::vector<WallPiece>& pieces) const;

  const MeshedDomain& in_;
  std::set<std::size_t> found_;
};

}  // namespace circumspect::check
