// For tests: one mesh of elements in every form of every format, as other programs write it. All
// must be read and judged alike.
#pragma once

#include <bit>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <zlib.h>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/abaqus.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/gmsh.hpp"
#include "oracle/formats/medit.hpp"
#include "oracle/formats/meshb.hpp"
#include "oracle/formats/nastran.hpp"
#include "oracle/formats/su2.hpp"
#include "oracle/formats/tet.hpp"
#include "oracle/formats/ucd.hpp"
#include "oracle/formats/unv.hpp"
#include "oracle/formats/vtk.hpp"
#include "oracle/formats/vtu.hpp"
#include "oracle/formats/written_decks_test.hpp"
#include "oracle/formats/written_meshb_test.hpp"
#include "oracle/formats/xdmf.hpp"

namespace circumspect::formats {

// A file as some program writes the mesh.
struct WrittenForm {
  std::string name;       // "gmsh 4.1, big-endian"
  std::string extension;  // ".msh"
  bool has_faces = true;  // else it has only the tetrahedra
  std::string text = {};
};

// Consecutive numbers: in text with a blank after each, or in binary.
class NumberWriter {
 public:
  explicit NumberWriter(std::optional<ByteOrder> binary) : binary_(binary) {}

  NumberWriter& integer(std::size_t value, std::size_t size) {
    text += binary_ ? stored(value, size, *binary_) : std::to_string(value) + " ";
    return *this;
  }
  NumberWriter& number(double value) {
    if (binary_) {
      text += stored(std::bit_cast<std::uint64_t>(value), 8, *binary_);
    } else {
      std::ostringstream out;
      out.precision(17);
      out << value << ' ';
      text += out.str();
    }
    return *this;
  }
  NumberWriter& word(const std::string& word) {
    text += word;
    return *this;
  }

  std::string text;

 private:
  std::optional<ByteOrder> binary_;
};

inline std::size_t gmsh_type(std::size_t vertices) {
  return vertices == 4 ? 4 : vertices - 1;  // an edge is 1, a triangle 2, a tetrahedron 4
}

inline std::string gmsh_header(const std::string& version, std::optional<ByteOrder> binary) {
  NumberWriter out(binary);
  out.word("$MeshFormat\n" + version + (binary ? " 1 8\n" : " 0 8\n"));
  if (binary) out.integer(1, 4).word("\n");
  return out.word("$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"a $Nodes b\"\n$EndPhysicalNames\n")
      .text;
}

// Nodes are in reverse order.
inline std::string gmsh_2(const WrittenMesh& mesh, std::optional<ByteOrder> binary) {
  NumberWriter out(binary);
  out.word(gmsh_header("2.2", binary) + "$Nodes\n" + std::to_string(mesh.points.size()) + "\n");
  for (std::size_t i = mesh.points.size(); i > 0; --i) {
    out.integer(i, 4);
    for (const double x : mesh.points[i - 1]) out.number(x);
    if (!binary) out.word("\n");
  }
  out.word("\n$EndNodes\n$Elements\n" + std::to_string(mesh.cells.size()) + "\n");
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const auto& cell = mesh.cells[i];
    if (binary) {
      out.integer(gmsh_type(cell.size()), 4).integer(1, 4).integer(2, 4).integer(i + 1, 4);
    } else {
      out.integer(i + 1, 4).integer(gmsh_type(cell.size()), 4).integer(2, 4);
    }
    out.integer(7, 4).integer(9, 4);
    for (const int v : cell) out.integer(static_cast<std::size_t>(v) + 1, 4);
    if (!binary) out.word("\n");
  }
  return out.word("\n$EndElements\n").text;
}

// A point, a curve, a surface, and a volume of two physical groups, 7 and 9. Version 4.0 has a box
// of a point, too.
inline std::string gmsh_entities(std::optional<ByteOrder> binary, bool is_4_0) {
  NumberWriter out(binary);
  const std::string line = binary ? "" : "\n";
  out.word("$Entities\n").integer(1, 8).integer(1, 8).integer(1, 8).integer(1, 8).word(line);
  for (const std::size_t tag : {4U, 5U, 6U, 1U}) {
    const bool is_point = tag == 4;
    out.integer(tag, 4);
    for (std::size_t i = 0; i < (is_point && !is_4_0 ? 3 : 6); ++i) out.number(0.75);
    out.integer(tag == 1 ? 2 : 0, 8);
    if (tag == 1) out.integer(7, 4).integer(9, 4);
    if (!is_point) out.integer(1, 8).integer(4, 4);
    out.word(line);
  }
  return out.word("\n$EndEntities\n").text;
}

