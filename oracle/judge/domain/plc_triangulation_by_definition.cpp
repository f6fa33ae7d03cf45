// Definitions 4.4 and 4.5, word for word, with measures for "is a union of".
#include <algorithm>
#include <array>
#include <numeric>
#include <set>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/predicates/place.hpp"
#include "oracle/judge/domain/measures.hpp"
#include "oracle/judge/domain/plc_triangulation.hpp"
#include "oracle/judge/domain/vertex_places.hpp"
#include "oracle/judge/points/triangulation.hpp"

namespace circumspect::check {

// Of a mesh that is a simplicial complex: what each cell of the domain contains, ascending.
struct ContainedCells {
  std::vector<std::vector<Simplex>> edges_by_segment;
  std::vector<std::vector<Simplex>> triangles_by_polygon;  // empty in the plane
};

// Requires: the mesh has every vertex of the domain.
ContainedCells contained_cells(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                               const VertexPlaces& places);

// The domain with the vertices of the mesh, numbered as in the mesh, each segment and polygon cut
// into what it contains.
PiecewiseLinearComplex augmented_complex(const ExactMesh& mesh,
                                         const PiecewiseLinearComplex& complex,
                                         const VertexPlaces& places, const ContainedCells& cells);

// All faces of `size` vertices of the simplices and the listed faces of a mesh.
std::set<Simplex> faces_of_size(const ExactMesh& mesh, std::size_t size);

// Adds all faces of `size` vertices of one simplex.
void insert_faces(const Simplex& simplex, std::size_t size, std::set<Simplex>& faces);

// ---- Contained cells ----
// Which simplices of a mesh a segment or a polygon of the domain contains, by looking at every one.

namespace {

Simplex in_mesh(const VertexPlaces& places, Simplex simplex) {
  for (Vertex& v : simplex) v = places.in_mesh[VertexPlaces::place(v)];
  return simplex;
}

bool lies_on(const PointSet& points, const Simplex& segment, Vertex v) {
  return contains(segment, v) || lies_inside_segment(points.configuration(), segment, v);
}

bool is_coplanar(const PointSet& points, const Simplex& plane, const Simplex& triangle) {
  return std::all_of(triangle.begin(), triangle.end(), [&](Vertex v) {
    return check::is_coplanar(points.configuration(), plane, v);
  });
}

// Has the triangle as much in common with the polygon as with itself?
bool lies_in_polygon(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                     const VertexPlaces& places, const Polygon& polygon, const Simplex& triangle) {
  if (polygon.triangles.empty()) return false;
  if (!is_coplanar(mesh.points, in_mesh(places, polygon.triangles.front()), triangle)) return false;
  Rational area = 0;
  for (const Simplex& own : polygon.triangles) {
    area += common_area(polygon.axes, coordinates(mesh.points, triangle),
                        coordinates(complex.points, own));
  }
  return area == measure(mesh.points, polygon.axes, triangle);
}

}  // namespace

void insert_faces(const Simplex& simplex, std::size_t size, std::set<Simplex>& faces) {
  if (simplex.size() < size) return;
  Simplex subset = first_subset(size);
  do {
    Simplex face;
    for (const Vertex place : subset) face.push_back(simplex[static_cast<std::size_t>(place)]);
    faces.insert(sorted(face));
  } while (next_subset(subset, simplex.size()));
}

std::set<Simplex> faces_of_size(const ExactMesh& mesh, std::size_t size) {
  std::set<Simplex> faces;
  for (const Simplex& simplex : mesh.simplices) insert_faces(simplex, size, faces);
  for (const Simplex& face : mesh.faces) insert_faces(face, size, faces);
  return faces;
}

ContainedCells contained_cells(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                               const VertexPlaces& places) {
  ContainedCells cells;
  const std::set<Simplex> edges = faces_of_size(mesh, 2);
  for (const Simplex& segment : complex.segments) {
    const Simplex ends = in_mesh(places, segment);
    cells.edges_by_segment.emplace_back();
    for (const Simplex& edge : edges) {
      if (lies_on(mesh.points, ends, edge[0]) && lies_on(mesh.points, ends, edge[1])) {
        cells.edges_by_segment.back().push_back(edge);
      }
    }
  }
  if (complex.ambient_dimension() == 2) return cells;
  const std::set<Simplex> triangles = faces_of_size(mesh, 3);
  for (const Polygon& polygon : complex.polygons) {
    cells.triangles_by_polygon.emplace_back();
    for (const Simplex& triangle : triangles) {
      if (lies_in_polygon(mesh, complex, places, polygon, triangle)) {
        cells.triangles_by_polygon.back().push_back(triangle);
      }
    }
  }
  return cells;
}

PiecewiseLinearComplex augmented_complex(const ExactMesh& mesh,
                                         const PiecewiseLinearComplex& complex,
                                         const VertexPlaces& places, const ContainedCells& cells) {
  PiecewiseLinearComplex augmented{mesh.points, {}, {}, complex.hole_seeds, complex.kind};
  for (const auto& edges : cells.edges_by_segment) {
    augmented.segments.insert(augmented.segments.end(), edges.begin(), edges.end());
  }
  std::sort(augmented.segments.begin(), augmented.segments.end());
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
    const Polygon& own = complex.polygons[p];
    Polygon polygon{{}, {}, own.hole_seeds, own.axes, cells.triangles_by_polygon[p]};
    std::set<Vertex> vertices;
    for (const Vertex v : own.vertices) vertices.insert(places.in_mesh[VertexPlaces::place(v)]);
    for (const Simplex& triangle : polygon.triangles) {
      vertices.insert(triangle.begin(), triangle.end());
    }
    for (const Simplex& segment : own.segments) {
      const auto at = std::lower_bound(complex.segments.begin(), complex.segments.end(), segment);
      const auto& edges =
          cells.edges_by_segment[static_cast<std::size_t>(at - complex.segments.begin())];
      polygon.segments.insert(polygon.segments.end(), edges.begin(), edges.end());
      for (const Simplex& edge : edges) vertices.insert(edge.begin(), edge.end());
    }
    std::sort(polygon.segments.begin(), polygon.segments.end());
    polygon.vertices.assign(vertices.begin(), vertices.end());
    augmented.polygons.push_back(std::move(polygon));
  }
  return augmented;
}

