#include "oracle/judge/domain/coverage.hpp"

#include <algorithm>
#include <array>

#include "kernel/complex/by_facet.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/domain/loose_facets.hpp"
#include "oracle/judge/domain/outside_simplices.hpp"
#include "oracle/judge/points/triangulation.hpp"

namespace circumspect::check {

namespace {

// The witness that nothing covers the side of a piece: which side, by a sign of orientation.
Witness bare_side(const WallPiece& piece, std::size_t side) {
  return {.face = piece.facet,
          .values = {{"orientation of the bare side", Rational(side == 1 ? 1 : -1)}}};
}

// The simplices on the two sides of a facet.
std::array<std::size_t, 2> simplices_at(const MeshedDomain& in, std::span<const FacetUse> group) {
  std::array<std::size_t, 2> simplices = {kNowhere, kNowhere};
  for (const FacetUse& use : group) {
    const Vertex apex = in.mesh.simplices[use.simplex][use.opposite];
    const int side = side_of_facet(in.mesh.points.configuration(), use.facet, apex);
    simplices[side_index(side)] = use.simplex;
  }
  return simplices;
}

void judge_piece(const MeshedDomain& in, const WallPiece& piece,
                 const std::array<std::size_t, 2>& simplices, OutsideSimplices& outside,
                 Verdict& verdict) {
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const bool inside = in.is_inside(piece.regions[side]);
    const bool covered = simplices[side] != kNowhere;
    if (inside && !covered) verdict.add(Rule::kUncovered, bare_side(piece, side));
    if (!inside && covered) outside.add(simplices[side], {.face = piece.facet}, verdict);
  }
}

}  // namespace

void judge_coverage(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                    Verdict& verdict) {
  OutsideSimplices outside(in);
  std::vector<FacetUse> loose;
  auto piece = pieces.begin();
  for (const auto group : ByFacet(in.uses)) {
    const Simplex& facet = group.front().facet;
    for (; piece != pieces.end() && piece->facet < facet; ++piece) {
      judge_piece(in, *piece, {kNowhere, kNowhere}, outside, verdict);
    }
    if (piece != pieces.end() && piece->facet == facet) {
      judge_piece(in, *piece, simplices_at(in, group), outside, verdict);
      ++piece;
    } else if (group.size() == 1) {
      loose.push_back(group.front());
    }
  }
  for (; piece != pieces.end(); ++piece) {
    judge_piece(in, *piece, {kNowhere, kNowhere}, outside, verdict);
  }
  judge_loose_facets(in, loose, outside, verdict);
  outside.add_those_beside(pieces, verdict);
}

}  // namespace circumspect::check
