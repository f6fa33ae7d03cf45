#include "oracle/judge/points/neighbors.hpp"

namespace circumspect::check {

namespace {

// `across` is the place of the true neighbour in the list of simplices, or −1.
void judge_link(const ExactMesh& mesh, const FacetUse& use, Vertex across, Verdict& verdict) {
  const Vertex expected = across < 0 ? -1 : across + mesh.neighbors->first_index;
  const Vertex listed = mesh.neighbors->rows[use.simplex][use.opposite];
  if (listed == expected) return;
  const Simplex* const simplex =
      across < 0 ? nullptr : &mesh.simplices[static_cast<std::size_t>(across)];
  add_wrong_neighbor(mesh, use, simplex, listed, expected, verdict);
}

}  // namespace

void judge_neighbors(const ExactMesh& mesh, const std::vector<FacetUse>& uses, Verdict& verdict) {
  for_each_facet(uses, [&](std::span<const FacetUse> group) {
    const bool shared = group.size() == 2;
    for (std::size_t i = 0; i < group.size(); ++i) {
      const Vertex across = shared ? static_cast<Vertex>(group[1 - i].simplex) : -1;
      judge_link(mesh, group[i], across, verdict);
    }
  });
}

void add_wrong_neighbor(const ExactMesh& mesh, const FacetUse& use, const Simplex* across,
                        Vertex listed, Vertex expected, Verdict& verdict) {
  Witness witness{.simplices = {mesh.simplices[use.simplex]},
                  .face = use.facet,
                  .values = {{"neighbour listed", Rational(static_cast<long>(listed))},
                             {"neighbour across the face", Rational(static_cast<long>(expected))}}};
  // Names the true neighbour by its vertices, so that the reader need not count simplices.
  if (across != nullptr) witness.simplices.push_back(*across);
  verdict.add(Rule::kWrongNeighbor, witness);
}

}  // namespace circumspect::check
