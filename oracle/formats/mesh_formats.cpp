#include "oracle/formats/mesh_formats.hpp"

#include <algorithm>
#include <array>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/element_formats.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/npy.hpp"
#include "oracle/formats/ply.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/formats/surface_formats.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/formats/vtk.hpp"

namespace circumspect::formats {

namespace {

struct OtherKind {
  std::string_view extension;
  std::string_view what;
  // The command that converts it, with IN for its name without the extension; or the packages that
  // meshio needs for it.
  std::string_view command;
};

constexpr std::array kOtherKinds = {
    OtherKind{".meshb", "Medit's binary form", "python3-meshio"},
    OtherKind{".geo", "a geometry of Gmsh", "gmsh -3 IN.geo -o IN.msh"},
    OtherKind{".step", "a STEP geometry", "gmsh -3 IN.step -o IN.msh"},
    OtherKind{".stp", "a STEP geometry", "gmsh -3 IN.stp -o IN.msh"},
    OtherKind{".iges", "an IGES geometry", "gmsh -3 IN.iges -o IN.msh"},
    OtherKind{".igs", "an IGES geometry", "gmsh -3 IN.igs -o IN.msh"},
    OtherKind{".brep", "a BREP geometry", "gmsh -3 IN.brep -o IN.msh"},
    OtherKind{".inp", "a mesh of Abaqus", "python3-meshio"},
    OtherKind{".bdf", "a mesh of Nastran", "python3-meshio"},
    OtherKind{".nas", "a mesh of Nastran", "python3-meshio"},
    OtherKind{".unv", "a mesh of I-DEAS", "gmsh -0 IN.unv -o IN.msh"},
    OtherKind{".med", "a mesh of Salome", "python3-meshio and python3-h5py"},
    OtherKind{".cgns", "a CGNS mesh", "python3-meshio and python3-h5py"},
    OtherKind{".xdmf", "an XDMF mesh", "python3-meshio and python3-h5py"},
    OtherKind{".e", "an Exodus mesh", "python3-meshio and python3-netcdf4"},
    OtherKind{".exo", "an Exodus mesh", "python3-meshio and python3-netcdf4"},
    OtherKind{".h5m", "a MOAB mesh", "python3-meshio and python3-h5py"},
    OtherKind{".su2", "a mesh of SU2", "python3-meshio"},
    OtherKind{".vol", "a mesh of Netgen", "python3-meshio"},
    OtherKind{".pvtu", "a list of .vtu files", "pass one of these"},
    OtherKind{".vtm", "a list of VTK's files", "pass one of these"},
    OtherKind{".3mf", "a 3MF model", "write it as STL or OBJ"},
    OtherKind{".gltf", "a glTF model", "write it as PLY or OBJ"},
    OtherKind{".glb", "a glTF model", "write it as PLY or OBJ"},
    OtherKind{".wrl", "a VRML model", "write it as PLY or OBJ"},
    OtherKind{".x3d", "an X3D model", "write it as PLY or OBJ"},
    OtherKind{".poly", "a domain", "inspect IN.poly, or check MESH --domain IN.poly"},
    OtherKind{".smesh", "a domain", "inspect IN.smesh, or check MESH --domain IN.smesh"},
    OtherKind{".stl", "a surface, which is a domain",
              "inspect IN.stl, or check MESH --domain IN.stl"},
};

}  // namespace

std::optional<std::string> other_kind(std::string_view extension) {
  const auto* const found =
      std::find_if(kOtherKinds.begin(), kOtherKinds.end(),
                   [extension](const OtherKind& kind) { return kind.extension == extension; });
  if (found == kOtherKinds.end()) return std::nullopt;
  const std::string in = "IN" + std::string(extension);
  return std::string(found->what) + " (" +
         (found->command.starts_with("python3-") ? read_by_meshio(in, "", found->command)
                                                 : std::string(found->command)) +
         ")";
}

std::string read_by_meshio(const std::string& in, const std::string& format,
                           std::string_view packages) {
  const std::string as = format.empty() ? "" : ", file_format=\"" + format + "\"";
  return "with Debian's " + std::string(packages) + ": python3 -c 'import meshio; meshio.read(\"" +
         in + "\"" + as + ").write(\"OUT.vtu\")'";
}

// ---- Mesh formats ----

namespace {

Result<RawPoints> points_alone(const Source& source, Result<PointFile> file) {
  if (!file) return tl::unexpected(file.error());
  return RawPoints{std::move(*file), {}, source.name};
}

Result<Contents> simplices_alone(Result<SimplexFile> file) {
  if (!file) return tl::unexpected(file.error());
  return Contents{std::move(*file), {}};
}

Result<RawPoints> points_of_node(const Source& source, NumberReading reading) {
  return points_alone(source, read_node(source, reading));
}

Result<RawPoints> points_of_qhull(const Source& source, NumberReading reading) {
  return points_alone(source, read_qhull_points(source, reading));
}

Result<RawPoints> points_of_off(const Source& source, NumberReading reading) {
  Result<OffFile> file = read_off(source, reading);
  if (!file) return tl::unexpected(file.error());
  return points_alone(source, std::move(file->points));
}

Result<RawPoints> points_of_json(const Source& source, NumberReading reading) {
  Result<JsonFile> file = read_json(source, reading);
  if (!file) return tl::unexpected(file.error());
  return RawPoints{std::move(file->points), std::move(file->weights), source.name};
}

Result<Contents> mesh_of_ele(const Source& source, NumberReading reading) {
  return simplices_alone(read_ele(source, reading));
}

Result<Contents> mesh_of_qhull(const Source& source, NumberReading) {
  return simplices_alone(read_qhull_simplices(source));
}

Result<RawPoints> points_of_npy(const Source& source, NumberReading) {
  return points_alone(source, read_npy_points(source));
}

Result<RawPoints> points_of_xyz(const Source& source, NumberReading reading) {
  return points_alone(source, read_xyz(source, reading));
}

Result<RawPoints> points_of_csv(const Source& source, NumberReading reading) {
  return points_alone(source, read_csv(source, reading));
}

Result<Contents> mesh_of_npy(const Source& source, NumberReading) {
  return simplices_alone(read_npy_simplices(source));
}

Result<RawPoints> points_of_npz(const Source& source, NumberReading) {
  const Result<Source> points = array_of_npz(source, "points");
  if (!points) return tl::unexpected(points.error());
  return points_alone(source, read_npy_points(*points));
}

// Its points, too, are in the archive.
Result<Contents> mesh_of_npz(const Source& source, NumberReading reading) {
  const Result<Source> simplices = array_of_npz(source, "simplices");
  if (!simplices) return tl::unexpected(simplices.error());
  Result<Contents> contents = simplices_alone(read_npy_simplices(*simplices));
  if (!contents) return contents;
  Result<RawPoints> points = points_of_npz(source, reading);
  if (!points) return tl::unexpected(points.error());
  contents->points = std::move(*points);
  return contents;
}

Result<Contents> mesh_of_off(const Source& source, NumberReading reading) {
  Result<OffFile> file = read_off(source, reading);
  if (!file) return tl::unexpected(file.error());
  const SimplexFile& faces = file->faces;
  for (std::size_t i = 0; i < faces.simplices.size(); ++i) {
    if (faces.simplices[i].size() == 3) continue;
    return tl::unexpected(
        FormatError{source.name, faces.lines[i], "a triangle",
                    "a face with " + std::to_string(faces.simplices[i].size()) + " vertices"});
  }
  RawPoints points{std::move(file->points), {}, source.name};
  return Contents{std::move(file->faces), std::move(points)};
}

Result<Contents> mesh_of_json(const Source& source, NumberReading reading) {
  Result<JsonFile> file = read_json(source, reading);
  if (!file) return tl::unexpected(file.error());
  if (!file->has_simplices) {
    return tl::unexpected(
        FormatError{source.name, 0, "a mesh, with the key \"simplices\"", "points alone"});
  }
  RawPoints points{std::move(file->points), std::move(file->weights), source.name};
  return Contents{std::move(file->simplices), std::move(points), std::move(file->faces.simplices)};
}

// Files of elements.
using ElementReader = Result<ElementFile> (*)(const Source&, NumberReading);

template <ElementReader read>
Result<RawPoints> points_of_elements(const Source& source, NumberReading reading) {
  Result<ElementFile> file = read(source, reading);
  if (!file) return tl::unexpected(file.error());
  return points_alone(source, std::move(file->points));
}

// The simplices of the highest dimension; those of lower dimensions are listed beside them.
template <ElementReader read>
Result<Contents> mesh_of_elements(const Source& source, NumberReading reading) {
  Result<ElementFile> file = read(source, reading);
  if (!file) return tl::unexpected(file.error());
  const Status simplices = check_simplices(*file, source.name);
  if (!simplices) return tl::unexpected(simplices.error());
  Contents contents;
  TopElements top = top_elements(*file);
  contents.simplices = std::move(top.simplices);
  contents.faces = std::move(top.faces);
  contents.points = RawPoints{std::move(file->points), {}, source.name};
  contents.notes = std::move(file->notes);
  return contents;
}

constexpr std::array kFormats = {
    MeshFormat{".node", points_of_node, nullptr, "", ".ele"},
    MeshFormat{".ele", nullptr, mesh_of_ele, ".node", ""},
    MeshFormat{".neigh", nullptr, nullptr, "", ""},
    MeshFormat{".json", points_of_json, mesh_of_json, "", ""},
    MeshFormat{".off", points_of_off, mesh_of_off, "", ""},
    MeshFormat{".mesh", points_of_elements<read_medit>, mesh_of_elements<read_medit>, "", ""},
    MeshFormat{".msh", points_of_elements<read_gmsh>, mesh_of_elements<read_gmsh>, "", ""},
    MeshFormat{".vtk", points_of_elements<read_vtk>, mesh_of_elements<read_vtk>, "", ""},
    MeshFormat{".vtu", points_of_elements<read_vtu>, mesh_of_elements<read_vtu>, "", ""},
    MeshFormat{".vtp", points_of_elements<read_vtu>, mesh_of_elements<read_vtu>, "", ""},
    MeshFormat{".tet", points_of_elements<read_tet>, mesh_of_elements<read_tet>, "", ""},
    MeshFormat{".tetrahedra", points_of_elements<read_tet>, mesh_of_elements<read_tet>, "", ""},
    MeshFormat{".obj", points_of_elements<read_obj>, mesh_of_elements<read_obj>, "", ""},
    MeshFormat{".ply", points_of_elements<read_ply_elements>, mesh_of_elements<read_ply_elements>,
               "", ""},
    MeshFormat{".xyz", points_of_xyz, nullptr, "", ""},
    MeshFormat{".csv", points_of_csv, nullptr, "", ""},
    MeshFormat{".npy", points_of_npy, mesh_of_npy, "", ""},
    MeshFormat{".npz", points_of_npz, mesh_of_npz, "", ""},
    MeshFormat{".qhull", points_of_qhull, nullptr, "", ".qhull-i"},
    MeshFormat{".qhull-i", nullptr, mesh_of_qhull, ".qhull", ""},
};

// The extensions of all files for which a reader of this kind exists: ".node, .json".
template <class Reader>
std::string kinds(Reader MeshFormat::*reader) {
  std::string names;
  for (const MeshFormat& format : kFormats) {
    if (format.*reader == nullptr) continue;
    names += (names.empty() ? "" : ", ") + std::string(format.extension);
  }
  return names;
}

bool looks_like_json(const Source& source) {
  const std::size_t first = source.text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string::npos && source.text[first] == '{';
}

// How many tokens are on the first two non-empty lines, and the first two of them.
struct Beginning {
  explicit Beginning(const Source& source) {
    Lines lines(source);
    if (!lines.next()) return;
    first_token = lines.tokens()[0];
    on_first_line = lines.size();
    if (on_first_line > 1) second_token = lines.tokens()[1];
    // "points dimension [attributes [markers]]" announces an index and so many numbers for each.
    columns_announced = 1;
    for (std::size_t column = 1; column < on_first_line && column < 4; ++column) {
      Vertex number = 0;
      const bool is_count = parse_integer(lines.tokens()[column], number) == std::errc();
      columns_announced += is_count && number >= 0 ? count_of(number) : 0;
    }
    if (lines.next()) on_second_line = lines.size();
  }

