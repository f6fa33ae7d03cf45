// What a broken rule is shown by: enough to re-check it by hand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/kernel/complex/circumball.hpp"
#include "reference/kernel/complex/simplex.hpp"

namespace circumspect {

// An exact value with the name under which it is reported.
struct NamedValue {
  std::string name;
  Rational value;
};

// The vertex of a mesh that is nearest to where one was expected: far below the size of the mesh, the
// distance tells rounding from a fault.
struct NearestVertex {
  Vertex vertex;
  Rational squared_distance;
};

// Simplices and vertices are named by indices from 0 (see Mesh::label for the user's own). Which
// fields are set depends on the rule; report/ puts them into words.
struct Witness {
  std::vector<Simplex> simplices = {};  // with their vertices as the user listed them
  // Where these stand among the simplices of the mesh, if other simplices may have the same vertices.
  std::vector<std::size_t> places = {};
  std::optional<Simplex> face = {};     // the facet or ridge in question
  std::vector<Vertex> vertices = {};    // the vertices that decide
  std::vector<NamedValue> values = {};  // the exact values that decide
  std::optional<Ball> ball = {};        // the circumball of the first simplex
  std::optional<Point> point = {};      // a point that decides without being a vertex
  // The cell of the domain in question: a vertex or a segment by the domain's own vertices, a polygon
  // by its place in the domain's list; a face of its convex hull by three vertices that span it.
  std::optional<Simplex> domain_cell = {};
  std::optional<std::size_t> polygon = {};
  std::optional<NearestVertex> nearest = {};  // to what is missing of the domain
};

}  // namespace circumspect
