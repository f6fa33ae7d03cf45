#include "oracle/formats/dolfin.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <pugixml.hpp>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/vtu_arrays.hpp"

namespace circumspect::formats {
namespace {

constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
constexpr std::array kCellTypes = {
    ElementType{1, 2, ElementShape::kPolyline, "interval"},
    ElementType{2, 3, ElementShape::kPolygon, "triangle"},
    ElementType{3, 4, ElementShape::kTetrahedron, "tetrahedron"},
    ElementType{4, 4, ElementShape::kPolygon, "quadrilateral"},
    ElementType{5, 8, ElementShape::kOtherSolid, "hexahedron"},
};

class DolfinReader {
 public:
  DolfinReader(const Source& source, NumberReading reading) : source_(source), reading_(reading) {}

  Result<ElementFile> read();

 private:
  Status read_vertices(pugi::xml_node vertices);
  Status read_cells(pugi::xml_node cells, const ElementType& type);
  // An attribute that is an integer of at least 0.
  Result<Vertex> integer(pugi::xml_node node, const std::string& name);
  // The children of a list: their number is that of `size`, and each has its place as its index.
  Result<std::size_t> size_of(pugi::xml_node list, std::string_view name);
  Status expect_index(pugi::xml_node node, std::size_t place);
  tl::unexpected<FormatError> fail(pugi::xml_node node, std::string expected, std::string found);
  // Of nodes in their order: lines are counted once.
  std::size_t line_of(pugi::xml_node node);

  const Source& source_;
  NumberReading reading_;
  pugi::xml_document document_;
  ElementFile file_;
  std::size_t place_ = 0, line_ = 1;
};

std::size_t DolfinReader::line_of(pugi::xml_node node) {
  const auto place = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
  if (place < place_) return line_at(source_.text, place);
  const auto at = [&](std::size_t i) {
    return source_.text.begin() + static_cast<std::ptrdiff_t>(std::min(i, source_.text.size()));
  };
  line_ += static_cast<std::size_t>(std::count(at(place_), at(place), '\n'));
  place_ = place;
  return line_;
}

tl::unexpected<FormatError> DolfinReader::fail(pugi::xml_node node, std::string expected,
                                               std::string found) {
  return tl::unexpected(
      FormatError{source_.name, line_of(node), std::move(expected), std::move(found)});
}

Result<Vertex> DolfinReader::integer(pugi::xml_node node, const std::string& name) {
  const std::string_view text = node.attribute(name.c_str()).value();
  Vertex value = 0;
  if (parse_integer(text, value) == std::errc() && value >= 0) return value;
  return fail(node, name + "=\"N\", a whole number", text.empty() ? "none" : quote(text));
}

Result<std::size_t> DolfinReader::size_of(pugi::xml_node list, std::string_view name) {
  const Result<Vertex> size = integer(list, "size");
  if (!size) return tl::unexpected(size.error());
  std::size_t count = 0;
  for (const pugi::xml_node node : list.children()) {
    if (node.name() != name)
      return fail(node, "the element " + std::string(name), quote(node.name()));
    ++count;
  }
  if (count == count_of(*size)) return count;
  return fail(list, std::to_string(*size) + " elements " + std::string(name),
              std::to_string(count));
}

Status DolfinReader::expect_index(pugi::xml_node node, std::size_t place) {
  const Result<Vertex> index = integer(node, "index");
  if (!index) return tl::unexpected(index.error());
  if (count_of(*index) == place) return {};
  return fail(node, "the index " + std::to_string(place) + ", in ascending order",
              std::to_string(*index));
}

Status DolfinReader::read_vertices(pugi::xml_node vertices) {
  const Result<std::size_t> count = size_of(vertices, "vertex");
  if (!count) return tl::unexpected(count.error());
  std::size_t place = 0;
  for (const pugi::xml_node vertex : vertices.children()) {
    if (Status index = expect_index(vertex, place++); !index) return index;
    for (std::size_t axis = 0; axis < file_.points.dimension; ++axis) {
      const std::string_view text = vertex.attribute(kAxes[axis]).value();
      auto number = parse_number(text, reading_);
      if (!number) {
        return fail(vertex, std::string(kAxes[axis]) + "=\"NUMBER\"",
                    text.empty() ? "none" : quote(text));
      }
      file_.points.points.add(std::move(*number));
    }
  }
  return {};
}

Status DolfinReader::read_cells(pugi::xml_node cells, const ElementType& type) {
  const Result<std::size_t> count = size_of(cells, type.name);
  if (!count) return tl::unexpected(count.error());
  const std::string name = (type.name == "interval" ? "an " : "a ") + std::string(type.name);
  std::vector<Vertex> corners;
  std::size_t place = 0;
  for (const pugi::xml_node cell : cells.children()) {
    if (Status index = expect_index(cell, place++); !index) return index;
    corners.clear();
    for (std::size_t i = 0; i < type.vertices; ++i) {
      const Result<Vertex> corner = integer(cell, "v" + std::to_string(i));
      if (!corner) return tl::unexpected(corner.error());
      corners.push_back(*corner);
    }
    add_element(file_, type.shape, corners, name, line_of(cell));
  }
  return {};
}

Result<ElementFile> DolfinReader::read() {
  const pugi::xml_parse_result parsed = document_.load_buffer(
      source_.text.data(), source_.text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed) {
    const auto place = static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0));
    return tl::unexpected(FormatError{source_.name, line_at(source_.text, place), "XML",
                                      "a fault: " + std::string(parsed.description())});
  }
  const pugi::xml_node root = document_.child("dolfin"), mesh = root.child("mesh");
  if (!mesh) {
    return fail(root, "the element mesh",
                root.first_child() ? quote(root.first_child().name()) : "none");
  }
  const std::string_view name = mesh.attribute("celltype").value();
  const auto* const type = std::find_if(kCellTypes.begin(), kCellTypes.end(),
                                        [&](const ElementType& one) { return one.name == name; });
  if (type == kCellTypes.end()) {
    return fail(mesh, "celltype=\"triangle\", \"tetrahedron\" or \"interval\"",
                name.empty() ? "none" : quote(name));
  }
  const Result<Vertex> dimension = integer(mesh, "dim");
  if (!dimension) return tl::unexpected(dimension.error());
  if (*dimension < 1 || *dimension > 3) {
    return fail(mesh, "dim=\"1\", \"2\" or \"3\"", std::to_string(*dimension));
  }
  file_.points.dimension = count_of(*dimension);
  file_.points.points.set_columns(file_.points.dimension);
  Status status = read_vertices(mesh.child("vertices"));
  if (status) status = read_cells(mesh.child("cells"), *type);
  if (!status) return tl::unexpected(status.error());
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_dolfin(std::string_view text) {
  text = from_first_word(text.substr(0, 4096));
  return text.starts_with('<') && text.find("<dolfin") != std::string_view::npos;
}

Result<ElementFile> read_dolfin(const Source& source, NumberReading reading) {
  return DolfinReader(source, reading).read();
}

}  // namespace circumspect::formats