// ---- PLC triangulation by definition ----

namespace {

// The simplices, the listed faces, and the vertices of the domain that none of them has.
std::vector<Simplex> listed_simplices(const ExactMesh& mesh, const VertexPlaces& places) {
  std::vector<Simplex> listed = mesh.simplices;
  std::vector<Simplex> faces;
  for (const Simplex& face : mesh.faces) faces.push_back(sorted(face));
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  listed.insert(listed.end(), faces.begin(), faces.end());
  for (const Vertex v : places.in_mesh) {
    if (!places.used[VertexPlaces::place(v)]) listed.push_back({v});
  }
  return listed;
}

// "A simplicial complex."
bool judge_pairs(const ExactMesh& mesh, const VertexPlaces& places, Verdict& verdict) {
  const std::vector<Simplex> listed = listed_simplices(mesh, places);
  bool proper = true;
  for (std::size_t a = 0; a < listed.size(); ++a) {
    for (std::size_t b = a + 1; b < listed.size(); ++b) {
      const auto common = improper_intersection(mesh.points, listed[a], listed[b]);
      if (!common) continue;
      proper = false;
      verdict.add(Rule::kOverlap, {.simplices = {listed[a], listed[b]}, .point = common});
    }
  }
  return proper;
}

std::size_t axis_of(const PointSet& points, const Simplex& segment) {
  std::size_t axis = 0;
  while (points[segment[0]][axis] == points[segment[1]][axis]) ++axis;
  return axis;
}

// "Every linear cell is a union of simplices", of segments and polygons.
void judge_cells(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                 const ContainedCells& cells, VertexSearch& search, Verdict& verdict) {
  for (std::size_t s = 0; s < complex.segments.size(); ++s) {
    const Axes axes = {axis_of(complex.points, complex.segments[s])};
    const Rational whole = measure(complex.points, axes, complex.segments[s]);
    const Rational found = measure(mesh.points, axes, cells.edges_by_segment[s]);
    if (found == whole) continue;
    verdict.add(Rule::kSegmentMissing,
                {.values = {{"length along an axis", whole}, {"length of the edges in it", found}},
                 .domain_cell = complex.segments[s],
                 .nearest = search.to_segment(complex.points[complex.segments[s][0]],
                                              complex.points[complex.segments[s][1]])});
  }
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) {
    const Polygon& polygon = complex.polygons[p];
    const Rational whole = measure(complex.points, polygon.axes, polygon.triangles);
    const Rational found = measure(mesh.points, polygon.axes, cells.triangles_by_polygon[p]);
    if (found == whole) continue;
    verdict.add(Rule::kPolygonNotTiled, {.values = {{"twice the area of its projection", whole},
                                                    {"that of the triangles in it", found}},
                                         .polygon = p});
  }
}

