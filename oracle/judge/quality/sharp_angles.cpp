#include "oracle/judge/quality/sharp_angles.hpp"

#include <algorithm>

#include "kernel/boxes/box_index.hpp"
#include "kernel/complex/by_facet.hpp"
#include "kernel/exact/angle.hpp"
#include "oracle/judge/definition/quality.hpp"
#include "oracle/judge/quality/exact_measure.hpp"
#include "oracle/judge/within/distance.hpp"

namespace circumspect::quality {
namespace {

std::vector<Point> corners_of(const Simplex& simplex, const std::vector<Point>& points) {
  std::vector<Point> corners;
  for (const Vertex v : simplex) corners.push_back(points[static_cast<std::size_t>(v)]);
  return corners;
}

Box box_of(const std::vector<Point>& corners) {
  Box box = box_around(corners.front());
  for (const Point& corner : corners) box = box_around(box, box_around(corner));
  return box;
}

}  // namespace

SharpAngles::SharpAngles(const Mesh& mesh, const Domain* domain, const Rational& degrees,
                         const Rational& squared_reach)
    : mesh_(mesh) {
  if (domain != nullptr) {
    const std::vector<Piece> pieces = pieces_of(domain->complex);
    find_pairs(pieces, domain->complex.points.points(), degrees);
    place_vertices(pieces, domain->complex.points.points(), squared_reach);
    return;
  }
  std::vector<Piece> facets = pieces_of_boundary();
  for (const Piece& facet : facets) {
    for (const Vertex v : facet.vertices) sides_of_vertex_[v].insert(facet.side);
  }
  const std::vector<Point> corners = corners_of_boundary(facets);
  find_pairs(facets, corners, degrees);
}

std::vector<SharpAngles::Piece> SharpAngles::pieces_of(
    const PiecewiseLinearComplex& complex) const {
  std::vector<Piece> pieces;
  std::size_t side = 0;
  for (const Simplex& segment : complex.segments) pieces.push_back({segment, side++});
  for (const Polygon& polygon : complex.polygons) {
    for (const Simplex& triangle : polygon.triangles) pieces.push_back({triangle, side});
    ++side;
  }
  return pieces;
}

std::vector<SharpAngles::Piece> SharpAngles::pieces_of_boundary() const {
  const int dimension = dimension_of_simplices(mesh_);
  std::vector<Simplex> sound;
  for (std::size_t s = 0; s < mesh_.simplices.size(); ++s) {
    const Simplex simplex = mesh_.simplices[s];
    if (measured(Measure::kEdge, mesh_, simplex, dimension)) sound.push_back(simplex);
  }
  std::vector<Piece> pieces;
  for (const auto uses : ByFacet(facet_uses(sound))) {
    if (uses.size() == 1) pieces.push_back({uses.front().facet, pieces.size()});
  }
  return pieces;
}

// Names the vertices of the boundary from 0, and returns where they are.
std::vector<Point> SharpAngles::corners_of_boundary(std::vector<Piece>& pieces) const {
  std::map<Vertex, Vertex> place_of;
  std::vector<Point> corners;
  for (Piece& piece : pieces) {
    for (Vertex& v : piece.vertices) {
      const auto [found, is_new] = place_of.emplace(v, static_cast<Vertex>(corners.size()));
      if (is_new) corners.push_back(mesh_.point(v));
      v = found->second;
    }
  }
  return corners;
}

void SharpAngles::find_pairs(const std::vector<Piece>& pieces, const std::vector<Point>& points,
                             const Rational& degrees) {
  struct Wing {
    Vertex apex;
    std::size_t side;
  };
  std::map<Simplex, std::vector<Wing>> wings_at;  // by the ridge
  for (const Piece& piece : pieces) {
    for (std::size_t i = 0; i < piece.vertices.size(); ++i) {
      Simplex ridge = sorted(facet_opposite(piece.vertices, i));
      if (!ridge.empty()) wings_at[std::move(ridge)].push_back({piece.vertices[i], piece.side});
    }
  }
  for (const auto& [ridge, wings] : wings_at) {
    const std::vector<Point> at = corners_of(ridge, points);
    for (std::size_t a = 0; a < wings.size(); ++a) {
      for (std::size_t b = a + 1; b < wings.size(); ++b) {
        if (wings[a].side == wings[b].side) continue;
        const Rational signed_square =
            definition::signed_square_at(at, points[static_cast<std::size_t>(wings[a].apex)],
                                         points[static_cast<std::size_t>(wings[b].apex)]);
        if (compare_angle(signed_square, degrees) >= 0) continue;
        pairs_.insert(
            {std::min(wings[a].side, wings[b].side), std::max(wings[a].side, wings[b].side)});
      }
    }
  }
}

void SharpAngles::place_vertices(const std::vector<Piece>& pieces, const std::vector<Point>& points,
                                 const Rational& squared_reach) {
  std::set<std::size_t> sharp;
  for (const auto& [a, b] : pairs_) {
    sharp.insert(a);
    sharp.insert(b);
  }
  std::vector<const Piece*> near;
  std::vector<Box> boxes;
  for (const Piece& piece : pieces) {
    if (!sharp.contains(piece.side)) continue;
    near.push_back(&piece);
    boxes.push_back(box_of(corners_of(piece.vertices, points)));
  }
  if (near.empty()) return;
  const BoxIndex index(boxes);
  const Rational reach = check::upper_square_root(squared_reach);
  for (std::size_t v = 0; v < mesh_.points(); ++v) {
    const Point point = mesh_.point(static_cast<Vertex>(v));
    for (const std::size_t found : index.meeting(cube(point, reach))) {
      const Piece& piece = *near[found];
      if (check::squared_distance_to(corners_of(piece.vertices, points), point) > squared_reach) {
        continue;
      }
      sides_of_vertex_[static_cast<Vertex>(v)].insert(piece.side);
    }
  }
}

bool SharpAngles::touches(const Simplex& simplex) const {
  std::set<std::size_t> sides;
  for (const Vertex v : simplex) {
    const auto found = sides_of_vertex_.find(v);
    if (found != sides_of_vertex_.end()) sides.insert(found->second.begin(), found->second.end());
  }
  for (auto a = sides.begin(); a != sides.end(); ++a) {
    for (auto b = std::next(a); b != sides.end(); ++b) {
      if (pairs_.contains({*a, *b})) return true;
    }
  }
  return false;
}

std::vector<bool> SharpAngles::touched() const {
  std::vector<bool> touched(mesh_.simplices.size(), false);
  if (pairs_.empty()) return touched;
  for (std::size_t s = 0; s < touched.size(); ++s) touched[s] = touches(mesh_.simplices[s]);
  return touched;
}

}  // namespace circumspect::quality
