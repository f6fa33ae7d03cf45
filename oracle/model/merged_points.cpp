#include "oracle/model/merged_points.hpp"

#include <numeric>
#include <utility>

namespace circumspect {
namespace {

// For each point the one that stands for it: itself, or an equal one.
std::vector<Vertex> representatives(const std::vector<Rational>& weights,
                                    const std::vector<Duplicate>& repeated, std::size_t points) {
  std::vector<Vertex> first(points);
  std::iota(first.begin(), first.end(), Vertex{0});
  for (const Duplicate& duplicate : repeated) {
    first[static_cast<std::size_t>(duplicate.again)] = duplicate.kept;
  }
  if (weights.empty()) return first;
  std::vector<Vertex> heaviest = first;  // of the points that are equal to a first one
  for (std::size_t v = 0; v < points; ++v) {
    Vertex& best = heaviest[static_cast<std::size_t>(first[v])];
    if (weights[static_cast<std::size_t>(best)] < weights[v]) best = static_cast<Vertex>(v);
  }
  for (Vertex& v : first) v = heaviest[static_cast<std::size_t>(v)];
  return first;
}

// Names what is left, and keeps what was listed by other names.
class Renaming {
 public:
  Renaming(Mesh& mesh, std::vector<Vertex> representative_of, std::vector<Vertex> place_of)
      : mesh_(mesh),
        representative_of_(std::move(representative_of)),
        place_of_(std::move(place_of)) {}

  std::vector<Simplex> renamed(std::vector<Simplex> cells, bool are_simplices) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Simplex listed = cells[i];
      if (!rename(cells[i])) continue;
      Simplex indices;
      for (const Vertex v : listed) indices.push_back(index_of_place(v, mesh_.first_index));
      if (are_simplices) mesh_.as_listed.by_place.emplace(i, indices);
      mesh_.as_listed.by_set.emplace(sorted(cells[i]),
                                     AsListed::Cell{cells[i], std::move(indices)});
    }
    return cells;
  }

 private:
  // Is a vertex called otherwise now?
  bool rename(Simplex& cell) const {
    bool changes = false;
    for (Vertex& v : cell) {
      if (v < 0 || v >= static_cast<Vertex>(place_of_.size())) continue;
      const auto place = static_cast<std::size_t>(v);
      changes |= representative_of_[place] != v;
      v = place_of_[place];
    }
    return changes;
  }

  Mesh& mesh_;
  std::vector<Vertex> representative_of_;
  std::vector<Vertex> place_of_;
};

}  // namespace

Mesh mesh_of_merged(std::vector<Point> points, std::vector<Rational> weights,
                    const std::vector<Duplicate>& repeated, Vertex first_index,
                    std::vector<Simplex> simplices, std::vector<Simplex> faces) {
  if (repeated.empty()) {
    return {PointSet(std::move(points), std::move(weights)),
            std::move(simplices),
            {},
            first_index,
            {},
            std::move(faces)};
  }
  std::vector<Vertex> representative_of = representatives(weights, repeated, points.size());
  std::vector<bool> repeats(points.size(), false);
  for (const Duplicate& duplicate : repeated) {
    repeats[static_cast<std::size_t>(duplicate.again)] = true;
  }
  // Each stands where the first of those equal to it stood.
  std::vector<Point> distinct;
  std::vector<Rational> own_weights;
  std::vector<Vertex> labels;
  std::vector<Vertex> place_of(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (repeats[v]) continue;
    const Vertex left = representative_of[v];
    place_of[v] = static_cast<Vertex>(distinct.size());
    distinct.push_back(std::move(points[v]));
    if (!weights.empty()) own_weights.push_back(std::move(weights[static_cast<std::size_t>(left)]));
    labels.push_back(index_of_place(left, first_index));
  }
  for (const Duplicate& duplicate : repeated) {
    place_of[static_cast<std::size_t>(duplicate.again)] =
        place_of[static_cast<std::size_t>(duplicate.kept)];
  }
  Mesh mesh{
      PointSet(std::move(distinct), std::move(own_weights)), {}, std::move(labels), first_index};
  Renaming renaming(mesh, std::move(representative_of), std::move(place_of));
  mesh.simplices = renaming.renamed(std::move(simplices), true);
  mesh.faces = renaming.renamed(std::move(faces), false);
  return mesh;
}

}  // namespace circumspect