// Nodes in two blocks, the latter half first and with a parameter each.
inline std::string gmsh_4(const WrittenMesh& mesh, std::optional<ByteOrder> binary) {
  NumberWriter out(binary);
  const std::size_t count = mesh.points.size();
  const std::string line = binary ? "" : "\n";
  out.word(gmsh_header("4.1", binary) + gmsh_entities(binary, false) + "$Nodes\n");
  out.integer(2, 8).integer(count, 8).integer(1, 8).integer(count, 8).word(line);
  const auto block = [&](std::size_t begin, std::size_t end, std::size_t parameters) {
    out.integer(parameters, 4)
        .integer(5, 4)
        .integer(parameters, 4)
        .integer(end - begin, 8)
        .word(line);
    for (std::size_t i = begin; i < end; ++i) out.integer(i + 1, 8).word(line);
    for (std::size_t i = begin; i < end; ++i) {
      for (const double x : mesh.points[i]) out.number(x);
      for (std::size_t j = 0; j < parameters; ++j) out.number(0.25);
      out.word(line);
    }
  };
  block(count / 2, count, 1);
  block(0, count / 2, 0);
  out.word("\n$EndNodes\n$Elements\n");
  out.integer(mesh.cells.size(), 8).integer(mesh.cells.size(), 8).integer(1, 8);
  out.integer(mesh.cells.size(), 8).word(line);
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    out.integer(3, 4).integer(1, 4).integer(gmsh_type(mesh.cells[i].size()), 4).integer(1, 8);
    out.word(line).integer(i + 1, 8);
    for (const int v : mesh.cells[i]) out.integer(static_cast<std::size_t>(v) + 1, 8);
    out.word(line);
  }
  return out.word("\n$EndElements\n").text;
}

// The same in the version before: tags of entities before dimensions, each node behind its tag.
inline std::string gmsh_4_0(const WrittenMesh& mesh, std::optional<ByteOrder> binary) {
  NumberWriter out(binary);
  const std::size_t count = mesh.points.size();
  const std::string line = binary ? "" : "\n";
  out.word(gmsh_header("4", binary) + gmsh_entities(binary, true) + "$Nodes\n");
  out.integer(2, 8).integer(count, 8).word(line);
  const auto block = [&](std::size_t begin, std::size_t end, std::size_t parameters) {
    out.integer(5, 4).integer(parameters, 4).integer(parameters, 4).integer(end - begin, 8);
    for (std::size_t i = begin; i < end; ++i) {
      out.word(line).integer(i + 1, 4);
      for (const double x : mesh.points[i]) out.number(x);
      for (std::size_t j = 0; j < parameters; ++j) out.number(0.25);
    }
    out.word(line);
  };
  block(count / 2, count, 1);
  block(0, count / 2, 0);
  out.word("\n$EndNodes\n$Elements\n").integer(mesh.cells.size(), 8).integer(mesh.cells.size(), 8);
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    out.word(line).integer(1, 4).integer(3, 4).integer(gmsh_type(mesh.cells[i].size()), 4);
    out.integer(1, 8).word(line).integer(i + 1, 4);
    for (const int v : mesh.cells[i]) out.integer(static_cast<std::size_t>(v) + 1, 4);
  }
  return out.word("\n$EndElements\n").text;
}

inline std::size_t vtk_type(std::size_t vertices) {
  return vertices == 2 ? 3 : vertices == 3 ? 5 : 10;
}

