// The Bowyer–Watson algorithm as it is mostly written: a list of simplices with one ghost vertex
// (Book: Section 5.2), no symbolic perturbation, and the mistakes of one's choice.
#pragma once

#include <optional>

#include "properties/faulty/plain_predicates.hpp"

namespace circumspect::faulty {

// Whether a point on the circumsphere of a simplex deletes it. Ghosts always say no. (Were they to
// say yes too, that would be right again: all ties must be broken alike.)
enum class Tie { kNo, kYes, kByVertexOrder };

// Which simplices are taken for those in conflict with a new point.
enum class Search { kEverySimplex, kWalkThenNeighbors };

// Without a mistake set the result is a (weighted) Delaunay triangulation, though not the canonical
// one: unperturbed strict tests, ghosts included, dig cavities that the new point sees all of.
struct Mistakes {
  Arithmetic arithmetic = {};
  Tie tie = Tie::kNo;
  bool no_ghosts = false;  // no simplices on the outside of the hull
  bool ghosts_forget_their_plane =
      false;  // a ghost never conflicts with a point in its facet's plane
  bool ghosts_take_their_plane = false;  // a ghost conflicts with every point in it
  bool only_splits =
      false;  // only what contains a point conflicts with it, and ghosts in front of it
  bool keeps_submerged_points = false;  // a weighted point that conflicts with nothing is inserted
  bool never_removes_vertices = false;  // a simplex stays if its deletion would lose a vertex
  Search search = Search::kEverySimplex;
  bool first_as_it_comes = false;     // the first simplex is not made positively oriented
  bool stamps_in_a_byte = false;      // marks of what the search has seen are 8 bits, never cleared
  std::size_t most_steps = 1000;      // of the walk
  std::size_t most_layers = 1000;     // of neighbours around the simplex that the walk ends in
  std::size_t most_waiting = 100000;  // simplices of a layer
};

// Inserts the points in their order. Of points that span a flat, the triangulation in that flat.
SimplexArray plain_delaunay(const PointArray& points, const Mistakes& mistakes = {});

}  // namespace circumspect::faulty
