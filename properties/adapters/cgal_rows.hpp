// From CGAL's triangulations of points in space to rows of indices.
#pragma once

#include <algorithm>
#include <utility>

#include "properties/adapters/adapters.hpp"

namespace circumspect::adapters {

// Requires: info() of a vertex is the index of its point.
template <class Triangulation>
SimplexArray rows_of(const Triangulation& mesh) {
  SimplexArray rows;
  const auto add = [&](const auto& cell, std::initializer_list<int> places) {
    rows.emplace_back();
    for (const int place : places) rows.back().push_back(cell->vertex(place)->info());
  };
  switch (mesh.dimension()) {
    case 3:
      for (const auto& cell : mesh.finite_cell_handles()) add(cell, {0, 1, 2, 3});
      break;
    case 2:
      for (const auto& facet : mesh.finite_facets()) add(facet.first, {0, 1, 2});
      break;
    case 1:
      for (const auto& edge : mesh.finite_edges()) add(edge.first, {edge.second, edge.third});
      break;
    case 0:
      rows.push_back({mesh.finite_vertices_begin()->info()});
      break;
    default:
      break;
  }
  return rows;
}

}  // namespace circumspect::adapters