inline std::string vtk_legacy(const WrittenMesh& mesh, bool is_binary, bool has_offsets) {
  NumberWriter out(is_binary ? std::optional(ByteOrder::kBigEndian) : std::nullopt);
  const std::string count = std::to_string(mesh.cells.size());
  std::size_t size = 0;
  for (const auto& cell : mesh.cells) size += cell.size();
  out.word("# vtk DataFile Version " + std::string(has_offsets ? "5.1" : "3.0") + "\na title\n" +
           (is_binary ? "BINARY" : "ASCII") + "\nDATASET UNSTRUCTURED_GRID\n");
  out.word("FIELD FieldData 1\nTIME 1 1 double\n").number(0.5).word("\n");
  out.word("POINTS " + std::to_string(mesh.points.size()) + " double\n");
  for (const auto& point : mesh.points) {
    for (const double x : point) out.number(x);
  }
  out.word("\nMETADATA\nINFORMATION 1\nNAME CELLS LOCATION vtk\nDATA 2 0 1\n\n");
  if (has_offsets) {
    out.word("CELLS " + std::to_string(mesh.cells.size() + 1) + " " + std::to_string(size) +
             "\nOFFSETS vtktypeint64\n");
    std::size_t end = 0;
    out.integer(0, 8);
    for (const auto& cell : mesh.cells) out.integer(end += cell.size(), 8);
    out.word("\nCONNECTIVITY vtktypeint64\n");
    for (const auto& cell : mesh.cells) {
      for (const int v : cell) out.integer(static_cast<std::size_t>(v), 8);
    }
  } else {
    out.word("CELLS " + count + " " + std::to_string(size + mesh.cells.size()) + "\n");
    for (const auto& cell : mesh.cells) {
      out.integer(cell.size(), 4);
      for (const int v : cell) out.integer(static_cast<std::size_t>(v), 4);
    }
  }
  out.word("\nCELL_TYPES " + count + "\n");
  for (const auto& cell : mesh.cells) out.integer(vtk_type(cell.size()), 4);
  return out.word("\nCELL_DATA " + count + "\nanything at all").text;
}

inline std::string base64(const std::string& bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group = group << 8U | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      text += i + j <= bytes.size() ? kDigits[group >> (18 - 6 * j) & 63U] : '=';
    }
  }
  return text;
}

// How the arrays of a .vtu file are stored.
struct VtuForm {
  enum class Place { kText, kInline, kAppendedBase64, kAppendedRaw } place = Place::kText;
  enum class Packed { kNot, kByZlib, kByLz4 } packed = Packed::kNot;
  ByteOrder order = ByteOrder::kLittleEndian;
  std::size_t size_of_lengths = 4;
};

inline std::string packed_by_zlib(const std::string& block) {
  std::string packed(::compressBound(block.size()), '\0');
  uLongf size = packed.size();
  ::compress(reinterpret_cast<Bytef*>(packed.data()), &size,
             reinterpret_cast<const Bytef*>(block.data()), block.size());
  packed.resize(size);
  return packed;
}

// As literals alone. Requires: fewer than 270 bytes.
inline std::string packed_by_lz4(const std::string& block) {
  const std::size_t size = block.size();
  if (size < 15) return std::string(1, static_cast<char>(size << 4U)) + block;
  return "\xf0" + std::string(1, static_cast<char>(size - 15)) + block;
}

// The header of the bytes of an array, and these bytes: in base 64 they are two texts if
// compressed.
inline std::string vtu_bytes(const std::string& bytes, const VtuForm& form, bool is_base64) {
  NumberWriter head(form.order);
  std::string body = bytes;
  if (form.packed == VtuForm::Packed::kNot) {
    head.integer(bytes.size(), form.size_of_lengths);
    return is_base64 ? base64(head.text + body) : head.text + body;
  }
  // Blocks of 50 bytes; the last one may have fewer.
  constexpr std::size_t kBlock = 50;
  const std::size_t blocks = (bytes.size() + kBlock - 1) / kBlock;
  head.integer(blocks, form.size_of_lengths).integer(kBlock, form.size_of_lengths);
  head.integer(bytes.size() % kBlock, form.size_of_lengths);
  body.clear();
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::string block = bytes.substr(i * kBlock, kBlock);
    const std::string packed =
        form.packed == VtuForm::Packed::kByZlib ? packed_by_zlib(block) : packed_by_lz4(block);
    head.integer(packed.size(), form.size_of_lengths);
    body += packed;
  }
  return is_base64 ? base64(head.text) + base64(body) : head.text + body;
}

