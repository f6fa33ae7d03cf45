#include "reference/constrained/obstacles.hpp"

#include "reference/constrained/meets_interior.hpp"

namespace circumspect::constrained {

Obstacles::Obstacles(const PointSet& points, std::vector<std::size_t> axes,
                     std::vector<Simplex> obstacles)
    : points_(points),
      axes_(std::move(axes)),
      obstacles_(std::move(obstacles)),
      boxes_(points),
      index_(boxes_.index_of(obstacles_)) {}

std::optional<Simplex> Obstacles::inside(const Simplex& simplex) const {
  for (const std::size_t i : index_.meeting(boxes_.of(simplex))) {
    if (meets_interior(points_, axes_, simplex, obstacles_[i])) return obstacles_[i];
  }
  return std::nullopt;
}

}  // namespace circumspect::constrained
