#include "oracle/model/mesh.hpp"

#include <algorithm>

namespace circumspect {
namespace {

// Its indices in the order in which the vertices stand here.
Simplex in_order(const AsListed::Cell& cell, const Simplex& vertices) {
  if (cell.vertices == vertices) return cell.indices;
  Simplex indices;
  for (const Vertex v : vertices) {
    const auto found = std::find(cell.vertices.begin(), cell.vertices.end(), v);
    indices.push_back(cell.indices[static_cast<std::size_t>(found - cell.vertices.begin())]);
  }
  return indices;
}

}  // namespace

Simplex Mesh::listed(const Simplex& simplex, std::optional<std::size_t> place) const {
  if (place) {
    const auto found = as_listed.by_place.find(*place);
    if (found != as_listed.by_place.end()) return found->second;
  } else {
    const auto found = as_listed.by_set.find(sorted(simplex));
    if (found != as_listed.by_set.end()) return in_order(found->second, simplex);
  }
  Simplex own;
  for (const Vertex v : simplex) own.push_back(label(v));
  return own;
}

}  // namespace circumspect
