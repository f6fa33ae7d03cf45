#include "oracle/judge/domain/polygon_tiling.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "kernel/complex/by_facet.hpp"
#include "kernel/complex/improper_intersection.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect::check {
namespace {

// For each polygon the facets and listed triangles with all vertices in it, ascending, each once.
// Of these some may span a hole or a notch of it.
std::vector<std::vector<Simplex>> triangles_at_polygons(const MeshedDomain& in) {
  const auto at_vertex = polygons_at_vertices(in.mesh, in.complex, in.places);
  std::vector<std::vector<Simplex>> candidates(in.complex.polygons.size());
  const auto file = [&](const Simplex& triangle) {
    const auto& first = at_vertex[VertexPlaces::place(triangle[0])];
    const auto& second = at_vertex[VertexPlaces::place(triangle[1])];
    const auto& third = at_vertex[VertexPlaces::place(triangle[2])];
    if (first.empty() || second.empty() || third.empty()) return;
    for (const std::size_t p : first) {
      if (std::binary_search(second.begin(), second.end(), p) &&
          std::binary_search(third.begin(), third.end(), p)) {
        candidates[p].push_back(triangle);
      }
    }
  };
  for (const auto group : ByFacet(in.uses)) file(group.front().facet);
  for (const Simplex& face : in.mesh.faces) {
    if (face.size() == 3) file(sorted(face));
  }
  for (std::vector<Simplex>& triangles : candidates) {
    keep_each_once(triangles);
  }
  return candidates;
}

// Edges of some triangles, and which triangles have them.
class EdgeTable {
 public:
  explicit EdgeTable(const std::vector<Simplex>& triangles) : uses_(facet_uses(triangles)) {}

  std::span<const FacetUse> of(const Simplex& edge) const {
    const auto range = std::equal_range(uses_.begin(), uses_.end(), edge, Order());
    return std::span(uses_).subspan(static_cast<std::size_t>(range.first - uses_.begin()),
                                    static_cast<std::size_t>(range.second - range.first));
  }

 private:
  struct Order {
    bool operator()(const FacetUse& a, const Simplex& b) const { return a.facet < b; }
    bool operator()(const Simplex& a, const FacetUse& b) const { return a < b.facet; }
  };
  std::vector<FacetUse> uses_;
};

// Tiles one polygon: starts at its segments, where the domain says on which sides it lies, and goes
// on across the other edges.
class Tiling {
 public:
  Tiling(const MeshedDomain& in, std::size_t polygon, const std::vector<Simplex>& triangles)
      : in_(in),
        number_(polygon),
        polygon_(in.complex.polygons[polygon]),
        triangles_(triangles),
        edges_(triangles),
        own_edges_(polygon_.triangles),
        reference_(triangles.size(), kNowhere) {}

  // Adds the pieces, or one violation.
  bool add_pieces(std::vector<WallPiece>& pieces, Verdict& verdict) {
    if (!start(verdict) || !spread(verdict) || !has_its_vertices(verdict)) return false;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (reference_[t] != kNowhere) pieces.push_back(piece(t));
    }
    return true;
  }

 private:
  int side(const Simplex& edge, Vertex v) const {
    return orientation(in_.mesh.points.configuration(), polygon_.axes,
                       std::array{edge[0], edge[1], v});
  }

  // The triangle of the domain's own that lies at a segment on a side of it, or kNowhere.
  std::size_t own_triangle(const Simplex& segment, int side) const {
    for (const FacetUse& use : own_edges_.of(segment)) {
      const Vertex apex = polygon_.triangles[use.simplex][use.opposite];
      if (orientation(in_.complex.points.configuration(), polygon_.axes,
                      std::array{segment[0], segment[1], apex}) == side) {
        return use.simplex;
      }
    }
    return kNowhere;
  }

