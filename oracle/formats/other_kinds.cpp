#include "oracle/formats/other_kinds.hpp"

#include <algorithm>
#include <array>

namespace circumspect::formats {

namespace {

struct OtherKind {
  std::string_view ending;
  std::string_view what;
  // The command that converts it, with IN for its name without its ending; or the packages that
  // meshio needs for it.
  std::string_view command;
};

constexpr std::array kOtherKinds = {
    OtherKind{".geo", "a geometry of Gmsh", "gmsh -3 IN.geo -o IN.msh"},
    OtherKind{".step", "a STEP geometry", "gmsh -3 IN.step -o IN.msh"},
    OtherKind{".stp", "a STEP geometry", "gmsh -3 IN.stp -o IN.msh"},
    OtherKind{".iges", "an IGES geometry", "gmsh -3 IN.iges -o IN.msh"},
    OtherKind{".igs", "an IGES geometry", "gmsh -3 IN.igs -o IN.msh"},
    OtherKind{".brep", "a BREP geometry", "gmsh -3 IN.brep -o IN.msh"},
    OtherKind{".med", "a mesh of Salome", "python3-meshio and python3-h5py"},
    OtherKind{".cgns", "a CGNS mesh", "python3-meshio and python3-h5py"},
    OtherKind{".h5m", "a MOAB mesh", "python3-meshio and python3-h5py"},
    OtherKind{".h5", "data in HDF5", "pass the .xdmf beside it, which says where the mesh is"},
    OtherKind{".pvtu", "a list of .vtu files", "pass one of these"},
    OtherKind{".vtm", "a list of VTK's files", "pass one of these"},
    OtherKind{".3mf", "a 3MF model", "write it as STL or OBJ"},
    OtherKind{".gltf", "a glTF model", "write it as PLY or OBJ"},
    OtherKind{".glb", "a glTF model", "write it as PLY or OBJ"},
    OtherKind{".wrl", "a VRML model", "write it as PLY or OBJ"},
    OtherKind{".x3d", "an X3D model", "write it as PLY or OBJ"},
    OtherKind{".poly", "a domain", "inspect IN.poly, or check MESH --domain IN.poly"},
    OtherKind{".smesh", "a domain", "inspect IN.smesh, or check MESH --domain IN.smesh"},
};

}  // namespace

std::optional<std::string> other_kind(std::string_view ending) {
  const auto* const found =
      std::find_if(kOtherKinds.begin(), kOtherKinds.end(),
                   [ending](const OtherKind& kind) { return kind.ending == ending; });
  if (found == kOtherKinds.end()) return std::nullopt;
  const std::string in = "IN" + std::string(ending);
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

}  // namespace circumspect::formats
