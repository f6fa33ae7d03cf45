#include "oracle/model/equal_points.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace circumspect {
namespace {

// The points so that equal ones follow each other, the first of them first.
template <class Value>
std::vector<std::size_t> in_order(const Rows<Value>& rows) {
  std::vector<std::size_t> order(rows.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&rows](std::size_t a, std::size_t b) {
    const auto of_a = rows.row(a);
    const auto of_b = rows.row(b);
    for (std::size_t axis = 0; axis < of_a.size(); ++axis) {
      if (of_a[axis] != of_b[axis]) return of_a[axis] < of_b[axis];
    }
    return a < b;
  });
  return order;
}

template <class Value>
std::vector<Duplicate> equal_rows(const Rows<Value>& rows) {
  const std::vector<std::size_t> order = in_order(rows);
  const auto are_equal = [&rows](std::size_t a, std::size_t b) {
    return std::equal(rows.row(a).begin(), rows.row(a).end(), rows.row(b).begin());
  };
  std::vector<Duplicate> found;
  for (std::size_t i = 0; i < order.size();) {
    std::size_t j = i + 1;
    for (; j < order.size() && are_equal(order[i], order[j]); ++j) {
      found.push_back({static_cast<Vertex>(order[i]), static_cast<Vertex>(order[j])});
    }
    i = j;
  }
  std::sort(found.begin(), found.end(),
            [](const Duplicate& a, const Duplicate& b) { return a.again < b.again; });
  return found;
}

// For each point the one that stands for it: itself, or an equal one.
std::vector<Vertex> representatives(const Mesh& mesh, const std::vector<Duplicate>& repeated) {
  std::vector<Vertex> first(mesh.points());
  std::iota(first.begin(), first.end(), Vertex{0});
  for (const Duplicate& duplicate : repeated) {
    first[static_cast<std::size_t>(duplicate.again)] = duplicate.kept;
  }
  if (!mesh.is_weighted()) return first;
  std::vector<Vertex> heaviest = first;  // of the points that are equal to a first one
  for (const Duplicate& duplicate : repeated) {
    Vertex& best = heaviest[static_cast<std::size_t>(duplicate.kept)];
    if (mesh.weight(best) < mesh.weight(duplicate.again)) best = duplicate.again;
  }
  for (Vertex& v : first) v = heaviest[static_cast<std::size_t>(v)];
  return first;
}

Numbers rows_at(const Numbers& numbers, const std::vector<std::size_t>& places) {
  return std::visit(
      [&places]<class Value>(const Rows<Value>& rows) -> Numbers {
        if (rows.rows() == 0) return Rows<Value>(0, rows.columns());
        Rows<Value> some(places.size(), rows.columns());
        for (std::size_t i = 0; i < places.size(); ++i) {
          std::copy(rows.row(places[i]).begin(), rows.row(places[i]).end(), some.row(i).begin());
        }
        return some;
      },
      numbers);
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

std::vector<Duplicate> equal_points(const Mesh& mesh) {
  return std::visit([](const auto& rows) { return equal_rows(rows); }, mesh.coordinates);
}

std::vector<Duplicate> merge_equal_points(Mesh& mesh) {
  assert(mesh.labels.empty());
  std::vector<Duplicate> repeated = equal_points(mesh);
  if (repeated.empty()) return repeated;
  std::vector<Vertex> representative_of = representatives(mesh, repeated);
  std::vector<bool> repeats(mesh.points(), false);
  for (const Duplicate& duplicate : repeated) {
    repeats[static_cast<std::size_t>(duplicate.again)] = true;
  }
  std::vector<std::size_t> left;
  std::vector<Vertex> labels;
  std::vector<Vertex> place_of(mesh.points());
  for (std::size_t v = 0; v < mesh.points(); ++v) {
    if (repeats[v]) continue;
    place_of[v] = static_cast<Vertex>(left.size());
    left.push_back(static_cast<std::size_t>(representative_of[v]));
    labels.push_back(index_of_place(representative_of[v], mesh.first_index));
  }
  for (const Duplicate& duplicate : repeated) {
    place_of[static_cast<std::size_t>(duplicate.again)] =
        place_of[static_cast<std::size_t>(duplicate.kept)];
  }
  mesh.coordinates = rows_at(mesh.coordinates, left);
  mesh.weights = rows_at(mesh.weights, left);
  mesh.labels = std::move(labels);
  Renaming renaming(mesh, std::move(representative_of), std::move(place_of));
  mesh.simplices = IndexLists(renaming.renamed(mesh.simplices.lists(), true));
  mesh.faces = renaming.renamed(std::move(mesh.faces), false);
  return repeated;
}

}  // namespace circumspect
