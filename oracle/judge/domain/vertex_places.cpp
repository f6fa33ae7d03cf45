#include "oracle/judge/domain/vertex_places.hpp"

#include <algorithm>
#include <array>

#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"

namespace circumspect::check {

namespace {

std::vector<Vertex> lexicographic_order(const PointSet& points) {
  std::vector<Vertex> order(points.size());
  for (Vertex v = 0; points.names(v); ++v) order[points.configuration().rank(v)] = v;
  return order;
}

void mark_used(const std::vector<Simplex>& simplices, std::vector<bool>& used) {
  for (const Simplex& simplex : simplices) {
    for (const Vertex v : simplex) used[VertexPlaces::place(v)] = true;
  }
}

Simplex renumbered(Simplex simplex, const std::vector<Vertex>& number) {
  for (Vertex& v : simplex) v = number[VertexPlaces::place(v)];
  return simplex;
}

// The triangles of all polygons, by the points of the mesh.
struct Triangles {
  std::vector<Simplex> corners;
  std::vector<std::size_t> polygon;
};

Triangles triangles_of(const PiecewiseLinearComplex& complex, const std::vector<Vertex>& in_mesh) {
  Triangles triangles;
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
    for (const Simplex& triangle : complex.polygons[p].triangles) {
      triangles.corners.push_back(renumbered(triangle, in_mesh));
      triangles.polygon.push_back(p);
    }
  }
  return triangles;
}

}  // namespace

VertexPlaces match_vertices(const ExactMesh& mesh, const PiecewiseLinearComplex& complex) {
  VertexPlaces places;
  const std::size_t size = mesh.points.size();
  places.in_mesh.assign(complex.points.size(), kNoVertex);
  places.in_domain.assign(size, kNoVertex);
  places.used.assign(size, false);
  places.segment.assign(size, kNowhere);
  places.polygon.assign(size, kNowhere);
  mark_used(mesh.simplices, places.used);
  mark_used(mesh.faces, places.used);
  const std::vector<Vertex> ours = lexicographic_order(complex.points);
  const std::vector<Vertex> theirs = lexicographic_order(mesh.points);
  auto candidate = theirs.begin();
  for (const Vertex v : ours) {
    const Point& point = complex.points[v];
    while (candidate != theirs.end() && mesh.points[*candidate] < point) ++candidate;
    if (candidate == theirs.end()) break;
    if (mesh.points[*candidate] != point) continue;
    places.in_mesh[VertexPlaces::place(v)] = *candidate;
    places.in_domain[VertexPlaces::place(*candidate)] = v;
  }
  return places;
}

void locate_steiner_points(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                           VertexPlaces& places) {
  bool has_any = false;
  for (Vertex v = 0; mesh.points.names(v); ++v) has_any |= places.is_steiner(v);
  if (!has_any) return;
  const CellBoxes boxes(mesh.points);
  std::vector<Simplex> segments;
  segments.reserve(complex.segments.size());
  for (const Simplex& segment : complex.segments) {
    segments.push_back(renumbered(segment, places.in_mesh));
  }
  const BoxIndex segment_index = boxes.index_of(segments);
  const Triangles triangles = triangles_of(complex, places.in_mesh);
  const BoxIndex index = boxes.index_of(triangles.corners);
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    if (!places.is_steiner(v)) continue;
    const Box& box = boxes.of_vertices()[VertexPlaces::place(v)];
    std::size_t& on_segment = places.segment[VertexPlaces::place(v)];
    for (const std::size_t s : segment_index.meeting(box)) {
      if (lies_inside_segment(mesh.points.configuration(), segments[s], v)) on_segment = s;
    }
    if (on_segment != kNowhere) continue;
    for (const std::size_t t : index.meeting(box)) {
      const std::size_t p = triangles.polygon[t];
      if (!lies_in(mesh.points.configuration(), complex.polygons[p].axes, triangles.corners[t],
                   v)) {
        continue;
      }
      places.polygon[VertexPlaces::place(v)] = p;
      break;
    }
  }
}

std::vector<std::vector<std::size_t>> polygons_at_vertices(const ExactMesh& mesh,
                                                           const PiecewiseLinearComplex& complex,
                                                           const VertexPlaces& places) {
  std::vector<std::vector<std::size_t>> at_vertex(mesh.points.size());
  std::vector<std::vector<std::size_t>> at_segment(complex.segments.size());
  const bool any_on_segments = std::any_of(places.segment.begin(), places.segment.end(),
                                           [](std::size_t s) { return s != kNowhere; });
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
    for (const Vertex v : complex.polygons[p].vertices) {
      at_vertex[VertexPlaces::place(places.in_mesh[VertexPlaces::place(v)])].push_back(p);
    }
    if (!any_on_segments) continue;
    for (const Simplex& segment : complex.polygons[p].segments) {
      const auto found =
          std::lower_bound(complex.segments.begin(), complex.segments.end(), segment);
      at_segment[static_cast<std::size_t>(found - complex.segments.begin())].push_back(p);
    }
  }
  for (std::size_t v = 0; v < at_vertex.size(); ++v) {
    if (places.segment[v] != kNowhere) at_vertex[v] = at_segment[places.segment[v]];
    if (places.polygon[v] != kNowhere) at_vertex[v] = {places.polygon[v]};
  }
  return at_vertex;
}

SteinerPoints count_steiner_points(const VertexPlaces& places) {
  SteinerPoints count;
  for (std::size_t v = 0; v < places.in_domain.size(); ++v) {
    if (!places.is_steiner(static_cast<Vertex>(v))) continue;
    count.add(places.segment[v] != kNowhere ? 1 : places.polygon[v] != kNowhere ? 2 : 3);
  }
  return count;
}

bool judge_vertices(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                    const VertexPlaces& places, bool steiner_points_allowed, VertexSearch& search,
                    Verdict& verdict) {
  bool complete = true;
  for (Vertex v = 0; complex.points.names(v); ++v) {
    if (places.in_mesh[VertexPlaces::place(v)] != kNoVertex) continue;
    complete = false;
    Witness witness{.point = complex.points[v], .domain_cell = Simplex{v}};
    if (verdict.keeps_more()) witness.nearest = search.to_point(complex.points[v]);
    verdict.add(Rule::kDomainVertexMissing, witness);
  }
  ExtraVertices extra;
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    const std::size_t place = VertexPlaces::place(v);
    if (places.in_domain[place] != kNoVertex) continue;
    if (!places.used[place]) {
      verdict.add(Rule::kUnusedPoint, {.vertices = {v}, .point = mesh.points[v]});
      continue;
    }
    extra.add(v, verdict.max_violations());
    if (!steiner_points_allowed) verdict.add(Rule::kSteinerForbidden, {.vertices = {v}});
  }
  verdict.extra_vertices = std::move(extra);
  return complete;
}

}  // namespace circumspect::check
