#include "oracle/formats/xdmf.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/vtu_arrays.hpp"
#include "oracle/formats/xdmf_arrays.hpp"

namespace circumspect::formats {
namespace {

using enum ElementShape;

// Types of elements: the number in a mixed list, and the nodes, 0 where the list or NodesPerElement
// says how many.
struct Topology {
  std::string_view name;
  ElementType type;
};
constexpr std::array kTopologies = {
    Topology{"polyvertex", {1, 0, kPoint, "points"}},
    Topology{"polyline", {2, 0, kPolyline, "a line"}},
    Topology{"polygon", {3, 0, kPolygon, "a polygon"}},
    Topology{"triangle", {4, 3, kPolygon, "a triangle"}},
    Topology{"quadrilateral", {5, 4, kPolygon, "a quadrilateral"}},
    Topology{"tetrahedron", {6, 4, kTetrahedron, "a tetrahedron"}},
    Topology{"pyramid", {7, 5, kOtherSolid, "a pyramid"}},
    Topology{"wedge", {8, 6, kOtherSolid, "a prism"}},
    Topology{"hexahedron", {9, 8, kOtherSolid, "a hexahedron"}},
    Topology{"edge_3", {34, 3, kCurvedEdge, "an edge of second order"}},
    Topology{"triangle_6", {36, 6, kCurvedTriangle, "a triangle of second order"}},
    Topology{"tri_6", {36, 6, kCurvedTriangle, "a triangle of second order"}},
    Topology{"quadrilateral_8", {37, 8, kCurved, "a quadrilateral of second order"}},
    Topology{"quad_8", {37, 8, kCurved, "a quadrilateral of second order"}},
    Topology{"tetrahedron_10", {38, 10, kCurvedTetrahedron, "a tetrahedron of second order"}},
    Topology{"tet_10", {38, 10, kCurvedTetrahedron, "a tetrahedron of second order"}},
    Topology{"pyramid_13", {39, 13, kCurved, "a pyramid of second order"}},
    Topology{"wedge_15", {40, 15, kCurved, "a prism of second order"}},
    Topology{"hexahedron_20", {48, 20, kCurved, "a hexahedron of second order"}},
    Topology{"hex_20", {48, 20, kCurved, "a hexahedron of second order"}},
};

template <class Is>
const ElementType* find_type(const Is& is) {
  const auto* const found = std::find_if(kTopologies.begin(), kTopologies.end(), is);
  return found == kTopologies.end() ? nullptr : &found->type;
}

// An attribute that has two names in two versions.
std::string_view attribute(pugi::xml_node node, const char* name, const char* other) {
  return node.attribute(name) ? node.attribute(name).value() : node.attribute(other).value();
}

class XdmfReader {
 public:
  explicit XdmfReader(std::unique_ptr<XdmfDocument> document) : document_(std::move(document)) {}

  Result<ElementFile> read();

 private:
  Status read_geometry(pugi::xml_node geometry);
  Status read_topology(pugi::xml_node topology);
  Status read_mixed(pugi::xml_node topology, XdmfArray& array);
  Status add(pugi::xml_node topology, const ElementType& type, std::span<const Vertex> vertices,
             std::size_t line);

