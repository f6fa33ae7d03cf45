#include "oracle/check/difference.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace circumspect::check {
namespace {

using WeightedPoint = std::pair<Point, Rational>;

std::map<WeightedPoint, Vertex> places(const PointSet& points) {
  std::map<WeightedPoint, Vertex> places;
  for (Vertex v = 0; points.names(v); ++v)
    places.emplace(WeightedPoint(points[v], points.weight(v)), v);
  return places;
}

// Every face of a simplex with fewer vertices, sorted, down to edges.
void add_faces(const Simplex& simplex, std::set<Simplex>& faces) {
  if (simplex.size() <= 2) return;
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const Simplex facet = facet_opposite(simplex, place);
    if (faces.insert(facet).second) add_faces(facet, faces);
  }
}

// The simplices, and the faces beside them that are faces of none: those are in the complex by
// themselves. A face that is listed twice, as from the two tetrahedra beside it, is one face.
std::vector<Simplex> cells(const Mesh& mesh) {
  std::vector<Simplex> cells = mesh.simplices;
  if (mesh.faces.empty()) return cells;
  std::set<Simplex> covered;
  for (const Simplex& simplex : mesh.simplices) {
    covered.insert(sorted(simplex));
    add_faces(sorted(simplex), covered);
  }
  std::vector<Simplex> largest_first = mesh.faces;
  std::stable_sort(largest_first.begin(), largest_first.end(),
                   [](const Simplex& a, const Simplex& b) { return a.size() > b.size(); });
  for (const Simplex& face : largest_first) {
    if (!covered.insert(sorted(face)).second) continue;
    add_faces(sorted(face), covered);
    cells.push_back(face);
  }
  return cells;
}

// The points of `mesh` that `others` lacks, and for each point its place there (−1: it has none).
std::vector<Vertex> matched(const PointSet& points, const std::map<WeightedPoint, Vertex>& others,
                            std::vector<Vertex>& only_here) {
  std::vector<Vertex> places;
  for (Vertex v = 0; points.names(v); ++v) {
    const auto other = others.find({points[v], points.weight(v)});
    places.push_back(other == others.end() ? -1 : other->second);
    if (other == others.end()) only_here.push_back(v);
  }
  return places;
}

// The cell under the numbers of the other mesh, sorted; empty if it matches nothing there.
Simplex renumbered(const Mesh& mesh, const Simplex& cell, const std::vector<Vertex>& places) {
  Simplex image;
  for (const Vertex v : cell) {
    if (!mesh.points.names(v) || places[static_cast<std::size_t>(v)] < 0) return {};
    image.push_back(places[static_cast<std::size_t>(v)]);
  }
  return sorted(image);
}

}  // namespace

Difference difference(const Mesh& a, const Mesh& b) {
  Difference result;
  const auto in_b = matched(a.points, places(b.points), result.points_only_in_a);
  matched(b.points, places(a.points), result.points_only_in_b);
  std::map<Simplex, std::vector<Simplex>> unmatched;  // those of b that nothing of a has met
  const std::vector<Simplex> cells_of_b = cells(b);
  for (auto cell = cells_of_b.rbegin(); cell != cells_of_b.rend(); ++cell) {
    unmatched[sorted(*cell)].push_back(*cell);
  }
  for (const Simplex& cell : cells(a)) {
    const auto match = unmatched.find(renumbered(a, cell, in_b));
    if (match == unmatched.end() || match->second.empty()) {
      result.simplices_only_in_a.push_back(cell);
    } else {
      match->second.pop_back();  // the first of b that is still there
    }
  }
  for (const Simplex& cell : cells_of_b) {
    auto& left = unmatched[sorted(cell)];
    if (left.empty() || left.back() != cell) continue;
    left.pop_back();
    result.simplices_only_in_b.push_back(cell);
  }
  return result;
}

}  // namespace circumspect::check
