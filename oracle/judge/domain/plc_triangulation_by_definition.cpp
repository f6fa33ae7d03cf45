// Definitions 4.4 and 4.5, word for word, with measures for "is a union of".
#include <algorithm>
#include <numeric>

#include "oracle/judge/domain/contained_cells.hpp"
#include "oracle/judge/domain/measures.hpp"
#include "oracle/judge/domain/plc_triangulation.hpp"
#include "oracle/judge/points/neighbors.hpp"
#include "reference/kernel/complex/proper_intersection.hpp"

namespace circumspect::check {
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