  // At every link of a segment, on each side on which the polygon lies, one triangle.
  bool start(Verdict& verdict) {
    const std::vector<Simplex>& segments = in_.complex.segments;
    for (const Simplex& segment : polygon_.segments) {
      const auto at = std::lower_bound(segments.begin(), segments.end(), segment);
      const auto& chain = in_.chains.chain(static_cast<std::size_t>(at - segments.begin()));
      for (const int which : {-1, 1}) {
        const std::size_t own = own_triangle(segment, which);
        if (own == kNowhere) continue;
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
          if (!start_at({chain[i], chain[i + 1]}, which, own, verdict)) return false;
        }
      }
    }
    return true;
  }

  bool start_at(const Simplex& link, int which, std::size_t own, Verdict& verdict) {
    std::size_t found = kNowhere;
    for (const FacetUse& use : edges_.of(sorted(link))) {
      if (side(link, triangles_[use.simplex][use.opposite]) != which) continue;
      if (found != kNowhere) return overlap(found, use.simplex, verdict);
      found = use.simplex;
    }
    if (found == kNowhere) return not_tiled(sorted(link), {}, verdict);
    reach(found, own);
    return true;
  }

  void reach(std::size_t triangle, std::size_t own) {
    if (reference_[triangle] != kNowhere) return;
    reference_[triangle] = own;
    reached_.push_back(triangle);
  }

  // Every other edge of a triangle has exactly one triangle on its other side.
  bool spread(Verdict& verdict) {
    for (std::size_t next = 0; next < reached_.size(); ++next) {
      const std::size_t t = reached_[next];
      for (std::size_t place = 0; place < 3; ++place) {
        const Simplex edge = facet_opposite(triangles_[t], place);
        const Vertex apex = triangles_[t][place];
        if (is_link_of_polygon(edge)) {
          if (!is_on_its_side(edge, apex)) return not_tiled(edge, {triangles_[t]}, verdict);
        } else if (!spread_across(edge, t, side(edge, apex), verdict)) {
          return false;
        }
      }
    }
    return true;
  }

  bool spread_across(const Simplex& edge, std::size_t t, int own_side, Verdict& verdict) {
    std::size_t found = kNowhere;
    for (const FacetUse& use : edges_.of(edge)) {
      if (use.simplex == t) continue;
      const bool same_side = side(edge, triangles_[use.simplex][use.opposite]) == own_side;
      if (same_side || found != kNowhere) {
        return overlap(same_side ? t : found, use.simplex, verdict);
      }
      found = use.simplex;
    }
    if (found == kNowhere) return not_tiled(edge, {triangles_[t]}, verdict);
    reach(found, reference_[t]);
    return true;
  }

  // The segment of the polygon that the edge is a link of.
  std::optional<std::size_t> segment_of(const Simplex& edge) const {
    if (!in_.chains.is_link(edge[0], edge[1])) return std::nullopt;
    const std::size_t segment = in_.chains.stretch(edge[0], edge[1])->segment;
    if (!std::binary_search(polygon_.segments.begin(), polygon_.segments.end(),
                            in_.complex.segments[segment])) {
      return std::nullopt;
    }
    return segment;
  }
  bool is_link_of_polygon(const Simplex& edge) const { return segment_of(edge).has_value(); }

  // Does the polygon lie at this link on the side of the apex?
  bool is_on_its_side(const Simplex& edge, Vertex apex) const {
    const std::size_t segment = *segment_of(edge);
    const Vertex from = in_.chains.chain(segment).front();
    const Vertex to = in_.chains.chain(segment).back();
    return own_triangle(in_.complex.segments[segment], side({from, to}, apex)) != kNowhere;
  }

  bool has_its_vertices(Verdict& verdict) const {
    std::vector<Vertex> had;
    for (const std::size_t t : reached_) {
      had.insert(had.end(), triangles_[t].begin(), triangles_[t].end());
    }
    for (const Simplex& segment : polygon_.segments) {
      for (const Vertex v : segment) had.push_back(in_.in_mesh(v));
    }
    std::sort(had.begin(), had.end());
    for (const Vertex v : polygon_.vertices) {
      if (std::binary_search(had.begin(), had.end(), in_.in_mesh(v))) continue;
      Witness witness{.vertices = {in_.in_mesh(v)}, .domain_cell = Simplex{v}, .polygon = number_};
      if (verdict.keeps_more()) witness.nearest = in_.search.to_point(in_.complex.points[v]);
      verdict.add(Rule::kDomainVertexMissing, witness);
      return false;
    }
    return true;
  }

  WallPiece piece(std::size_t t) const {
    const Simplex& own = polygon_.triangles[reference_[t]];
    const OrientedFacet facet{own, false};
    std::array<std::size_t, 2> regions = {in_.regions.in_front_of(facet.reverse()),
                                          in_.regions.in_front_of(facet)};
    if (orientation(in_.complex.points.configuration(), polygon_.axes, own) !=
        orientation(in_.mesh.points.configuration(), polygon_.axes, triangles_[t])) {
      std::swap(regions[0], regions[1]);
    }
    return {triangles_[t], number_, regions};
  }

  bool not_tiled(const Simplex& edge, std::vector<Simplex> triangles, Verdict& verdict) const {
    verdict.add(Rule::kPolygonNotTiled,
                {.simplices = std::move(triangles), .face = edge, .polygon = number_});
    return false;
  }
  bool overlap(std::size_t a, std::size_t b, Verdict& verdict) const {
    verdict.add(Rule::kOverlap,
                {.simplices = {triangles_[a], triangles_[b]},
                 .point = improper_intersection(in_.mesh.points, triangles_[a], triangles_[b]),
                 .polygon = number_});
    return false;
  }

  const MeshedDomain& in_;
  std::size_t number_;
  const Polygon& polygon_;
  const std::vector<Simplex>& triangles_;
  EdgeTable edges_;
  EdgeTable own_edges_;
  std::vector<std::size_t> reference_;  // the domain's triangle where the flood came from
  std::vector<std::size_t> reached_;
};