  std::unique_ptr<XdmfDocument> document_;
  ElementFile file_;
};

Status XdmfReader::read_geometry(pugi::xml_node geometry) {
  std::string_view type = attribute(geometry, "GeometryType", "Type");
  if (type.empty()) type = "XYZ";
  const bool is_plane = is_word(type, "xy");
  if (!is_plane && !is_word(type, "xyz")) {
    return document_->fail(geometry, "GeometryType=\"XYZ\" or \"XY\"", quote(type));
  }
  const std::size_t dimension = is_plane ? 2 : 3;
  file_.points.dimension = dimension;
  file_.points.points.set_columns(dimension);
  Result<XdmfArray> numbers = document_->array(geometry.child("DataItem"), geometry);
  if (!numbers) return tl::unexpected(numbers.error());
  const std::size_t count = numbers->numbers() / dimension;
  if (numbers->numbers() != count * dimension) {
    return document_->fail(geometry, std::to_string(dimension) + " coordinates of each point",
                           std::to_string(numbers->numbers()) + " numbers");
  }
  Status status = numbers->text.points(
      numbers->type, count, {"a coordinate of ", "point", 0, count}, file_.points.points);
  return status ? numbers->expect_end("the points") : status;
}

Status XdmfReader::add(pugi::xml_node topology, const ElementType& type,
                       std::span<const Vertex> vertices, std::size_t line) {
  const auto fault = add_element(file_, type.shape, vertices, type.name, line);
  return fault ? Status(document_->fail(topology, *fault, std::to_string(vertices.size())))
               : Status();
}

// A number for the type, for some types how many nodes follow, and the nodes.
Status XdmfReader::read_mixed(pugi::xml_node topology, XdmfArray& array) {
  std::size_t left = array.numbers();
  std::vector<Vertex> vertices;
  const auto next = [&](std::string_view what) {
    left -= left > 0 ? 1 : 0;
    return array.text.take(array.type, {what});
  };
  while (left > 0) {
    const Vertex code = next("the type of an element");
    const std::size_t line = array.text.line();
    if (array.text.has_failed()) return array.text.failure();
    const ElementType* const type =
        find_type([code](const Topology& one) { return one.type.code == code; });
    if (type == nullptr) {
      return document_->fail(topology, "types of elements that XDMF has", std::to_string(code));
    }
    const Vertex count =
        type->vertices == 0 ? next("how many nodes") : static_cast<Vertex>(type->vertices);
    if (count < 0 || count_of(count) > left) {
      return document_->fail(
          topology, "the " + std::to_string(count) + " nodes of " + std::string(type->name),
          "the end of the list, with " + std::to_string(left) + " numbers left");
    }
    vertices.clear();
    for (Vertex i = 0; i < count; ++i) vertices.push_back(next("a node of an element"));
    if (array.text.has_failed()) return array.text.failure();
    if (Status added = add(topology, *type, vertices, line); !added) return added;
  }
  return array.expect_end("the elements");
}

Status XdmfReader::read_topology(pugi::xml_node topology) {
  const std::string_view name = attribute(topology, "TopologyType", "Type");
  Result<XdmfArray> array = document_->array(topology.child("DataItem"), topology);
  if (!array) return tl::unexpected(array.error());
  if (array->text.is_binary() && array->type.kind == NumberType::Kind::kFloating) {
    return document_->fail(topology, "integers", "floating-point numbers");
  }
  if (is_word(name, "mixed")) return read_mixed(topology, *array);
  const ElementType* const type =
      find_type([name](const Topology& one) { return is_word(name, one.name); });
  if (type == nullptr) {
    return document_->fail(
        topology, "TopologyType=\"Triangle\", \"Tetrahedron\", \"Mixed\" or the like", quote(name));
  }
  std::size_t nodes = type->vertices;
  if (nodes == 0) {
    const std::string_view said = topology.attribute("NodesPerElement").value();
    Vertex value = type->shape == kPoint ? 1 : 2;
    if (!said.empty() && (parse_integer(said, value) != std::errc() || value < 1)) {
      return document_->fail(topology, "NodesPerElement=\"N\", 1 or more", quote(said));
    }
    nodes = count_of(value);
  }
  const std::size_t numbers = array->numbers();
  if (numbers % nodes != 0) {
    return document_->fail(topology, std::to_string(nodes) + " nodes of each element",
                           std::to_string(numbers) + " numbers");
  }
  std::vector<Vertex> vertices(nodes);
  for (std::size_t i = 0; i < numbers / nodes; ++i) {
    for (Vertex& v : vertices) {
      v = array->text.take(array->type, {"a node of ", "element", i, numbers / nodes});
    }
    if (array->text.has_failed()) return array->text.failure();
    if (Status added = add(topology, *type, vertices, array->text.line()); !added) return added;
  }
  return array->expect_end("the elements");
}

// A collection may say that it has no elements of its own.
bool has_elements(pugi::xml_node grid) {
  const pugi::xml_node topology = grid.child("Topology");
  return topology && !is_word(attribute(topology, "TopologyType", "Type"), "notopology");
}

// Grids of a collection are inside of another.
Result<ElementFile> XdmfReader::read() {
  pugi::xml_node first;
  std::size_t others = 0;
  for (const pugi::xml_node grid : document_->grids()) {
    if (!has_elements(grid)) continue;
    if (!first && grid.child("Geometry")) {
      first = grid;
    } else {
      ++others;
    }
  }
  if (!first) {
    return document_->fail(document_->root(), "a Grid with a Geometry and a Topology of its own",
                           "none");
  }
  if (others > 0) {
    file_.notes.push_back(document_->name() +
                          ": the first grid with points and elements is read, " +
                          std::to_string(others) + " more are not");
  }
  Status status = read_geometry(first.child("Geometry"));
  if (status) status = read_topology(first.child("Topology"));
  if (!status) return tl::unexpected(status.error());
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_xdmf(std::string_view text) {
  text = from_first_word(text.substr(0, 4096));
  return text.starts_with('<') && text.find("<Xdmf") != std::string_view::npos;
}

Result<ElementFile> read_xdmf(const Source& source, NumberReading reading) {
  Result<std::unique_ptr<XdmfDocument>> document = XdmfDocument::parse(source, reading);
  if (!document) return tl::unexpected(document.error());
  return XdmfReader(std::move(*document)).read();
}

}  // namespace circumspect::formats
