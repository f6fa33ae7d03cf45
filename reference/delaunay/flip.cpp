#include "reference/delaunay/flip.hpp"

#include <algorithm>
#include <cassert>
#include <set>

#include "reference/predicates/orientation.hpp"

namespace circumspect::delaunay {
namespace {

// The points of W by the sign of their coefficients in the affine dependence.
struct RadonPartition {
  Simplex with_apex;
  Simplex against_apex;
};

// apex = Σ_i λ_i p_i with the barycentric coordinates λ is the dependence: the apex has coefficient
// −1 and vertex i has λ_i, whose sign is the orientation with the apex in that vertex's stead over
// the simplex's own. Where λ_i is zero, vertex i takes no part.
RadonPartition radon_partition(const PointSet& points, const Simplex& simplex, Vertex apex) {
  const int own = orientation(points.configuration(), simplex);
  assert(own != 0);
  RadonPartition parts{{apex}, {}};
  for (std::size_t place = 0; place < simplex.size(); ++place) {
    const int coefficient =
        own * orientation(points.configuration(), with_vertex_replaced(simplex, place, apex));
    if (coefficient < 0) parts.with_apex.push_back(simplex[place]);
    if (coefficient > 0) parts.against_apex.push_back(simplex[place]);
  }
  return parts;
}

// The simplices on the vertices of both parts that omit one vertex of the first.
std::vector<Simplex> omitting_one_of(const Simplex& part, const Simplex& other) {
  std::vector<Simplex> simplices;
  for (std::size_t place = 0; place < part.size(); ++place) {
    simplices.push_back(join(facet_opposite(part, place), other));
  }
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

// T * Z.
std::vector<Simplex> joins(const std::vector<Simplex>& simplices, const std::set<Simplex>& others) {
  std::vector<Simplex> all;
  for (const Simplex& simplex : simplices) {
    for (const Simplex& other : others) all.push_back(join(simplex, other));
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

BasicFlip basic_flip(const PointSet& points, const Simplex& simplex, Vertex apex) {
  const RadonPartition parts = radon_partition(points, simplex, apex);
  return {omitting_one_of(parts.with_apex, parts.against_apex),
          omitting_one_of(parts.against_apex, parts.with_apex)};
}

std::string ExtendedFlip::name() const {
  return std::to_string(deleted.size()) + "-" + std::to_string(created.size());
}

tl::expected<ExtendedFlip, BlockedFlip> extended_flip(const StarIndex& triangulation,
                                                      const BasicFlip& flip) {
  std::set<Simplex> z;
  for (const Simplex& simplex : flip.deleted) {
    for (Simplex& zeta : triangulation.link(simplex)) z.insert(std::move(zeta));
  }
  assert(!z.empty());
  ExtendedFlip extended{joins(flip.deleted, z), joins(flip.created, z)};
  BlockedFlip blocked;
  for (const Simplex& simplex : extended.deleted) {
    if (!triangulation.has(simplex)) blocked.missing.push_back(simplex);
  }
  if (!blocked.missing.empty()) return tl::unexpected(std::move(blocked));
  return extended;
}

BasicFlip flip_of_facet(const PointSet& points, const StarIndex& triangulation,
                        const Simplex& facet) {
  const std::vector<Simplex> sides = triangulation.star(facet);
  assert(sides.size() == 2);
  return basic_flip(points, sides[0], without(sides[1], facet).front());
}

}  // namespace circumspect::delaunay
