// Is a list of simplices a simplicial complex? Book: Definition 2.1, quoted in Section 4.1.
#pragma once

#include <vector>

#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::definition {

// Each of the mesh's simplices is what its list says: `size` different points that are affinely
// independent, and no two are the same set (triangulation.unknown-vertex, simplex.wrong-dimension,
// simplex.repeated-vertex, simplex.degenerate, complex.duplicate-simplex). True if all are.
bool judge_each_simplex(const ExactMesh& mesh, std::size_t size, Verdict& verdict);

// The same of the triangles and edges that are listed beside, which have 2 to `most` vertices and
// may be listed again.
bool judge_each_face(const ExactMesh& mesh, std::size_t most, Verdict& verdict);

// Any two of them meet in a common face or not at all (complex.overlap). True if they do.
// Their faces then do so too, because a point of a simplex is in the relative interior of one face.
bool judge_every_two(const PointSet& points, const std::vector<Simplex>& simplices,
                     Verdict& verdict);

}  // namespace circumspect::definition
