#include "oracle/model/mesh.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

#include "kernel/exact/interruption.hpp"

namespace circumspect {

namespace {

Rational exact_number(double number) { return exact_value(number); }
const Rational& exact_number(const Rational& number) { return number; }

Rational exact_at(const Numbers& numbers, std::size_t row, std::size_t column) {
  return std::visit([&](const auto& rows) { return Rational(exact_number(rows.row(row)[column])); },
                    numbers);
}

// `number(row, column)`, in doubles if all are.
template <class Number>
Numbers in_narrowest(std::size_t rows, std::size_t columns, const Number& number) {
  Rows<double> doubles(rows, columns);
  bool fits = true;
  for (std::size_t i = 0; i < rows && fits; ++i) {
    for (std::size_t j = 0; j < columns && fits; ++j) {
      const auto same = as_double(number(i, j));
      fits = same.has_value();
      doubles.row(i)[j] = same.value_or(0);
    }
  }
  if (fits) return doubles;
  Rows<Rational> exact_rows(rows, columns);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) exact_rows.row(i)[j] = number(i, j);
  }
  return exact_rows;
}

// Its indices, in the order of the vertices here.
Simplex in_order(const AsListed::Cell& cell, const Simplex& vertices) {
  if (cell.vertices == vertices) return cell.indices;
  Simplex indices;
  for (const Vertex v : vertices) {
    const auto found = std::find(cell.vertices.begin(), cell.vertices.end(), v);
    indices.push_back(cell.indices[static_cast<std::size_t>(found - cell.vertices.begin())]);
  }
  return indices;
}

// Subtracts `before` from every index but −1, and adds `after`.
void shift(std::vector<Simplex>& lists, Vertex before, Vertex after) {
  for (Simplex& list : lists) {
    for (Vertex& index : list) {
      if (index != -1) index = index_of_place(place_of_index(index, before), after);
    }
  }
}

}  // namespace

Numbers numbers_of(const std::vector<Point>& points, std::size_t dimension) {
  return in_narrowest(
      points.size(), dimension,
      [&](std::size_t i, std::size_t j) -> const Rational& { return points[i][j]; });
}

Numbers numbers_of(const std::vector<Rational>& numbers) {
  return in_narrowest(numbers.size(), 1,
                      [&](std::size_t i, std::size_t) -> const Rational& { return numbers[i]; });
}

std::size_t rows_of(const Numbers& numbers) {
  return std::visit([](const auto& rows) { return rows.rows(); }, numbers);
}

std::size_t columns_of(const Numbers& numbers) {
  return std::visit([](const auto& rows) { return rows.columns(); }, numbers);
}

ListedNeighbors::ListedNeighbors(Neighbors listed) : first_index(listed.first_index) {
  const Vertex before_first = index_of_place(-1, first_index);
  are_as_listed = before_first != -1 &&
                  std::any_of(listed.rows.begin(), listed.rows.end(), [&](const auto& row) {
                    return std::find(row.begin(), row.end(), before_first) != row.end();
                  });
  if (!are_as_listed) shift(listed.rows, first_index, 0);
  rows = IndexLists(std::move(listed.rows));
}

Neighbors ListedNeighbors::as_listed() const {
  Neighbors listed{rows.lists(), first_index};
  if (!are_as_listed) shift(listed.rows, 0, first_index);
  return listed;
}

Point Mesh::point(Vertex v) const {
  Point point;
  point.reserve(dimension());
  for (std::size_t axis = 0; axis < dimension(); ++axis) {
    point.push_back(exact_at(coordinates, static_cast<std::size_t>(v), axis));
  }
  return point;
}

Rational Mesh::weight(Vertex v) const {
  return is_weighted() ? exact_at(weights, static_cast<std::size_t>(v), 0) : Rational(0);
}

std::vector<Point> Mesh::exact_points() const {
  std::vector<Point> all;
  all.reserve(points());
  for (Vertex v = 0; names(v); ++v) {
    end_if_interrupted();
    all.push_back(point(v));
  }
  return all;
}

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

ExactMesh exact(const Mesh& mesh) {
  std::vector<Rational> weights;
  if (mesh.is_weighted()) {
    weights.reserve(mesh.points());
    for (Vertex v = 0; mesh.names(v); ++v) weights.push_back(mesh.weight(v));
  }
  ExactMesh result{PointSet(mesh.exact_points(), std::move(weights)),
                   mesh.simplices.lists(),
                   mesh.labels,
                   mesh.first_index,
                   {},
                   mesh.faces};
  if (mesh.neighbors) result.neighbors = mesh.neighbors->as_listed();
  return result;
}

Mesh in_rows(const ExactMesh& mesh) {
  Mesh result;
  result.coordinates = numbers_of(mesh.points.points(), mesh.points.ambient_dimension());
  if (mesh.points.is_weighted()) {
    std::vector<Rational> weights;
    for (Vertex v = 0; mesh.points.names(v); ++v) weights.push_back(mesh.points.weight(v));
    result.weights = numbers_of(weights);
  }
  result.simplices = IndexLists(mesh.simplices);
  result.labels = mesh.labels;
  result.first_index = mesh.first_index;
  if (mesh.neighbors) result.neighbors.emplace(*mesh.neighbors);
  result.faces = mesh.faces;
  return result;
}