// A polygon that is one triangle whose edges are edges of the mesh, with no other triangle of the
// mesh near it: then it is this one, and nothing has to be tiled.
std::optional<WallPiece> whole_triangle(const MeshedDomain& in, std::size_t p,
                                        const std::vector<Simplex>& candidates) {
  const Polygon& polygon = in.complex.polygons[p];
  const bool is_triangle =
      polygon.triangles.size() == 1 && polygon.vertices.size() == 3 && polygon.segments.size() == 3;
  if (!is_triangle || candidates.size() != 1) return std::nullopt;
  const Simplex& own = polygon.triangles.front();
  Simplex image;
  for (const Vertex v : own) image.push_back(in.in_mesh(v));
  const OrientedFacet facet = OrientedFacet::of(image);
  if (facet.vertices != candidates.front()) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!in.chains.is_link(image[i], image[(i + 1) % 3])) return std::nullopt;
  }
  const OrientedFacet front{own, facet.reversed};
  return WallPiece{
      facet.vertices, p, {in.regions.in_front_of(front.reverse()), in.regions.in_front_of(front)}};
}

std::vector<WallPiece> pieces_of_segments(const MeshedDomain& in) {
  std::vector<WallPiece> pieces;
  for (std::size_t s = 0; s < in.chains.size(); ++s) {
    const OrientedFacet wall{in.complex.segments[s], false};
    const std::array<std::size_t, 2> regions = {in.regions.in_front_of(wall.reverse()),
                                                in.regions.in_front_of(wall)};
    const std::vector<Vertex>& chain = in.chains.chain(s);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (chain[i] < chain[i + 1]) {
        pieces.push_back({{chain[i], chain[i + 1]}, s, regions});
      } else {
        pieces.push_back({{chain[i + 1], chain[i]}, s, {regions[1], regions[0]}});
      }
    }
  }
  return pieces;
}

}  // namespace

std::optional<std::vector<WallPiece>> wall_pieces(const MeshedDomain& in, Verdict& verdict) {
  std::vector<WallPiece> pieces;
  bool tiled = true;
  if (in.complex.ambient_dimension() == 2) {
    pieces = pieces_of_segments(in);
  } else {
    const auto candidates = triangles_at_polygons(in);
    for (std::size_t p = 0; p < candidates.size(); ++p) {
      if (auto piece = whole_triangle(in, p, candidates[p])) {
        pieces.push_back(*std::move(piece));
        continue;
      }
      tiled &= Tiling(in, p, candidates[p]).add_pieces(pieces, verdict);
    }
  }
  if (!tiled) return std::nullopt;
  std::sort(pieces.begin(), pieces.end(),
            [](const WallPiece& a, const WallPiece& b) { return a.facet < b.facet; });
  return pieces;
}

}  // namespace circumspect::check
