#include "oracle/judge/domain/contained_cells.hpp"

#include <algorithm>
#include <array>

#include "oracle/judge/domain/coplanar.hpp"
#include "oracle/judge/domain/measures.hpp"
#include "reference/kernel/complex/simplex.hpp"

namespace circumspect::check {
namespace {

Simplex in_mesh(const VertexPlaces& places, Simplex simplex) {
  for (Vertex& v : simplex) v = places.in_mesh[VertexPlaces::place(v)];
  return simplex;
}

bool lies_on(const PointSet& points, const Simplex& segment, Vertex v) {
  return contains(segment, v) || lies_within_edge(points, segment[0], segment[1], v);
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

}  // namespace circumspect::check
