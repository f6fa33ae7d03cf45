#include "oracle/judge/within/mesh_faces.hpp"

#include <algorithm>
#include <iterator>

#include "kernel/exact/each_once.hpp"

namespace circumspect::check {

MeshFaces::MeshFaces(const ExactMesh& mesh, const Cells& cells, const Reaches& reaches, Work& work)
    : triangles_(cells.complex().polygons.size()) {
  std::vector<std::vector<std::size_t>> polygons_at(mesh.points.size());
  for (std::size_t p = 0; p < triangles_.size(); ++p) {
    for (const Reaches::ToVertex& near : reaches.near({2, p})) {
      polygons_at[static_cast<std::size_t>(near.vertex)].push_back(p);
    }
  }
  std::vector<std::size_t> of_two, of_all;
  const auto intersect = [](const auto& a, const auto& b, std::vector<std::size_t>& both) {
    both.clear();
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  };
  const auto file_triangle = [&](Vertex a, Vertex b, Vertex c) {
    const auto at = [&](Vertex v) -> const std::vector<std::size_t>& {
      return polygons_at[static_cast<std::size_t>(v)];
    };
    intersect(at(a), at(b), of_two);
    if (of_two.empty()) return;
    intersect(of_two, at(c), of_all);
    work.add(of_all.size());
    for (const std::size_t p : of_all) triangles_[p].push_back({a, b, c});
  };
  const auto is_near = [&](Vertex v) { return !reaches.of(v).empty(); };
  const auto file = [&](const Simplex& listed) {
    // Most simplices have no edge that may be in an image.
    if (std::count_if(listed.begin(), listed.end(), is_near) < 2 || work.is_too_much()) return;
    const Simplex simplex = sorted(listed);
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if (!is_near(simplex[i])) continue;
      for (std::size_t j = i + 1; j < simplex.size(); ++j) {
        if (!is_near(simplex[j])) continue;
        edges_.emplace_back(simplex[i], simplex[j]);
        for (std::size_t k = j + 1; k < simplex.size() && !triangles_.empty(); ++k) {
          file_triangle(simplex[i], simplex[j], simplex[k]);
        }
      }
    }
  };
  for (const Simplex& simplex : mesh.simplices) file(simplex);
  for (const Simplex& face : mesh.faces) file(face);
  keep_each_once(edges_);
  const std::size_t one_way = edges_.size();
  for (std::size_t i = 0; i < one_way; ++i) edges_.emplace_back(edges_[i].second, edges_[i].first);
  std::sort(edges_.begin(), edges_.end());
  for (std::vector<Simplex>& triangles : triangles_) keep_each_once(triangles);
}

bool MeshFaces::has_edge(Vertex a, Vertex b) const {
  return std::binary_search(edges_.begin(), edges_.end(), std::pair{a, b});
}

std::span<const std::pair<Vertex, Vertex>> MeshFaces::edges_at(Vertex v) const {
  const auto first = std::lower_bound(edges_.begin(), edges_.end(), std::pair{v, Vertex{0}});
  const auto last = std::lower_bound(first, edges_.end(), std::pair{v + 1, Vertex{0}});
  return std::span(edges_).subspan(static_cast<std::size_t>(first - edges_.begin()),
                                   static_cast<std::size_t>(last - first));
}

}  // namespace circumspect::check
