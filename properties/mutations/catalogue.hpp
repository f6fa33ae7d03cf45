// Meshes of doubles in arrays, of any size, to be broken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "inputs/dice.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/rule.hpp"

namespace circumspect::properties {

struct ArrayMesh {
  std::size_t dimension = 3;                 // d
  std::vector<double> coordinates = {};      // d a point
  std::vector<double> weights = {};          // none, or one a point
  std::vector<std::int64_t> simplices = {};  // d + 1 a simplex
  // None, or as many: the simplex across the facet opposite each vertex, −1 if there is none.
  std::vector<std::int64_t> neighbors = {};

  std::size_t width() const { return dimension + 1; }
  std::size_t points() const { return coordinates.size() / dimension; }
  std::size_t size() const { return simplices.size() / width(); }
  std::span<std::int64_t> row(std::size_t s) { return {&simplices[s * width()], width()}; }
  std::span<const std::int64_t> row(std::size_t s) const {
    return {&simplices[s * width()], width()};
  }
};

// The points are doubles, and all simplices have d + 1 vertices, or there is none.
ArrayMesh array_mesh(const PointSet& points, const std::vector<Simplex>& simplices);
// Equal points stay apart, which no ExactMesh has: not for checkers, unless they are merged first.
std::vector<Simplex> simplices_of(const ArrayMesh& mesh);

// Lists the right neighbours: of facets that two simplices share, by their indices.
void list_neighbors(ArrayMesh& mesh);

// A facet is simplex · (d + 1) + place of the vertex opposite. The same facet from the other side.
// Requires: the neighbours are right; there is another side.
std::size_t other_side(const ArrayMesh& mesh, std::size_t facet);

// Exact signs: of the orientation of a row, and of whether a point is in its ball
// (kernel/predicates). Requires: the indices name points; for the second, the row is not flat.
int orientation_of(const ArrayMesh& mesh, std::span<const std::int64_t> row);
int in_ball_of(const ArrayMesh& mesh, std::span<const std::int64_t> row, std::int64_t q);

using generators::Dice;

// The catalogue of mutations: each way to break a Delaunay mesh of any size, points, simplices,
// links and weights, with what must be said of it.

enum class Expected {
  kFails,  // as a Delaunay triangulation; as any triangulation too, unless the rules are about balls
  kHolds,        // nothing that a claim is about was changed
  kEqualPoints,  // some points are equal: those who merge them first find that it holds
  kEither,       // it depends on the mesh
};

struct Mutation {
  std::string name;
  std::string about;
  Expected expected;
  // If it fails, one of these is named first. Of weighted meshes: by the claim about those.
  std::set<Rule> rules;
  // Breaks a Delaunay triangulation (with weights: a weighted one) whose neighbours are listed;
  // false, and nothing is known of the mesh, if it offers no place for that. Afterwards the
  // neighbours are gone, unless the mutation is one of them, or leaves them right.
  bool (*apply)(ArrayMesh&, Dice&);
  bool needs_weights = false;
};

// Of the indices of simplices, one at a time.
std::vector<Mutation> index_mutations();
// Of two simplices or more that share faces: flips gone wrong, holes, the hull.
std::vector<Mutation> facet_mutations();
// What covers the hull more than once.
std::vector<Mutation> cover_mutations();
// Of listed neighbours, at one end or at all.
std::vector<Mutation> link_mutations();
// Of points and weights.
std::vector<Mutation> point_mutations();

// All of them.
std::vector<Mutation> catalogue();

// A fan of triangles with rings around it that winds twice around its centre, and in space the
// double cone over it: links, sides, and the boundary are those of a triangulation, yet all is
// covered twice. `around` points lie on each ring. Requires: dimension 2 or 3; `around` is odd, at
// least 5.
ArrayMesh doubly_wound(std::size_t dimension, std::size_t around, std::size_t rings);

}  // namespace circumspect::properties
