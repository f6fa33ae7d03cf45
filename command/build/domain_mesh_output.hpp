// Writes meshes of domains to files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "command/build/constrained_constructions.hpp"
#include "oracle/formats/json.hpp"

namespace circumspect::cli {

// The endings of files that can be written: ".ele", formats of elements, ".json".
std::vector<std::string_view> endings_of_domain_meshes();

// Why the vertices of this mesh cannot be counted from `first_index`; empty if they can.
std::string numbering_fault(const DomainMesh& mesh, Vertex first_index);

// What is wrong with writing this mesh there; empty if nothing is. An .ele alone, as "-" gets,
// holds neither what dangles nor points that the domain does not have.
std::string domain_mesh_fault(const std::string& path, const DomainMesh& mesh);

// OUT.ele, and beside it OUT.node, OUT.face (in space) and OUT.edge; or all in one file of another
// ending; OUT.obj and OUT.ply have what can be seen, the surface and what dangles; "-": the .ele on
// stdout. Indices are counted from `first_index`. Requires: numbering_fault is empty. Returns an
// error message, or an empty string.
std::string write_domain_mesh(const std::string& path, const DomainMesh& mesh, Vertex first_index);

// The files that write_domain_mesh writes.
std::vector<std::string> files_of_domain_mesh(const std::string& path, const DomainMesh& mesh);

// The points, the simplices, and for faces the dangling triangles and edges.
formats::JsonFile json_file(const DomainMesh& mesh, Vertex first_index);

}  // namespace circumspect::cli
