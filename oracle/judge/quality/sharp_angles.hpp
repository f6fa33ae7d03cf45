// Sharp angles of a domain, or of the boundary of a mesh, and the simplices that touch both of
// their sides: what refinement cannot improve there is set aside.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "oracle/model/domain.hpp"
#include "oracle/model/mesh.hpp"

namespace circumspect::quality {

// Sides are the segments and polygons of the domain, or, without one, the facets that just one
// simplex has. Two segments meet at a common end at the angle between them; two polygons (two
// facets in space) at a common edge, at the angle between their half-planes there.
class SharpAngles {
 public:
  // Angles of less than so many degrees. A vertex is on a side if it is no further from it than the
  // root of `squared_reach`. Keeps a reference to the mesh.
  SharpAngles(const Mesh& mesh, const Domain* domain, const Rational& degrees,
              const Rational& squared_reach);

  // How many pairs of sides meet at a sharp angle.
  std::size_t size() const { return pairs_.size(); }

  // For each simplex: is there a sharp angle that has a vertex of it on one side, and one (which
  // may be the same) on the other?
  std::vector<bool> touched() const;

 private:
  // A part of a side: an edge or a triangle, by vertices of the domain or of the mesh.
  struct Piece {
    Simplex vertices;
    std::size_t side;
  };

  std::vector<Piece> pieces_of(const PiecewiseLinearComplex& complex) const;
  std::vector<Piece> pieces_of_boundary() const;
  void find_pairs(const std::vector<Piece>& pieces, const std::vector<Point>& points,
                  const Rational& degrees);
  void place_vertices(const std::vector<Piece>& pieces, const std::vector<Point>& points,
                      const Rational& squared_reach);
  std::vector<Point> corners_of_boundary(std::vector<Piece>& pieces) const;
  bool touches(const Simplex& simplex) const;

  const Mesh& mesh_;
  std::set<std::pair<std::size_t, std::size_t>> pairs_;      // of sides, the lesser first
  std::map<Vertex, std::set<std::size_t>> sides_of_vertex_;  // those in pairs
};

}  // namespace circumspect::quality
