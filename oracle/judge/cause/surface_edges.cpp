// The edges of triangles, and what is open.
#include "oracle/judge/cause/surface_edges.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

#include "oracle/judge/cause/bare_facets.hpp"

namespace circumspect::check {

std::vector<EdgeUse> edge_uses(const Mesh& mesh) {
  std::vector<EdgeUse> uses;
  mesh.simplices.visit([&]<class Lists>(const Lists& lists) {
    if constexpr (!std::is_same_v<Lists, std::vector<Simplex>>) {
      for (std::size_t i = 0; lists.columns() == 3 && i < lists.rows(); ++i) {
        const auto row = lists.row(i);
        const bool is_triangle = row[0] != row[1] && row[1] != row[2] && row[2] != row[0];
        if (!is_triangle || !name_points(mesh, row)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          const auto [a, b] = std::pair<Vertex, Vertex>(row[k], row[(k + 1) % 3]);
          uses.push_back({std::min(a, b), std::max(a, b), a < b, i});
        }
      }
    }
  });
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return uses;
}

std::vector<OpenEdge> open_edges(const Mesh& mesh) {
  std::vector<OpenEdge> open;
  for_each_edge(edge_uses(mesh), [&](std::span<const EdgeUse> uses) {
    if (uses.size() != 1) return;
    const auto& [low, high, goes_up, triangle] = uses.front();
    open.push_back(goes_up ? OpenEdge{low, high} : OpenEdge{high, low});
  });
  return open;
}

std::optional<std::vector<std::vector<Vertex>>> loops_of(const std::vector<OpenEdge>& edges) {
  // The neighbours of each vertex, that from which its triangle comes first.
  std::map<Vertex, std::vector<Vertex>> beside;
  for (const auto& [from, to] : edges) {
    beside[from].push_back(to);
    beside[to].insert(beside[to].begin(), from);
  }
  std::vector<std::vector<Vertex>> loops;
  std::set<Vertex> seen;
  for (const auto& [first, neighbours] : beside) {
    if (neighbours.size() != 2) return std::nullopt;
    if (seen.contains(first)) continue;
    std::vector<Vertex>& loop = loops.emplace_back();
    for (Vertex v = first, next = neighbours[0]; seen.insert(v).second;) {
      loop.push_back(v);
      const auto& around = beside.at(next);
      if (around.size() != 2) return std::nullopt;
      const Vertex after = around[0] == v ? around[1] : around[0];
      v = std::exchange(next, after);
    }
  }
  return loops;
}

}  // namespace circumspect::check
