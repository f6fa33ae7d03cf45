#include "oracle/formats/foreign_file.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "oracle/formats/abaqus.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/foam_file.hpp"
#include "oracle/formats/format.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/other_kinds.hpp"
#include "oracle/formats/vtu.hpp"
#include "oracle/formats/xdmf.hpp"

namespace circumspect::formats {
namespace {

struct Signature {
  std::string_view bytes;
  std::string_view what;
};

using namespace std::string_view_literals;

constexpr std::array kSignatures = {
    Signature{"BZh"sv, "a file that bzip2 packed (unpack it first)"},
    Signature{"\xfd"
              "7zXZ"sv,
              "a file that xz packed (unpack it first)"},
    Signature{"PK\x03\x04"sv, "a ZIP archive (unpack it first)"},
    Signature{"version https://git-lfs."sv,
              "a pointer of Git LFS in place of the file (git lfs pull fetches it)"},
};

// The search for a beginning stops after so many bytes: the file may be large and consist of one
// line.
constexpr std::size_t kLongestBeginning = 4096;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The first line of Fluent's has an index of a section in parentheses, "(0 "made by …")".
bool is_fluent(std::string_view first) {
  return first.size() > 1 && first[0] == '(' && is_digit(first[1]);
}

// "MESH dimension 3 ElemType Triangle Nnode 3", in any case, perhaps with a name and with signs of
// equality.
bool is_gid(const std::vector<std::string_view>& first) {
  return is_word(first[0], "mesh") &&
         std::any_of(first.begin(), first.end(),
                     [](std::string_view token) { return is_word(token, "elemtype"); });
}

// "MSHID=3;euclidean-mesh", in any case.
bool is_jigsaw(const std::vector<std::string_view>& first) {
  constexpr std::string_view kKey = "mshid";
  if (!is_word(first[0].substr(0, kKey.size()), kKey)) return false;
  const std::string_view behind = first[0].substr(kKey.size());
  return behind.empty() ? first.size() > 1 && first[1].front() == '=' : behind.front() == '=';
}

// The second line of what qvoronoi o writes has three numbers, the last of which is 1, and the
// third one is the vertex at infinity.
bool is_qvoronoi(Lines lines) {
  constexpr std::string_view kInfinite = "-10.101";
  if (lines.size() != 1 || !lines.next()) return false;
  if (lines.size() != 3 || lines.tokens()[2] != "1" || !lines.next()) return false;
  return std::all_of(lines.tokens().begin(), lines.tokens().end(),
                     [&](std::string_view token) { return token == kInfinite; });
}

// What compilers write as .obj: of COFF for x86 and for x64, and of ELF.
bool is_object_file(std::string_view text) {
  return text.starts_with("\x4c\x01"sv) || text.starts_with("\x64\x86"sv) ||
         text.starts_with(
             "\x7f"
             "ELF"sv);
}

}  // namespace

std::optional<std::string> foreign_kind(const Source& source) {
  const std::string end = extension_inside(source.name);
  for (const auto& [bytes, what] : kSignatures) {
    if (source.text.starts_with(bytes)) return std::string(what);
  }
  if (end == ".obj" && is_object_file(source.text)) {
    return "a compiler's object file, not a mesh of Wavefront's";
  }
  // VTK's XML files are read, but not under the extension of another format, such as that of VTK's
  // legacy format.
  if (is_vtu(source.text)) {
    const Format* const format = format_of(end);
    if (format == nullptr || format->elements == read_vtu || format->elements == read_xdmf) {
      return std::nullopt;
    }
    return "XML (if it is a mesh of VTK, give its name the extension .vtu)";
  }
  const Source beginning{source.name, source.text.substr(0, kLongestBeginning)};
  Lines lines(beginning);
  if (!lines.next()) return std::nullopt;
  if (is_fluent(lines.tokens()[0])) {
    return "a mesh of Fluent (" + read_by_meshio("IN" + end, "ansys") + ")";
  }
  const Format* const read_as = format_of(end, beginning);
  if (is_abaqus(Beginning(beginning)) && read_as != nullptr && read_as->elements != read_abaqus) {
    return "a mesh of Abaqus (give its name the ending .inp)";
  }
  if (is_qvoronoi(lines)) {
    return "a Voronoi diagram of qvoronoi (--claim voronoi --points SITES judges it)";
  }
  if (is_gid(lines.tokens())) {
    return "a mesh of GiD (copy its coordinates to IN.node and its elements to IN.ele, each below "
           "a "
           "line of counts)";
  }
  if (is_jigsaw(lines.tokens())) {
    return "a mesh of JIGSAW (jigsawpy.savevtk(\"OUT.vtk\", mesh) writes one that is read)";
  }
  if (is_foam_file(beginning.text) && format_of(end) == nullptr) {
    return "a file of OpenFOAM (name the case, or its folder polyMesh)";
  }
  return std::nullopt;
}

FormatError explained(FormatError error, const Source& source) {
  std::optional<std::string> kind = foreign_kind(source);
  if (!kind) return error;
  error.found = std::move(*kind);
  error.line = std::min<std::size_t>(error.line, 1);  // the whole file is foreign, not one line
  return error;
}

}  // namespace circumspect::formats
