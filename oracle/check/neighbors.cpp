#include "oracle/check/neighbors.hpp"

#include "reference/complex/facets.hpp"

namespace circumspect::check {
namespace {

void judge_link(const Mesh& mesh, const FacetUse& use, Vertex across, Verdict& verdict) {
  const Vertex listed = (*mesh.neighbors)[use.simplex][use.opposite];
  if (listed == across) return;
  Witness witness{.simplices = {mesh.simplices[use.simplex]}, .face = use.facet};
  // A neighbour is named by its vertices, so that nobody has to count simplices.
  const auto show = [&](const std::string& what, Vertex simplex) {
    const bool exists = simplex >= 0 && simplex < static_cast<Vertex>(mesh.simplices.size());
    if (exists) witness.simplices.push_back(mesh.simplices[static_cast<std::size_t>(simplex)]);
    witness.values.push_back(
        {what, Rational(static_cast<long>(simplex < 0 ? simplex : simplex + mesh.first_index))});
  };
  show("neighbour listed", listed);
  show("neighbour across the face", across);
  verdict.add(Rule::kWrongNeighbor, witness);
}

}  // namespace

void judge_neighbors(const Mesh& mesh, Verdict& verdict) {
  for_each_facet(facet_uses(mesh.simplices), [&](std::span<const FacetUse> group) {
    const bool shared = group.size() == 2;
    for (std::size_t i = 0; i < group.size(); ++i) {
      const Vertex across = shared ? static_cast<Vertex>(group[1 - i].simplex) : -1;
      judge_link(mesh, group[i], across, verdict);
    }
  });
}

}  // namespace circumspect::check
