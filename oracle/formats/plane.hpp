// Files of the plane whose points have three coordinates: one rule for all formats. docs/formats.md
// has it for users.
//
// Most programs write a mesh of the plane as one in space, z = 0. So the third coordinate is left
// out, and a note says so, if it is exactly the same for all points and nothing in the file needs
// space: a tetrahedron, or a hole seed of a polyhedron. Another constant coordinate stays: which
// two coordinates of the plane the others would be, no file says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kernel/exact/number.hpp"
#include "kernel/exact/point.hpp"
#include "oracle/formats/domain_file.hpp"
#include "oracle/formats/mesh_files.hpp"

namespace circumspect::formats {

// The third coordinate, if there are points, all have three, and it is exactly the same for all.
std::optional<Rational> common_height(const std::vector<Point>& points);

// Leaves out the third coordinate of a mesh, and notes it, if it is the same for all points, and
// `height` if that is given; else nothing. Whether the simplices need space, needs_space says.
void leave_out_height(MeshFile& file, const std::optional<Rational>& height);

// Puts back what was left out.
void put_back_height(Mesh& mesh, const Rational& height);

std::string note_of_height(const std::string& points_name, const Rational& height);

// Is a mesh of these simplices one of space, wherever its points are? `vertices`: of each, if the
// file says so of simplices that it does not list, as TetGen does of a mesh that has only faces.
bool needs_space(const std::vector<Simplex>& simplices, std::size_t vertices,
                 const std::vector<Simplex>& faces);

// The same domain in the plane: the edges of its polygons are segments, each once, and its polygons
// are its faces. None if it has to stay in space. The result is not noted.
std::optional<DomainFile> in_plane(const DomainFile& file);

// A domain that is taken for one in the plane, where it can be: with the note, and with the file as
// it stands.
DomainFile taken_for_plane(DomainFile file);

// The file with all coordinates that it has; the same only where these are to be `dimension` ones.
DomainFile as_it_stands(DomainFile file);
DomainFile of_dimension(DomainFile file, std::size_t dimension);

}  // namespace circumspect::formats
