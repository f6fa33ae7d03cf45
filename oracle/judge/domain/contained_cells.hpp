// Which simplices of a mesh a segment or a polygon of the domain contains, by looking at every one.
#pragma once

#include <set>

#include "oracle/judge/domain/vertex_places.hpp"

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

}  // namespace circumspect::check