  // A point on each line, from the first on, and no header?
  bool is_list() const {
    return on_first_line > 1 && on_first_line == on_second_line &&
           columns_announced != on_second_line;
  }

  std::string_view first_token;
  std::string_view second_token;
  std::size_t on_first_line = 0;
  std::size_t on_second_line = 0;
  std::size_t columns_announced = 0;  // if the first line is the header of a .node file
};

// The format of a file that says by its first bytes what it is; null if it does not.
const MeshFormat* sniff_beginning(const Source& source, const Beginning& beginning) {
  if (is_npy(source.text)) return format_of(".npy");
  if (is_npz(source.text)) return format_of(".npz");
  if (is_vtk(source.text)) return format_of(".vtk");
  if (is_vtu(source.text)) return format_of(".vtu");
  if (looks_like_json(source)) return format_of(".json");
  if (is_off_keyword(beginning.first_token)) return format_of(".off");
  if (is_medit_keyword(beginning.first_token)) return format_of(".mesh");
  if (is_gmsh_keyword(beginning.first_token)) return format_of(".msh");
  if (beginning.first_token == "ply") return format_of(".ply");
  if (beginning.second_token == "vertices") return format_of(".tet");
  return is_obj_keyword(beginning.first_token) ? format_of(".obj") : nullptr;
}

}  // namespace

const MeshFormat* format_of(std::string_view extension) {
  const auto* const found =
      std::find_if(kFormats.begin(), kFormats.end(),
                   [extension](const MeshFormat& format) { return format.extension == extension; });
  return found == kFormats.end() ? nullptr : found;
}

const MeshFormat* sniff_points(const Source& source) {
  const Beginning beginning(source);
  if (const MeshFormat* const format = sniff_beginning(source, beginning)) return format;
  const bool begins_with_number =
      beginning.first_token.find_first_of("0123456789") <= 1;  // there may be a sign
  if (!beginning.first_token.empty() && !begins_with_number) return nullptr;
  if (beginning.is_list()) return format_of(".xyz");
  return format_of(beginning.on_second_line == 1 ? ".qhull" : ".node");
}

const MeshFormat* sniff_mesh(const Source& source, bool has_points) {
  const Beginning beginning(source);
  if (const MeshFormat* const format = sniff_beginning(source, beginning)) return format;
  if (!has_points || beginning.on_first_line == 0) return nullptr;
  return format_of(beginning.on_first_line == 1 ? ".qhull-i" : ".ele");
}

std::optional<std::string> kind_of_mesh(std::string_view extension) {
  const MeshFormat* const format = format_of(extension);
  if (format == nullptr || (format->mesh == nullptr && format->points == nullptr)) {
    return std::nullopt;
  }
  if (format->mesh == nullptr) return "points alone (a domain has segments and polygons as well)";
  return "a mesh (the domain is what the program was given that made the mesh)";
}

std::string kinds_of_points() { return kinds(&MeshFormat::points); }

std::string kinds_of_meshes() { return kinds(&MeshFormat::mesh); }

std::string_view first_word(const Source& source) { return Beginning(source).first_token; }

}  // namespace circumspect::formats
