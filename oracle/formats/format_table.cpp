#include <array>

#include "oracle/formats/abaqus.hpp"
#include "oracle/formats/bytes/packed.hpp"
#include "oracle/formats/dolfin.hpp"
#include "oracle/formats/exodus.hpp"
#include "oracle/formats/foreign_file.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/freefem.hpp"
#include "oracle/formats/geojson.hpp"
#include "oracle/formats/gmsh.hpp"
#include "oracle/formats/json.hpp"
#include "oracle/formats/medit.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/meshb.hpp"
#include "oracle/formats/mfem.hpp"
#include "oracle/formats/nastran.hpp"
#include "oracle/formats/netgen.hpp"
#include "oracle/formats/npy.hpp"
#include "oracle/formats/obj.hpp"
#include "oracle/formats/off.hpp"
#include "oracle/formats/ply.hpp"
#include "oracle/formats/point_lists.hpp"
#include "oracle/formats/poly.hpp"
#include "oracle/formats/poly_mesh.hpp"
#include "oracle/formats/qhull.hpp"
#include "oracle/formats/stl.hpp"
#include "oracle/formats/su2.hpp"
#include "oracle/formats/tet.hpp"
#include "oracle/formats/tetgen.hpp"
#include "oracle/formats/ucd.hpp"
#include "oracle/formats/unv.hpp"
#include "oracle/formats/vtk.hpp"
#include "oracle/formats/vtu.hpp"
#include "oracle/formats/wkt.hpp"
#include "oracle/formats/xdmf.hpp"

namespace circumspect::formats {

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
    if (faces.simplices.size_of(i) == 3) continue;
    return tl::unexpected(
        FormatError{source.name, faces.lines[i], "a triangle",
                    "a face with " + std::to_string(faces.simplices.size_of(i)) + " vertices"});
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
  return Contents{std::move(file->simplices), std::move(points), file->faces.simplices.lists()};
}

// The points of x.1.poly may be in x.1.node.
PointsElsewhere points_beside(const Source& source, NumberReading reading, std::string& name) {
  return [&source, reading, &name]() -> Result<PointFile> {
    const std::string& poly = source.name;
    name = beside(poly, ".node");
    if (!exists(name)) {
      return tl::unexpected(FormatError{name, 0, "a file with the points of " + poly,
                                        "no file of that name, and no points in " + poly});
    }
    const Result<Source> points = load_unpacked(name);
    if (!points) return tl::unexpected(points.error());
    return explained(read_node(*points, reading), *points);
  };
}

using Reader = Result<DomainFile> (*)(const Source&, NumberReading, const PointsElsewhere&);

Result<DomainFile> with_points(Reader read, const Source& source, NumberReading reading) {
  std::string points_name;
  Result<DomainFile> file = read(source, reading, points_beside(source, reading, points_name));
  if (file) file->points_name = std::move(points_name);
  return file;
}

Result<DomainFile> domain_of_poly(const Source& source, NumberReading reading) {
  return with_points(read_poly, source, reading);
}

Result<DomainFile> domain_of_smesh(const Source& source, NumberReading reading) {
  return with_points(read_smesh, source, reading);
}

Result<DomainFile> domain_of_off(const Source& source, NumberReading reading) {
  Result<OffFile> off = read_off(source, reading);
  if (!off) return tl::unexpected(off.error());
  DomainFile file;
  file.name = source.name;
  Status status = take_points(file, std::move(off->points), 0);
  if (status) status = add_faces(file, off->faces);
  if (!status) return tl::unexpected(status.error());
  return file;
}

bool is_node(const Beginning& file) {
  return file.is_number() && !file.is_list() && file.on_second_line != 1;
}
bool is_xyz(const Beginning& file) { return file.is_number() && file.is_list(); }
bool is_qhull(const Beginning& file) {
  return file.is_number() && !file.is_list() && file.on_second_line == 1;
}
bool is_ele(const Beginning& file) { return file.has_points && file.on_first_line > 1; }
bool is_qhull_i(const Beginning& file) { return file.has_points && file.on_first_line == 1; }

bool is_json(const Beginning& file) { return begins_with(file.text, '{'); }
bool is_off(const Beginning& file) { return is_off_keyword(file.first_token); }
bool is_medit(const Beginning& file) { return is_medit_keyword(file.first_token); }
bool begins_as_meshb(const Beginning& file) { return is_meshb(file.text); }
bool is_gmsh(const Beginning& file) { return is_gmsh_keyword(file.first_token); }
bool begins_as_vtk(const Beginning& file) { return is_vtk(file.text); }
bool begins_as_vtu(const Beginning& file) { return is_vtu(file.text); }
bool begins_as_dolfin(const Beginning& file) { return is_dolfin(file.text); }
bool begins_as_xdmf(const Beginning& file) { return is_xdmf(file.text); }
bool begins_as_su2(const Beginning& file) { return is_su2(file.text); }
bool is_tet(const Beginning& file) { return file.second_token == "vertices"; }
bool is_obj(const Beginning& file) { return is_obj_keyword(file.first_token); }
bool is_ply(const Beginning& file) { return file.first_token == "ply"; }
bool begins_as_npy(const Beginning& file) { return is_npy(file.text); }
bool begins_as_npz(const Beginning& file) { return is_npz(file.text); }
bool begins_as_geojson(const Beginning& file) { return is_geojson(file.text); }
bool is_geojson_object(const Beginning& file) {
  return begins_with(file.text, '{') && is_geojson(file.text);
}
bool begins_as_wkt(const Beginning& file) { return is_wkt(file.text); }
bool is_stl(const Beginning& file) {
  return is_word(file.first_token, "solid") || is_binary_stl(file.text);
}

