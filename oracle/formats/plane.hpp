// Planar files whose points have three coordinates: one rule for all formats, which docs/formats.md
// explains to users.
//
// Most programs write a planar mesh as one in space, with z = 0. So the third coordinate is left
// out, with a note, if it is exactly the same for all points and nothing in the file needs space,
// such as a tetrahedron or a hole seed of a polyhedron. If another coordinate is constant, it
// stays, because no file says which two coordinates the plane should get.
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
// equal to `height` if that is given; else does nothing. needs_space says whether the simplices
// need space.
void leave_out_height(MeshFile& file, const std::optional<Rational>& height);

// Restores the coordinate that was left out.
void put_back_height(Mesh& mesh, const Rational& height);

std::string note_of_height(const std::string& points_name, const Rational& height);

// Does a mesh of these simplices need space, wherever its points are? A file may state how many
// vertices each simplex has without listing any, as TetGen does for a mesh that has only faces.
bool needs_space(const SimplexFile& simplices, const std::vector<Simplex>& faces);

// The same domain in the plane: the edges of its polygons are segments, each once, and its polygons
// are its faces. Nothing if it has to stay in space. Adds no note.
std::optional<DomainFile> in_plane(const DomainFile& file);

// The domain as a planar one if possible, with the note and the unchanged domain.
DomainFile taken_for_plane(DomainFile file);

// The domain with all coordinates of the file; the second function does this only if there should
// be `dimension` of them.
DomainFile as_it_stands(DomainFile file);
DomainFile of_dimension(DomainFile file, std::size_t dimension);

}  // namespace circumspect::formats
