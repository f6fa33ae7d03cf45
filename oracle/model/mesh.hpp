// A mesh as it was read, and the merging of its equal points.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <variant>
#include <vector>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/index_lists.hpp"
#include "oracle/model/periodic.hpp"

namespace circumspect {

// A user's mesh as it was read: points and a list of simplices that some program made of them, in
// arrays. exact() converts it to what the exact checkers judge.

// Finite doubles if all numbers are doubles, else exact numbers.
using Numbers = std::variant<Rows<double>, Rows<Rational>>;

// Requires: all points have `dimension` coordinates.
Numbers numbers_of(const std::vector<Point>& points, std::size_t dimension);
// One a row.
Numbers numbers_of(const std::vector<Rational>& numbers);
std::size_t rows_of(const Numbers& numbers);
std::size_t columns_of(const Numbers& numbers);

// Which simplex is across the facet opposite each vertex, as a program lists it.
struct ListedNeighbors {
  ListedNeighbors() = default;
  // Counted from 0, −1 for none; `first`: the user's index of the first simplex.
  ListedNeighbors(IndexLists counted_from_0, Vertex first)
      : rows(std::move(counted_from_0)), first_index(first) {}
  // As listed: counted from the index of the first simplex, −1 for none.
  explicit ListedNeighbors(Neighbors listed);

  // Counted from 0, −1 for none. They stay as listed only if some entry is the index before that of
  // the first simplex, which names no simplex but would become −1.
  IndexLists rows = {};
  Vertex first_index = 0;
  bool are_as_listed = false;

  Neighbors as_listed() const;
};

// Simplices and faces whose vertices include points that were merged into equal ones.
struct AsListed {
  struct Cell {
    Simplex vertices;  // as the mesh has them
    Simplex indices;   // the user's own for each
  };
  std::map<std::size_t, Simplex> by_place = {};  // indices of simplices, by their place among them
  std::map<Simplex, Cell> by_set =
      {};  // by the sorted vertices; if several became the same, the first
};

// Simplices name points by their index from 0; an index that names no point stays in place, for the
// judge to report. `labels` translates back: the user's own index of each point. It can be moved,
// but not copied.
struct Mesh {
  Numbers coordinates = {};  // n × d
  Numbers weights = {};      // n × 1, or none
  IndexLists simplices = {};
  std::vector<Vertex> labels = {};  // empty: the index itself
  Vertex first_index = 0;           // the user's index of the first point
  std::optional<ListedNeighbors> neighbors = {};
  std::vector<Simplex> faces = {};  // as ExactMesh has them
  AsListed as_listed = {};          // empty unless points were merged (below)
  // If a lattice repeats the mesh; several points then have one label.
  std::optional<Copies> copies = {};

  std::size_t points() const { return rows_of(coordinates); }
  // How many coordinates a point has.
  std::size_t dimension() const { return columns_of(coordinates); }
  bool is_weighted() const { return rows_of(weights) > 0; }
  bool names(Vertex v) const { return v >= 0 && v < static_cast<Vertex>(points()); }

  // Requires: names(v).
  Point point(Vertex v) const;
  Rational weight(Vertex v) const;  // 0 if there are none
  std::vector<Point> exact_points() const;

  // The user's own index of a vertex, whether it names a point or not.
  Vertex label(Vertex v) const {
    if (!names(v) || labels.empty()) return index_of_place(v, first_index);
    return labels[static_cast<std::size_t>(v)];
  }
  // A simplex or a face of the mesh by the user's own indices, as listed. `place`: its place among
  // the simplices, if several may have these vertices.
  Simplex listed(const Simplex& simplex, std::optional<std::size_t> place = {}) const;
};

// The same mesh in exact numbers and lists. Requires: no two points are equal (below).
ExactMesh exact(const Mesh& mesh);

// The same mesh in arrays.
Mesh in_rows(const ExactMesh& mesh);

// The equal points of a mesh, and how they are merged.

// Every point that repeats an earlier one, in order of `again`. Doubles are found by a hash table.
std::vector<Duplicate> equal_points(const Mesh& mesh);

// Replaces equal points by one: the first of them, or the heaviest (the first of several such) if
// they have weights, since the others are submerged below it. It takes the place of the first, and
// keeps its own index and its weight. Simplices and faces that name another of these points then
// name the kept one, and Mesh::as_listed keeps what they named. Returns the result of equal_points
// by places in the file: the user's own indices, counted from 0.
// Requires: nothing has been merged before.
std::vector<Duplicate> merge_equal_points(Mesh& mesh);

}  // namespace circumspect
