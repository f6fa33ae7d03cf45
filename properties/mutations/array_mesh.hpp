// Meshes of doubles in arrays, of any size, to be broken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "oracle/model/exact_mesh.hpp"

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

// Exact signs: of the orientation of a row, and of whether a point is in its ball (reference/kernel/predicates).
// Requires: the indices name points; for the second, the row is not flat.
int orientation_of(const ArrayMesh& mesh, std::span<const std::int64_t> row);
int in_ball_of(const ArrayMesh& mesh, std::span<const std::int64_t> row, std::int64_t q);

// What is random in a mutation.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  // Requires: count > 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  std::mt19937_64& engine() { return engine_; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace circumspect::properties