namespace {

// The points sorted so that equal ones are adjacent, the first of them first.
template <class Value>
std::vector<std::size_t> in_order(const Rows<Value>& rows) {
  std::vector<std::size_t> order(rows.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&rows](std::size_t a, std::size_t b) {
    end_if_interrupted();
    const auto of_a = rows.row(a);
    const auto of_b = rows.row(b);
    for (std::size_t axis = 0; axis < of_a.size(); ++axis) {
      if (of_a[axis] != of_b[axis]) return of_a[axis] < of_b[axis];
    }
    return a < b;
  });
  return order;
}

// For rows of doubles, by a hash table; nothing if that takes long, as it does if many hashes
// collide. Requires: the numbers are finite.
std::optional<std::vector<Duplicate>> equal_rows_by_hash(const Rows<double>& rows) {
  constexpr std::size_t kFree = ~std::size_t{0};
  const std::size_t count = rows.rows();
  std::vector<std::size_t> table(std::bit_ceil(count + count / 2 + 1), kFree);
  std::size_t steps = 8 * count;
  std::vector<Duplicate> found;
  for (std::size_t i = 0; i < count; ++i) {
    end_if_interrupted();
    const auto row = rows.row(i);
    std::uint64_t hash = 0;
    for (const double number : row) {
      // 0 for −0, which equals it. The product's upper half is mixed with its lower half, so that
      // all bits count.
      hash = (hash ^ std::bit_cast<std::uint64_t>(number + 0.0)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32;
    }
    std::size_t place = hash & (table.size() - 1);
    while (table[place] != kFree &&
           !std::equal(row.begin(), row.end(), rows.row(table[place]).begin())) {
      if (steps-- == 0) return std::nullopt;
      place = (place + 1) & (table.size() - 1);
    }
    if (table[place] == kFree) {
      table[place] = i;
    } else {
      found.push_back({static_cast<Vertex>(table[place]), static_cast<Vertex>(i)});
    }
  }
  return found;
}

template <class Value>
std::vector<Duplicate> equal_rows(const Rows<Value>& rows) {
  if constexpr (std::is_same_v<Value, double>) {
    if (auto found = equal_rows_by_hash(rows)) return *std::move(found);
  }
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

// For each point the one that represents it: itself, or an equal one.
std::vector<Vertex> representatives(const Mesh& mesh, const std::vector<Duplicate>& repeated) {
  std::vector<Vertex> first(mesh.points());
  std::iota(first.begin(), first.end(), Vertex{0});
  for (const Duplicate& duplicate : repeated) {
    first[static_cast<std::size_t>(duplicate.again)] = duplicate.kept;
  }
  if (!mesh.is_weighted()) return first;
  std::vector<Vertex> heaviest = first;  // the points that are equal to an earlier one
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

// Renames the vertices to the points that are left, and keeps the lists with the original names.
class Renaming {
 public:
  // `own`: the user's index of each point.
  Renaming(Mesh& mesh, std::vector<Vertex> own, std::vector<Vertex> representative_of,
           std::vector<Vertex> place_of)
      : mesh_(mesh),
        own_(std::move(own)),
        representative_of_(std::move(representative_of)),
        place_of_(std::move(place_of)) {}

  std::vector<Simplex> renamed(std::vector<Simplex> cells, bool are_simplices) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Simplex listed = cells[i];
      if (!rename(cells[i])) continue;
      Simplex indices;
      for (const Vertex v : listed) {
        const bool is_point = v >= 0 && v < static_cast<Vertex>(own_.size());
        indices.push_back(is_point ? own_[static_cast<std::size_t>(v)]
                                   : index_of_place(v, mesh_.first_index));
      }
      if (are_simplices) mesh_.as_listed.by_place.emplace(i, indices);
      mesh_.as_listed.by_set.emplace(sorted(cells[i]),
                                     AsListed::Cell{cells[i], std::move(indices)});
    }
    return cells;
  }

 private:
  // Does a vertex have another name now?
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
  std::vector<Vertex> own_;
  std::vector<Vertex> representative_of_;
  std::vector<Vertex> place_of_;
};

}  // namespace

std::vector<Duplicate> equal_points(const Mesh& mesh) {
  return std::visit([](const auto& rows) { return equal_rows(rows); }, mesh.coordinates);
}

std::vector<Duplicate> merge_equal_points(Mesh& mesh) {
  std::vector<Duplicate> repeated = equal_points(mesh);
  if (repeated.empty()) return repeated;
  std::vector<Vertex> own;
  for (Vertex v = 0; mesh.names(v); ++v) own.push_back(mesh.label(v));
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
    labels.push_back(own[static_cast<std::size_t>(representative_of[v])]);
  }
  for (const Duplicate& duplicate : repeated) {
    place_of[static_cast<std::size_t>(duplicate.again)] =
        place_of[static_cast<std::size_t>(duplicate.kept)];
  }
  mesh.coordinates = rows_at(mesh.coordinates, left);
  mesh.weights = rows_at(mesh.weights, left);
  mesh.labels = std::move(labels);
  Renaming renaming(mesh, own, std::move(representative_of), std::move(place_of));
  mesh.simplices = IndexLists(renaming.renamed(mesh.simplices.lists(), true));
  mesh.faces = renaming.renamed(std::move(mesh.faces), false);
  const auto in_file = [&](Vertex v) {
    return place_of_index(own[static_cast<std::size_t>(v)], mesh.first_index);
  };
  for (Duplicate& one : repeated) one = {in_file(one.kept), in_file(one.again)};
  return repeated;
}

}  // namespace circumspect