// "|T| = |P|", of the inside. By now no simplex of full dimension crosses a wall.
void judge_inside(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                  const Regions& regions, Verdict& verdict) {
  const bool is_hull = complex.kind == DomainKind::kHull;
  for (const Simplex& simplex : mesh.simplices) {
    std::vector<Point> samples = {barycentre(coordinates(mesh.points, simplex))};
    if (is_hull) {
      for (const Vertex v : simplex) samples.push_back(mesh.points[v]);
    }
    for (const Point& sample : samples) {
      const Where where = regions.locate(sample);
      if (where != Where::kOutside && where != Where::kHole) continue;
      verdict.add(Rule::kOutside, {.simplices = {simplex}, .point = sample});
      break;
    }
  }
  Axes axes(complex.ambient_dimension());
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  Rational whole = 0;
  if (complex.points.dimension() == static_cast<int>(axes.size())) {
    whole = is_hull ? measure_of_hull(complex.points) : measure_of_inside(complex, regions);
  }
  const Rational found = measure(mesh.points, axes, mesh.simplices);
  if (found >= whole) return;
  verdict.add(Rule::kUncovered, {.values = {{"the domain's measure, times d!", whole},
                                            {"that of the simplices", found}}});
}

// Listed triangles and edges that are faces of nothing larger that is listed.
std::size_t count_dangling(const ExactMesh& mesh) {
  std::set<Simplex> larger;
  for (const Simplex& simplex : mesh.simplices) {
    for (const std::size_t size : {std::size_t{2}, std::size_t{3}}) {
      if (size < simplex.size()) insert_faces(simplex, size, larger);
    }
  }
  std::set<Simplex> listed;
  for (const Simplex& face : mesh.faces) {
    listed.insert(sorted(face));
    if (face.size() == 3) insert_faces(face, 2, larger);
  }
  return static_cast<std::size_t>(std::count_if(
      listed.begin(), listed.end(), [&](const Simplex& face) { return !larger.contains(face); }));
}

// "|T| = |P|", of the rest: what is listed in lower dimensions is a face of a simplex or lies in a
// segment or polygon.
void judge_faces(const ExactMesh& mesh, const ContainedCells& cells, Verdict& verdict) {
  const ExactMesh without_faces{mesh.points, mesh.simplices};
  std::set<Simplex> allowed = faces_of_size(without_faces, 2);
  const std::set<Simplex> triangles = faces_of_size(without_faces, 3);
  allowed.insert(triangles.begin(), triangles.end());
  for (const auto& edges : cells.edges_by_segment) allowed.insert(edges.begin(), edges.end());
  for (const auto& tiles : cells.triangles_by_polygon) {
    allowed.insert(tiles.begin(), tiles.end());
    for (const FacetUse& use : facet_uses(tiles)) allowed.insert(use.facet);
  }
  for (const Simplex& face : mesh.faces) {
    if (!allowed.contains(sorted(face))) verdict.add(Rule::kOutside, {.simplices = {face}});
  }
  verdict.dangling = count_dangling(mesh);
}

}  // namespace

void judge_plc_triangulation_by_definition(const ExactMesh& mesh, const Domain& domain,
                                           const Options& options, bool steiner_points_allowed,
                                           const OfAugmented& then, Verdict& verdict) {
  const PiecewiseLinearComplex& complex = domain.complex;
  if (complex.points.empty()) return judge_against_empty_domain(mesh, verdict);
  if (!judge_simplices_in_space(mesh, complex.ambient_dimension(), options.oriented, verdict)) {
    return;
  }
  VertexPlaces places = match_vertices(mesh, complex);
  VertexSearch search(mesh, places.used);
  if (!judge_vertices(mesh, complex, places, steiner_points_allowed, search, verdict)) return;
  locate_steiner_points(mesh, complex, places);
  verdict.steiner_points = count_steiner_points(places);
  if (!judge_pairs(mesh, places, verdict)) return;
  const ContainedCells cells = contained_cells(mesh, complex, places);
  judge_cells(mesh, complex, cells, search, verdict);
  if (!is_triangulation_so_far(verdict)) return;
  judge_inside(mesh, complex, Regions(complex), verdict);
  judge_faces(mesh, cells, verdict);
  if (mesh.neighbors) judge_neighbors(mesh, facet_uses(mesh.simplices), verdict);
  if (is_triangulation_so_far(verdict)) {
    then(augmented_complex(mesh, complex, places, cells));
  }
}

}  // namespace circumspect::check
