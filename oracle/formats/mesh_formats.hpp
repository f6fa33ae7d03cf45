// The formats of meshes and of points, and formats of other programs that are recognized but not read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/formats/mesh_files.hpp"

namespace circumspect::formats {

// ---- Other kinds ----
// Files of other programs that are not read, and how to make one of them that is.

// What a file of this extension (".step") is and which command converts it, for a message "found …" where a mesh
// or points were expected; none if nothing is known of it. A domain (".poly") is one of these.
std::optional<std::string> other_kind(std::string_view extension);

// The command that makes a .vtu of what meshio reads; `format`: what meshio calls it, if the name
// does not say so.
std::string read_by_meshio(const std::string& in, const std::string& format = "",
                           std::string_view packages = "python3-meshio");

// The same for what is read, but not as a domain: meshes (".ele") and points (".node").
std::optional<std::string> kind_of_mesh(std::string_view extension);

// ---- Mesh formats ----
// The formats of meshes and of points: which reader reads the files of an extension, and which format a file
// is of whose name does not say it.

// What one file of a mesh holds.
struct Contents {
  SimplexFile simplices = {};
  std::optional<RawPoints> points = {};
  std::vector<Simplex> faces = {};  // listed beside the simplices
  std::vector<std::string> notes = {};
};

// What files of an extension hold, and what stands beside them.
struct MeshFormat {
  std::string_view extension;
  Result<RawPoints> (*points)(const Source&, NumberReading);
  Result<Contents> (*mesh)(const Source&, NumberReading);
  std::string_view points_beside;     // the extension of the file with the points of this mesh
  std::string_view simplices_beside;  // the extension of the file with simplices of these points
};

// The format whose files have this extension; null if there is none.
const MeshFormat* format_of(std::string_view extension);

// The format of points in a file whose name does not say it; null if it begins with no number, either.
const MeshFormat* sniff_points(const Source& source);

// The same for a mesh; null if it cannot be known. A list of simplices counts only where the user
// says which points it is about.
const MeshFormat* sniff_mesh(const Source& source, bool has_points);

// The extensions of files that hold points, and of those that hold simplices: ".node, .json".
std::string kinds_of_points();
std::string kinds_of_meshes();

// The first word of a text; empty if there is none.
std::string_view first_word(const Source& source);

}  // namespace circumspect::formats
