// The catalogue of mutations: each way to break a Delaunay mesh of any size, points, simplices, links and
// weights, with what must be said of it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "oracle/model/rule.hpp"
#include "properties/mutations/array_mesh.hpp"

namespace circumspect::properties {

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
  // Breaks a Delaunay triangulation (with weights: a weighted one) whose neighbours are listed; false,
  // and nothing is known of the mesh, if it offers no place for that. Afterwards the neighbours are gone,
  // unless the mutation is one of them, or leaves them right.
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

// A fan of triangles with rings around it that winds twice around its centre, and in space the double
// cone over it: links, sides, and the boundary are those of a triangulation, yet all is covered twice.
// `around` points lie on each ring. Requires: dimension 2 or 3; `around` is odd, at least 5.
ArrayMesh doubly_wound(std::size_t dimension, std::size_t around, std::size_t rings);

}  // namespace circumspect::properties
