// The formats of meshes and of points, and formats of other programs that are recognized but not
// read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/formats/mesh_files.hpp"

namespace circumspect::formats {

// ---- Other kinds ----
// Formats of other programs that are not read, and how to convert their files.

// What a file with this extension (".step") is and which command converts it, for a message "found
// …" where a mesh or points were expected; nothing if the extension is unknown. A domain (".poly")
// is one of these.
std::optional<std::string> other_kind(std::string_view extension);

// The command that converts a file that meshio reads to .vtu; `format`: meshio's name of the
// format, if the file's name does not tell.
std::string read_by_meshio(const std::string& in, const std::string& format = "",
                           std::string_view packages = "python3-meshio");

// The same for files that are read, but not as a domain: meshes (".ele") and points (".node").
std::optional<std::string> kind_of_mesh(std::string_view extension);

// ---- Mesh formats ----
// The formats of meshes and of points: which reader reads the files of an extension, and which
// format a file has whose name does not tell.

// The content of one file of a mesh.
struct Contents {
  SimplexFile simplices = {};
  std::optional<RawPoints> points = {};
  std::vector<Simplex> faces = {};  // listed beside the simplices
  std::vector<std::string> notes = {};
};

// The content of files with an extension, and the files beside them.
struct MeshFormat {
  std::string_view extension;
  Result<RawPoints> (*points)(const Source&, NumberReading);
  Result<Contents> (*mesh)(const Source&, NumberReading);
  std::string_view points_beside;     // the extension of the file with the points of this mesh
  std::string_view simplices_beside;  // the extension of the file with simplices of these points
};

// The format whose files have this extension; null if there is none.
const MeshFormat* format_of(std::string_view extension);

// The format of points in a file whose name does not tell; null if the file does not begin with a
// number, either.
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