inline std::string vtu(const WrittenMesh& mesh, const VtuForm& form) {
  using enum VtuForm::Place;
  const auto binary = form.place == kText ? std::nullopt : std::optional(form.order);
  NumberWriter points(binary);
  NumberWriter connectivity(binary);
  NumberWriter offsets(binary);
  NumberWriter types(binary);
  for (const auto& point : mesh.points) {
    for (const double x : point) points.number(x);
  }
  std::size_t end = 0;
  for (const auto& cell : mesh.cells) {
    for (const int v : cell) connectivity.integer(static_cast<std::size_t>(v), 4);
    offsets.integer(end += cell.size(), 8);
    types.integer(vtk_type(cell.size()), 1);
  }
  std::string appended;
  const auto array = [&](const std::string& attributes, const std::string& bytes) {
    const std::string begin = "<DataArray " + attributes + " format=\"";
    const std::string key = "<InformationKey name=\"a\" location=\"b\">7</InformationKey>\n";
    if (form.place == kText) return begin + "ascii\">\n" + bytes + key + "</DataArray>\n";
    if (form.place == kInline) {
      return begin + "binary\">\n  " + vtu_bytes(bytes, form, true) + "\n</DataArray>\n";
    }
    const std::size_t offset = appended.size();
    appended += vtu_bytes(bytes, form, form.place == kAppendedBase64);
    return begin + "appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
  };
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" ";
  text += form.order == ByteOrder::kBigEndian ? "byte_order=\"BigEndian\" "
                                              : "byte_order=\"LittleEndian\" ";
  text += form.size_of_lengths == 8 ? "header_type=\"UInt64\"" : "header_type=\"UInt32\"";
  if (form.packed == VtuForm::Packed::kByZlib) text += " compressor=\"vtkZLibDataCompressor\"";
  if (form.packed == VtuForm::Packed::kByLz4) text += " compressor=\"vtkLZ4DataCompressor\"";
  text += ">\n";
  text += "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" + std::to_string(mesh.points.size()) +
          "\" NumberOfCells=\"" + std::to_string(mesh.cells.size()) + "\">\n<Points>\n";
  text += array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", points.text);
  text += "</Points>\n<Cells>\n";
  text += array("type=\"Int32\" Name=\"connectivity\"", connectivity.text);
  text += array("type=\"Int64\" Name=\"offsets\"", offsets.text);
  text += array("type=\"UInt8\" Name=\"types\"", types.text);
  text += "</Cells>\n</Piece>\n</UnstructuredGrid>\n";
  if (!appended.empty()) {
    text += "<AppendedData encoding=\"";
    text += form.place == kAppendedRaw ? "raw\">\n_" : "base64\">\n_";
    text += appended + "\n</AppendedData>\n";
  }
  return text + "</VTKFile>\n";
}

inline std::string tet(const WrittenMesh& mesh, bool is_binary) {
  std::vector<std::vector<int>> tetrahedra;
  for (const auto& cell : mesh.cells) {
    if (cell.size() == 4) tetrahedra.push_back(cell);
  }
  NumberWriter out(is_binary ? std::optional(ByteOrder::kLittleEndian) : std::nullopt);
  out.word(std::to_string(mesh.points.size()) + " vertices\n" + std::to_string(tetrahedra.size()) +
           " tets\n");
  for (const auto& point : mesh.points) {
    for (const double x : point) out.number(x);
  }
  for (const auto& cell : tetrahedra) {
    if (!is_binary) out.integer(4, 4);
    for (const int v : cell) out.integer(static_cast<std::size_t>(v), 4);
  }
  return out.text;
}

inline ElementFile elements_of(const WrittenMesh& mesh) {
  ElementFile file;
  file.points.dimension = 3;
  for (const auto& point : mesh.points) {
    Point exact;
    for (const double x : point) exact.push_back(exact_value(x));
    file.points.points.push_back(std::move(exact));
  }
  for (const auto& cell : mesh.cells) {
    const ElementShape shape = cell.size() == 4   ? ElementShape::kTetrahedron
                               : cell.size() == 3 ? ElementShape::kPolygon
                                                  : ElementShape::kPolyline;
    add_element(file, shape, Simplex(cell.begin(), cell.end()), "a cell", 0);
  }
  finish_elements(file);
  return file;
}

