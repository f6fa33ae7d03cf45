#include "oracle/formats/other_kinds.hpp"

#include <algorithm>
#include <array>

namespace circumspect::formats {
namespace {

struct OtherKind {
  std::string_view extension;
  std::string_view what;
  std::string_view command;  // IN stands for its name without the extension
};

// `meshio convert` keeps 16 digits and more of the coordinates.
constexpr std::array kOtherKinds = {
    OtherKind{".meshb", "Medit's binary form", "gmsh -0 IN.meshb -format mesh -o IN.mesh"},
    OtherKind{".geo", "a geometry of Gmsh", "gmsh -3 IN.geo -o IN.msh"},
    OtherKind{".step", "a STEP geometry", "gmsh -3 IN.step -o IN.msh"},
    OtherKind{".stp", "a STEP geometry", "gmsh -3 IN.stp -o IN.msh"},
    OtherKind{".iges", "an IGES geometry", "gmsh -3 IN.iges -o IN.msh"},
    OtherKind{".igs", "an IGES geometry", "gmsh -3 IN.igs -o IN.msh"},
    OtherKind{".brep", "a BREP geometry", "gmsh -3 IN.brep -o IN.msh"},
    OtherKind{".inp", "a mesh of Abaqus", "meshio convert IN.inp IN.vtu"},
    OtherKind{".bdf", "a mesh of Nastran", "meshio convert IN.bdf IN.vtu"},
    OtherKind{".nas", "a mesh of Nastran", "meshio convert IN.nas IN.vtu"},
    OtherKind{".unv", "a mesh of I-DEAS", "gmsh -0 IN.unv -o IN.msh"},
    OtherKind{".med", "a mesh of Salome", "meshio convert IN.med IN.vtu"},
    OtherKind{".cgns", "a CGNS mesh", "meshio convert IN.cgns IN.vtu"},
    OtherKind{".xdmf", "an XDMF mesh", "meshio convert IN.xdmf IN.vtu"},
    OtherKind{".e", "an Exodus mesh", "meshio convert IN.e IN.vtu"},
    OtherKind{".exo", "an Exodus mesh", "meshio convert IN.exo IN.vtu"},
    OtherKind{".h5m", "a MOAB mesh", "meshio convert IN.h5m IN.vtu"},
    OtherKind{".su2", "a mesh of SU2", "meshio convert IN.su2 IN.vtu"},
    OtherKind{".vol", "a mesh of Netgen", "meshio convert IN.vol IN.vtu"},
    OtherKind{".pvtu", "a list of .vtu files", "pass one of these"},
    OtherKind{".vtm", "a list of VTK's files", "pass one of these"},
    OtherKind{".3mf", "a 3MF model", "write it as STL or OBJ"},
    OtherKind{".gltf", "a glTF model", "write it as PLY or OBJ"},
    OtherKind{".glb", "a glTF model", "write it as PLY or OBJ"},
    OtherKind{".wrl", "a VRML model", "write it as PLY or OBJ"},
    OtherKind{".x3d", "an X3D model", "write it as PLY or OBJ"},
};

}  // namespace

std::optional<std::string> other_kind(std::string_view extension) {
  const auto* const found =
      std::find_if(kOtherKinds.begin(), kOtherKinds.end(),
                   [extension](const OtherKind& kind) { return kind.extension == extension; });
  if (found == kOtherKinds.end()) return std::nullopt;
  return std::string(found->what) + " (" + std::string(found->command) + ")";
}

}  // namespace circumspect::formats
