#include "oracle/judge/domain/outside_simplices.hpp"

#include <utility>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/simplex.hpp"

namespace circumspect::check {

void OutsideSimplices::add(std::size_t simplex, Witness witness, Verdict& verdict) {
  if (!found_.insert(simplex).second) return;
  witness.simplices = {in_.mesh.simplices[simplex]};
  verdict.add(Rule::kOutside, std::move(witness));
}

void OutsideSimplices::add_those_beside(const std::vector<WallPiece>& pieces, Verdict& verdict) {
  if (found_.empty()) return;
  const std::vector<std::vector<std::size_t>> beside = neighbours(pieces);
  std::vector<std::size_t> reached(found_.begin(), found_.end());
  std::set<std::size_t> others;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    for (const std::size_t other : beside[reached[next]]) {
      if (!found_.contains(other) && others.insert(other).second) reached.push_back(other);
    }
  }
  for (const std::size_t simplex : others) {
    const Simplex& corners = in_.mesh.simplices[simplex];
    add(simplex, {.point = barycentre(in_.mesh.points, corners)}, verdict);
  }
}

// Across facets that are in no wall.
std::vector<std::vector<std::size_t>> OutsideSimplices::neighbours(
    const std::vector<WallPiece>& pieces) const {
  std::vector<std::vector<std::size_t>> beside(in_.mesh.simplices.size());
  auto piece = pieces.begin();
  // Of a mesh that is known to be sound not all uses are at hand.
  std::vector<FacetUse> all;
  if (in_.known != nullptr) all = facet_uses(in_.mesh.simplices);
  for (const auto group : ByFacet(in_.known == nullptr ? in_.uses : all)) {
    while (piece != pieces.end() && piece->facet < group.front().facet) ++piece;
    const bool is_wall = piece != pieces.end() && piece->facet == group.front().facet;
    if (is_wall || group.size() != 2) continue;
    beside[group[0].simplex].push_back(group[1].simplex);
    beside[group[1].simplex].push_back(group[0].simplex);
  }
  return beside;
}

}  // namespace circumspect::check
