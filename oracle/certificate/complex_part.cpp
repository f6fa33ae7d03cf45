// Definition 4.3: which segment or polygon holds each face of the mesh, and on how many sides of it
// the domain is.
#include <algorithm>
#include <set>

#include "oracle/certificate/domain_certificate.hpp"

namespace circumspect::certificate {
namespace {

bool is_exposed(const Certificate& mesh, const DomainPart& part, std::uint32_t simplex,
                std::size_t place) {
  const Across& across = mesh.simplices[simplex].across[place];
  return across.place == Across::kHull || part.marks[across.cell].rank != 0;
}

// Whether all of these facets are exposed, or none; nothing if some are.
template <typename Facets, typename Exposed>
std::optional<bool> all_alike(const Facets& facets, const Exposed& exposed) {
  if (facets.empty()) return false;
  const bool first = exposed(facets.front());
  for (const auto& facet : facets) {
    if (exposed(facet) != first) return std::nullopt;
  }
  return first;
}

std::optional<bool> on_one_side(const Certificate& mesh, const DomainPart& part,
                                const SegmentSteps& segment) {
  return all_alike(segment.steps, [&](const Step& step) {
    return is_exposed(mesh, part, step.simplex, step.place);
  });
}

class Faces {
 public:
  Faces(const DomainCertificate& in, ComplexPart& made) : in_(in), made_(made) {}

  void hold_segments() {
    const auto& segments = in_.part.segments;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      Vertex from = segments[s].from;
      for (const Step& step : segments[s].steps) {
        made_.faces.emplace(sorted({from, step.reached}), Holder{true, s});
        if (!is_corner(step.reached)) made_.faces.emplace(Simplex{step.reached}, Holder{true, s});
        from = step.reached;
      }
    }
  }

  // False if a face of the polygon is held by another polygon, or by a segment that is not in it.
  bool hold_polygon(std::size_t number) {
    const PolygonCertificate& polygon = in_.polygons[number];
    std::map<Simplex, std::size_t> piece_at;  // of the edges
    std::set<std::size_t> segments;
    for (std::size_t piece = 0; piece < polygon.tiles.size(); ++piece) {
      const auto& [simplex, place] = polygon.tiles[piece];
      Simplex tile;
      for (std::size_t i = 0; i < 4; ++i) {
        if (i != place) tile.push_back(in_.mesh.simplices[simplex].vertices[i]);
      }
      for (unsigned subset = 1; subset < 8; ++subset) {
        Simplex face;
        for (std::size_t i = 0; i < 3; ++i) {
          if ((subset >> i & 1U) != 0) face.push_back(tile[i]);
        }
        face = sorted(face);
        if (face.size() == 2) piece_at.emplace(face, piece);
        if (face.size() == 1 && is_corner(face[0])) continue;
        const Holder& holder = made_.faces.emplace(face, Holder{false, number}).first->second;
        if (holder.is_segment) {
          segments.insert(holder.number);
        } else if (holder.number != number) {
          return false;
        }
      }
    }
    for (const std::size_t s : segments) {
      std::vector<std::size_t> pieces;
      Vertex from = in_.part.segments[s].from;
      for (const Step& step : in_.part.segments[s].steps) {
        const auto found = piece_at.find(sorted({from, step.reached}));
        if (found == piece_at.end()) return false;
        pieces.push_back(found->second);
        from = step.reached;
      }
      made_.polygons[number].segments.emplace_back(s, std::move(pieces));
    }
    return true;
  }

 private:
  bool is_corner(Vertex v) const {
    return in_.part.roles[static_cast<std::size_t>(v)].corner_of.has_value();
  }

  const DomainCertificate& in_;
  ComplexPart& made_;
};

}  // namespace

std::optional<ComplexPart> complex_part(const DomainCertificate& in) {
  ComplexPart made;
  made.polygons.resize(in.polygons.size());
  Faces faces(in, made);
  faces.hold_segments();
  const bool is_planar = in.mesh.points.dimension == 2;
  const bool is_enclosed = in.kind == DomainKind::kEnclosed;
  for (const SegmentSteps& segment : in.part.segments) {
    if (!is_planar || !is_enclosed) break;
    const auto side = on_one_side(in.mesh, in.part, segment);
    if (!side) return std::nullopt;
    made.one_sided.push_back(*side);
  }
  for (std::size_t number = 0; number < in.polygons.size(); ++number) {
    const PolygonCertificate& polygon = in.polygons[number];
    if (!faces.hold_polygon(number)) return std::nullopt;
    for (std::size_t s = 0; s < polygon.rim.size(); ++s) {
      const auto side = on_one_side(polygon.plane, polygon.part, polygon.part.segments[s]);
      if (!side) return std::nullopt;
      made.polygons[number].rim.emplace_back(polygon.rim[s], *side);
    }
    if (!is_enclosed) continue;
    const auto side = all_alike(polygon.tiles, [&](const auto& tile) {
      return is_exposed(in.mesh, in.part, tile.first, tile.second);
    });
    if (!side) return std::nullopt;
    made.one_sided.push_back(*side);
  }
  return made;
}

}  // namespace circumspect::certificate
