#include "oracle/formats/vtu.hpp"

#include <array>
#include <utility>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/vtk_cells.hpp"
#include "oracle/formats/vtu_arrays.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::formats {
namespace {

// The lists of a surface: element, attribute with the number of cells, their type.
struct SurfaceList {
  const char* element;
  const char* count;
  Vertex type;
};
constexpr std::array kSurfaceLists = {SurfaceList{"Verts", "NumberOfVerts", kVtkVertices},
                                      SurfaceList{"Lines", "NumberOfLines", kVtkPolyline},
                                      SurfaceList{"Strips", "NumberOfStrips", kVtkStrip},
                                      SurfaceList{"Polys", "NumberOfPolys", kVtkPolygon}};

class VtuReader {
 public:
  explicit VtuReader(std::unique_ptr<VtuDocument> document) : document_(std::move(document)) {}

  Result<ElementFile> read();

 private:
  Status read_piece(pugi::xml_node piece, bool is_surface, bool is_alone);
  Status read_points(pugi::xml_node piece, std::size_t count);
  // The array of that name among those of an element.
  Result<VtuDocument::Array> array(pugi::xml_node cells, const char* name) const;
  Result<Indices> integers(pugi::xml_node cells, const char* name, std::size_t count) const;
  // Reads cells; `type` if all have it, else there is an array of types.
  Status read_cells(pugi::xml_node cells, std::size_t count, std::optional<Vertex> type);
  Status add_cells(pugi::xml_node element, VtkCells cells, const Indices& types);