inline std::vector<WrittenForm> all_forms(const WrittenMesh& mesh) {
  using enum ByteOrder;
  using enum VtuForm::Place;
  using enum VtuForm::Packed;
  const ElementFile elements = elements_of(mesh);
  const auto ours = [&](void (*write)(std::ostream&, const ElementFile&)) {
    std::ostringstream out;
    write(out, elements);
    return out.str();
  };
  std::vector<WrittenForm> forms = {
      {"medit", ".mesh", true, ours(write_medit)},
      {"meshb 2", ".meshb", true, meshb(mesh, kLittleEndian, 2)},
      {"meshb 3, big-endian", ".meshb", true, meshb(mesh, kBigEndian, 3)},
      {"meshb 4", ".meshb", true, meshb(mesh, kLittleEndian, 4)},
      {"gmsh, ours", ".msh", true, ours(write_gmsh)},
      {"gmsh 2.2", ".msh", true, gmsh_2(mesh, {})},
      {"gmsh 2.2, little-endian", ".msh", true, gmsh_2(mesh, kLittleEndian)},
      {"gmsh 2.2, big-endian", ".msh", true, gmsh_2(mesh, kBigEndian)},
      {"gmsh 4.0", ".msh", true, gmsh_4_0(mesh, {})},
      {"gmsh 4.0, little-endian", ".msh", true, gmsh_4_0(mesh, kLittleEndian)},
      {"gmsh 4.0, big-endian", ".msh", true, gmsh_4_0(mesh, kBigEndian)},
      {"gmsh 4.1", ".msh", true, gmsh_4(mesh, {})},
      {"gmsh 4.1, little-endian", ".msh", true, gmsh_4(mesh, kLittleEndian)},
      {"gmsh 4.1, big-endian", ".msh", true, gmsh_4(mesh, kBigEndian)},
      {"vtk 3", ".vtk", true, vtk_legacy(mesh, false, false)},
      {"vtk 3, binary", ".vtk", true, vtk_legacy(mesh, true, false)},
      {"vtk 5", ".vtk", true, vtk_legacy(mesh, false, true)},
      {"vtk 5, binary", ".vtk", true, vtk_legacy(mesh, true, true)},
      {"vtu, ours", ".vtu", true, ours(write_vtu)},
      {"vtu", ".vtu", true, vtu(mesh, {})},
      {"vtu, inline", ".vtu", true, vtu(mesh, {kInline})},
      {"vtu, inline, zlib", ".vtu", true, vtu(mesh, {kInline, kByZlib, kLittleEndian, 8})},
      {"vtu, base64", ".vtu", true, vtu(mesh, {kAppendedBase64, kNot, kBigEndian, 8})},
      {"vtu, base64, zlib", ".vtu", true, vtu(mesh, {kAppendedBase64, kByZlib})},
      {"vtu, raw", ".vtu", true, vtu(mesh, {kAppendedRaw})},
      {"vtu, raw, zlib", ".vtu", true, vtu(mesh, {kAppendedRaw, kByZlib, kBigEndian, 8})},
      {"vtu, inline, lz4", ".vtu", true, vtu(mesh, {kInline, kByLz4})},
      {"vtu, raw, lz4", ".vtu", true, vtu(mesh, {kAppendedRaw, kByLz4, kBigEndian, 8})},
      {"tet", ".tet", false, tet(mesh, false)},
      {"tet, binary", ".tet", false, tet(mesh, true)},
      {"su2", ".su2", true, su2(mesh, false)},
      {"su2, with indices", ".su2", true, su2(mesh, true)},
      {"ucd", ".inp", true, ucd(mesh)}};
  if (mesh.cells.empty()) return forms;  // decks have some
  forms.insert(forms.end(), {{"nastran", ".bdf", true, nastran(mesh, false)},
                             {"nastran, in columns", ".bdf", true, nastran(mesh, true)},
                             {"abaqus", ".inp", true, abaqus(mesh, false)},
                             {"abaqus, over lines", ".inp", true, abaqus(mesh, true)},
                             {"unv", ".unv", true, unv(mesh, false)},
                             {"unv, old", ".unv", true, unv(mesh, true)},
                             {"xdmf", ".xdmf", true, xdmf(mesh)}});
  return forms;
}

inline Result<ElementFile> read_form(const WrittenForm& form, NumberReading reading) {
  const Source source{"f", form.text};
  if (form.extension == ".mesh") return read_medit(source, reading);
  if (form.extension == ".meshb") return read_meshb(source, reading);
  if (form.extension == ".msh") return read_gmsh(source, reading);
  if (form.extension == ".vtk") return read_vtk(source, reading);
  if (form.extension == ".vtu") return read_vtu(source, reading);
  if (form.extension == ".su2") return read_su2(source, reading);
  if (form.name == "ucd") return read_ucd(source, reading);
  if (form.extension == ".bdf") return read_nastran(source, reading);
  if (form.extension == ".inp") return read_abaqus(source, reading);
  if (form.extension == ".unv") return read_unv(source, reading);
  if (form.extension == ".xdmf") return read_xdmf(source, reading);
  return read_tet(source, reading);
}

}  // namespace circumspect::formats