// The order is that of messages and of the help.
constexpr std::array kFormats = {
    Format{.endings = {".node"},
           .is_taken_for = is_node,
           .points = points_of_node,
           .simplices_beside = ".ele"},
    Format{.endings = {".ele"},
           .is_taken_for = is_ele,
           .mesh = mesh_of_ele,
           .points_beside = ".node",
           .aside = "points in the .node beside it"},
    Format{.endings = {".neigh"}},
    Format{.endings = {".poly"}, .domain = domain_of_poly},
    Format{.endings = {".smesh"}, .domain = domain_of_smesh},
    Format{
        .endings = {".json"}, .is_told = is_json, .points = points_of_json, .mesh = mesh_of_json},
    Format{.endings = {".off"},
           .is_told = is_off,
           .points = points_of_off,
           .mesh = mesh_of_off,
           .domain = domain_of_off},
    Format{.endings = {".stl"},
           .is_told = is_stl,
           .domain = read_stl,
           .elements = read_stl_elements,
           .is_surface = true},
    Format{.endings = {".geojson", ".json"},
           .is_told = begins_as_geojson,
           .is_meant = is_geojson_object,
           .domain = read_geojson},
    Format{.endings = {".wkt"}, .is_told = begins_as_wkt, .domain = read_wkt},
    Format{.endings = {".mesh"}, .is_told = is_medit, .elements = read_medit, .write = write_medit},
    Format{.endings = {".meshb"}, .is_told = begins_as_meshb, .elements = read_meshb},
    Format{.endings = {".msh"}, .is_told = is_gmsh, .elements = read_gmsh, .write = write_gmsh},
    Format{.endings = {".mesh"}, .is_told = is_mfem, .is_meant = is_mfem, .elements = read_mfem},
    Format{.endings = {".msh"}, .is_meant = is_freefem, .elements = read_freefem},
    Format{.endings = {".vtk"}, .is_told = begins_as_vtk, .elements = read_vtk},
    Format{.endings = {".xdmf", ".xmf"}, .is_told = begins_as_xdmf, .elements = read_xdmf},
    Format{.endings = {}, .is_told = begins_as_dolfin, .elements = read_dolfin},
    Format{.endings = {".vtu", ".vtp"},
           .is_told = begins_as_vtu,
           .elements = read_vtu,
           .write = write_vtu},
    Format{.endings = {".tet", ".tetrahedra"},
           .is_told = is_tet,
           .elements = read_tet,
           .are_cells = true},
    Format{.endings = {".inp", ".msh"},
           .is_told = is_abaqus,
           .is_meant = is_abaqus,
           .elements = read_abaqus,
           .includes = abaqus_inclusion},
    Format{.endings = {".ucd", ".inp"}, .is_meant = is_ucd, .elements = read_ucd},
    Format{.endings = {".bdf", ".nas"},
           .is_told = is_nastran,
           .elements = read_nastran,
           .includes = nastran_inclusion},
    Format{.endings = {".unv"}, .is_told = is_unv, .elements = read_unv},
    Format{.endings = {".e", ".exo"}, .is_told = is_exodus, .elements = read_exodus},
    Format{.endings = {".vol"}, .is_told = is_netgen, .elements = read_netgen},
    Format{.endings = {".su2"}, .is_told = begins_as_su2, .elements = read_su2},
    Format{.endings = {".foam"},
           .elements = read_poly_mesh,
           .are_cells = true,
           .aside = "or the folder of a case of OpenFOAM"},
    Format{.endings = {".obj"}, .is_told = is_obj, .elements = read_obj, .write = write_obj},
    Format{.endings = {".ply"},
           .is_told = is_ply,
           .domain = read_ply,
           .elements = read_ply_elements,
           .write = write_ply},
    Format{.endings = {".xyz"}, .is_taken_for = is_xyz, .points = points_of_xyz},
    Format{.endings = {".csv"}, .points = points_of_csv},
    Format{.endings = {".npy"},
           .is_told = begins_as_npy,
           .points = points_of_npy,
           .mesh = mesh_of_npy,
           .aside = "with --points"},
    Format{.endings = {".npz"},
           .is_told = begins_as_npz,
           .points = points_of_npz,
           .mesh = mesh_of_npz},
    Format{.endings = {".qhull"},
           .is_taken_for = is_qhull,
           .points = points_of_qhull,
           .simplices_beside = ".qhull-i"},
    Format{.endings = {".qhull-i"},
           .is_taken_for = is_qhull_i,
           .mesh = mesh_of_qhull,
           .points_beside = ".qhull"},
};

}  // namespace

std::span<const Format> formats() { return kFormats; }

}  // namespace circumspect::formats