  std::unique_ptr<VtuDocument> document_;
  ElementFile file_;
  std::size_t points_before_ = 0;           // of other pieces
  std::optional<std::size_t> points_here_;  // of this piece, if there are others
};

Status expect_end_of(VtuDocument::Array& array, const std::string& what) {
  if (array.text.is_at_end()) return {};
  const std::string more = array.text.is_binary()
                               ? std::to_string(array.text.bytes_left()) + " more bytes"
                               : quote(array.text.word());
  return array.text.fail("the end of " + what, more);
}

Status VtuReader::read_points(pugi::xml_node piece, std::size_t count) {
  const pugi::xml_node node = piece.child("Points").child("DataArray");
  if (!node) {
    if (count == 0) return {};
    return document_->fail(piece, "an element Points with a DataArray", "none");
  }
  if (without_blanks(node.attribute("NumberOfComponents").value()) != "3") {
    return document_->fail(node, "NumberOfComponents=\"3\"",
                           quote(node.attribute("NumberOfComponents").value()));
  }
  Result<VtuDocument::Array> numbers = document_->array(node);
  if (!numbers) return tl::unexpected(numbers.error());
  Status status = numbers->text.points(
      numbers->type, count, {"a coordinate of ", "point", 0, count}, file_.points.points);
  if (status) status = expect_end_of(*numbers, "the points");
  return status;
}

Result<VtuDocument::Array> VtuReader::array(pugi::xml_node cells, const char* name) const {
  const pugi::xml_node node = cells.find_child_by_attribute("DataArray", "Name", name);
  if (node) return document_->array(node);
  return document_->fail(cells, "a DataArray " + std::string(name), "none");
}

Result<Indices> VtuReader::integers(pugi::xml_node cells, const char* name,
                                    std::size_t count) const {
  Result<VtuDocument::Array> numbers = array(cells, name);
  if (!numbers) return tl::unexpected(numbers.error());
  const std::string what = "one of " + std::to_string(count) + " " + name;
  Indices values;
  if (Status read = numbers->text.integers(numbers->type, count, what, values); !read) {
    return tl::unexpected(read.error());
  }
  if (Status end = expect_end_of(*numbers, name); !end) return tl::unexpected(end.error());
  return values;
}

Status VtuReader::add_cells(pugi::xml_node element, VtkCells cells, const Indices& types) {
  if (!points_here_ && take_vtk_cells(file_, types, cells)) return {};
  for (std::size_t i = 0; i < cells.vertices.size(); ++i) {
    Simplex vertices = cells.vertices[i];
    const std::string which = " in cell " + std::to_string(i + 1);
    for (Vertex& v : vertices) {
      if (points_here_ && (v < 0 || v >= static_cast<Vertex>(*points_here_))) {
        return document_->fail(element, "a point of this piece" + which, std::to_string(v));
      }
      v += points_here_ ? static_cast<Vertex>(points_before_) : 0;
    }
    const std::size_t size = vertices.size();
    const auto fault = add_vtk_cell(file_, types[i], vertices, cells.lines[i]);
    if (!fault) continue;
    return document_->fail(
        element, *fault,
        "type " + std::to_string(types[i]) + " of " + std::to_string(size) + " vertices" + which);
  }
  return {};
}

Status VtuReader::read_cells(pugi::xml_node cells, std::size_t count, std::optional<Vertex> type) {
  if (count == 0) return {};
  if (!cells) return document_->fail(document_->root(), "an element of cells", "none");
  const Result<Indices> offsets = integers(cells, "offsets", count);
  if (!offsets) return tl::unexpected(offsets.error());
  const Vertex size = offsets->back();
  if (size < 0) return document_->fail(cells, "offsets of 0 or more", std::to_string(size));
  Result<Indices> vertices = integers(cells, "connectivity", count_of(size));
  if (!vertices) return tl::unexpected(vertices.error());
  Indices types;
  for (std::size_t i = 0; type && i < count; ++i) types.push_back(*type);
  if (!type) {
    Result<Indices> listed = integers(cells, "types", count);
    if (!listed) return tl::unexpected(listed.error());
    types = std::move(*listed);
  }
  const MixedText place(document_->name(), "", NumberReading::kDouble);
  Result<VtkCells> lists =
      cells_of(place, *offsets, std::move(*vertices), document_->line_of(cells));
  if (!lists) return tl::unexpected(lists.error());
  return add_cells(cells, std::move(*lists), types);
}

Status VtuReader::read_piece(pugi::xml_node piece, bool is_surface, bool is_alone) {
  const Result<std::size_t> points = document_->count(piece, "NumberOfPoints");
  if (!points) return tl::unexpected(points.error());
  points_before_ = file_.points.points.size();
  if (!is_alone) points_here_ = *points;
  if (Status read = read_points(piece, *points); !read) return read;
  if (!is_surface) {
    const Result<std::size_t> cells = document_->count(piece, "NumberOfCells");
    if (!cells) return tl::unexpected(cells.error());
    return read_cells(piece.child("Cells"), *cells, std::nullopt);
  }
  for (const SurfaceList& list : kSurfaceLists) {
    if (!piece.attribute(list.count)) continue;
    const Result<std::size_t> cells = document_->count(piece, list.count);
    if (!cells) return tl::unexpected(cells.error());
    const Status read = read_cells(piece.child(list.element), *cells, list.type);
    if (!read) return read;
  }
  return {};
}

Result<ElementFile> VtuReader::read() {
  const std::string type = document_->root().attribute("type").value();
  if (type != "UnstructuredGrid" && type != "PolyData") {
    return document_->fail(document_->root(), "type=\"UnstructuredGrid\" or \"PolyData\"",
                           type.empty() ? "none" : quote(type));
  }
  const pugi::xml_node data = document_->root().child(type.c_str());
  if (!data.child("Piece")) {
    return document_->fail(document_->root(), "an element " + type + " with a Piece", "none");
  }
  file_.points.dimension = 3;
  file_.points.points.set_columns(3);
  const bool is_alone = !data.child("Piece").next_sibling("Piece");
  for (const pugi::xml_node piece : data.children("Piece")) {
    const Status read = read_piece(piece, type == "PolyData", is_alone);
    if (!read) return tl::unexpected(read.error());
  }
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_vtu(std::string_view text) {
  text = from_first_word(text);
  return text.starts_with("<VTKFile") || text.starts_with("<?xml");
}

Result<ElementFile> read_vtu(const Source& source, NumberReading reading) {
  Result<std::unique_ptr<VtuDocument>> document = VtuDocument::parse(source, reading);
  if (!document) return tl::unexpected(document.error());
  return VtuReader(std::move(*document)).read();
}

void write_vtu(std::ostream& out, const ElementFile& file) {
  const PointRows& points = file.points.points;
  const std::array<std::pair<const SimplexFile*, const char*>, 3> lists = {
      {{&file.edges, "3\n"}, {&file.triangles, "5\n"}, {&file.tetrahedra, "10\n"}}};
  std::string connectivity;
  std::string offsets;
  std::string types;
  std::string labels;
  std::size_t cells = 0;
  std::size_t end = 0;
  for (const auto& [list, type] : lists) {
    for (const Vertex label : list->labels.values()) labels += std::to_string(label) + "\n";
    for (Simplex vertices : list->simplices) {
      for (Vertex& v : vertices) v = place_of_index(v, file.points.first_index);
      end += vertices.size();
      ++cells;
      connectivity += joined(vertices) + "\n";
      offsets += std::to_string(end) + "\n";
      types += type;
    }
  }
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
             std::to_string(points.size()) + "\" NumberOfCells=\"" + std::to_string(cells) +
             "\">\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
             "format=\"ascii\">\n";
  for (const Point& point : points) out << joined(point) + (point.size() == 2 ? " 0\n" : "\n");
  out << "</DataArray>\n</Points>\n";
  if (!labels.empty()) {
    out << "<CellData Scalars=\"label\">\n"
           "<DataArray type=\"Int64\" Name=\"label\" format=\"ascii\">\n" +
               labels + "</DataArray>\n</CellData>\n";
  }
  out << "<Cells>\n"
         "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n" +
             connectivity +
             "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n" +
             offsets +
             "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n" + types +
             "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace circumspect::formats
