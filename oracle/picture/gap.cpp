#include "oracle/picture/gap.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace circumspect::picture {
namespace {

// In the plane: is the way from b to c to the left (1) or to the right (-1) of that from a to b?
int turn(const Point& a, const Point& b, const Point& c) {
  const Point along = b - a;
  return sign(inner_product({-along[1], along[0]}, c - b));
}

bool is_ahead(const Point& a, const Point& b, const Point& c) {
  return turn(a, b, c) != 0 || sign(inner_product(b - a, c - b)) > 0;
}

// On which side of the line through two points the others are.
int side_of_others(const Mesh& mesh, const Point& a, const Point& b) {
  for (Vertex v = 0; mesh.names(v); ++v) {
    if (const int side = turn(a, b, mesh.point(v)); side != 0) return side;
  }
  return 0;
}

// Gift wrapping, which goes to the point that has all others on the inner side, the nearest first.
Simplex gap_in_plane(const Mesh& mesh, Vertex before, Vertex from,
                     const std::vector<Simplex>& bare) {
  const int inside = side_of_others(mesh, mesh.point(before), mesh.point(from));
  Point behind = mesh.point(before);
  Simplex gap = {from};
  while (inside != 0 && gap.size() <= mesh.points()) {
    const Point at = mesh.point(gap.back());
    std::optional<Vertex> next;
    for (Vertex v = 0; mesh.names(v); ++v) {
      const Point point = mesh.point(v);
      if (point == at || !is_ahead(behind, at, point)) continue;
      const int side = next ? turn(at, mesh.point(*next), point) * inside : -1;
      const bool is_nearer =
          side == 0 && squared_distance(at, point) < squared_distance(at, mesh.point(*next));
      if (side < 0 || is_nearer) next = v;
    }
    if (!next) break;
    gap.push_back(*next);
    if (std::find(bare.begin(), bare.end(), Simplex{*next}) != bare.end()) return gap;
    behind = at;
  }
  return {};
}

Simplex gap_in_space(const Simplex& ridge, const std::vector<Simplex>& bare) {
  std::multimap<Vertex, Vertex> along;
  for (const Simplex& edge : bare) {
    if (sorted(edge) == sorted(ridge)) continue;
    along.emplace(edge[0], edge[1]);
    along.emplace(edge[1], edge[0]);
  }
  const auto remove = [&along](Vertex a, Vertex b) {
    const auto [first, last] = along.equal_range(a);
    along.erase(std::find_if(first, last, [b](const auto& way) { return way.second == b; }));
  };
  Simplex gap = ridge;
  while (gap.back() != gap.front()) {
    const auto way = along.find(gap.back());
    if (way == along.end()) return {};
    const auto [from, to] = *way;
    remove(from, to);
    remove(to, from);
    gap.push_back(to);
  }
  gap.pop_back();
  return gap;
}

}  // namespace

Simplex gap_at(const Mesh& mesh, const Simplex& facet, const Simplex& ridge,
               const std::vector<Simplex>& bare) {
  if (mesh.dimension() == 3) return gap_in_space(ridge, bare);
  return gap_in_plane(mesh, facet[facet[0] == ridge[0] ? 1 : 0], ridge[0], bare);
}

}  // namespace circumspect::picture
