#include "oracle/report/wording.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace circumspect::report {

std::string simplices_noun(int dimension) {
  switch (dimension) {
    case 0:
      return "vertices";
    case 1:
      return "edges";
    case 2:
      return "triangles";
    case 3:
      return "tetrahedra";
    default:
      return "simplices";
  }
}

std::string joined(const Simplex& indices) { return fmt::format("{}", fmt::join(indices, " ")); }

std::string labels(const Mesh& mesh, const Simplex& simplex) {
  Simplex own;
  for (const Vertex v : simplex) own.push_back(mesh.label(v));
  return joined(own);
}

NamedCells named_cells(const Witness& witness, const Mesh& mesh) {
  NamedCells named;
  std::map<Vertex, Vertex> in_face;  // the index of each vertex, by the first simplex that has it
  for (std::size_t i = 0; i < witness.simplices.size(); ++i) {
    const Simplex& simplex = witness.simplices[i];
    const bool has_place = i < witness.places.size();
    named.simplices.push_back(
        mesh.listed(simplex, has_place ? std::optional(witness.places[i]) : std::nullopt));
    for (std::size_t j = 0; j < simplex.size(); ++j) {
      const Vertex own = named.simplices.back()[j];
      in_face.emplace(simplex[j], own);
      if (own != mesh.label(simplex[j])) named.merged.emplace(own, mesh.label(simplex[j]));
    }
  }
  if (!witness.face) return named;
  named.face = mesh.listed(*witness.face);
  for (std::size_t i = 0; i < named.face->size(); ++i) {
    const Vertex v = (*witness.face)[i];
    const auto found = in_face.find(v);
    Vertex& own = (*named.face)[i];
    if (found != in_face.end()) own = found->second;
    if (own != mesh.label(v)) named.merged.emplace(own, mesh.label(v));
  }
  return named;
}

std::string name(check::By by) { return by == check::By::kLemma ? "lemma" : "definition"; }

}  // namespace circumspect::report
