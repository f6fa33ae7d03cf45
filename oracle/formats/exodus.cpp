#include "oracle/formats/exodus.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "oracle/formats/netcdf.hpp"
#include "oracle/formats/other_kinds.hpp"

namespace circumspect::formats {
namespace {

using enum ElementShape;

// What elements are whose type begins so, of the fewest nodes (0: any number) and of more.
struct Family {
  std::string_view begin;  // in small letters
  ElementType few;
  ElementType more;
};
constexpr ElementType kPointElement = {0, 0, kPoint, "a point"};
constexpr ElementType kEdgeElement = {0, 2, kPolyline, "an edge"};
constexpr ElementType kCurvedEdgeElement = {0, 3, kCurvedEdge, "an edge of second order"};
constexpr ElementType kQuad = {0, 4, kPolygon, "a quadrilateral"};
constexpr ElementType kCurvedQuad = {0, 5, kCurved, "a quadrilateral of second order"};
constexpr ElementType kTriangle = {0, 3, kPolygon, "a triangle"};
constexpr ElementType kCurvedTri = {0, 4, kCurvedTriangle, "a triangle of second order"};
constexpr ElementType kPrism = {0, 6, kOtherSolid, "a prism"};
constexpr ElementType kCurvedPrism = {0, 7, kCurved, "a prism of second order"};
constexpr std::array kFamilies = {
    Family{"sphere", kPointElement, kPointElement},
    Family{"circle", kPointElement, kPointElement},
    Family{"point", kPointElement, kPointElement},
    Family{"bar", kEdgeElement, kCurvedEdgeElement},
    Family{"beam", kEdgeElement, kCurvedEdgeElement},
    Family{"edge", kEdgeElement, kCurvedEdgeElement},
    Family{"truss", kEdgeElement, kCurvedEdgeElement},
    Family{"tri", kTriangle, kCurvedTri},
    Family{"quad", kQuad, kCurvedQuad},
    Family{"shell", kQuad, kCurvedQuad},
    Family{"tet",
           {0, 4, kTetrahedron, "a tetrahedron"},
           {0, 5, kCurvedTetrahedron, "a tetrahedron of second order"}},
    Family{"hex",
           {0, 8, kOtherSolid, "a hexahedron"},
           {0, 9, kCurved, "a hexahedron of second order"}},
    Family{"wedge", kPrism, kCurvedPrism},
    Family{"prism", kPrism, kCurvedPrism},
    Family{
        "pyramid", {0, 5, kOtherSolid, "a pyramid"}, {0, 6, kCurved, "a pyramid of second order"}},
    Family{"nsided", {0, 0, kPolygon, "a polygon"}, {0, 0, kPolygon, "a polygon"}},
    Family{"nfaced", {0, 0, kOtherSolid, "a polyhedron"}, {0, 0, kOtherSolid, "a polyhedron"}},
};

// Shells have three nodes or four.
const ElementType* type_of(std::string_view name, std::size_t nodes) {
  const auto is = [&](const Family& one) {
    return name.size() >= one.begin.size() && is_word(name.substr(0, one.begin.size()), one.begin);
  };
  const auto* const found = std::find_if(kFamilies.begin(), kFamilies.end(), is);
  if (found == kFamilies.end()) return nullptr;
  const bool is_shell = found->begin == "shell";
  if (is_shell && nodes == kTriangle.vertices) return &kTriangle;
  if (is_shell && nodes == 6) return &kCurvedTri;
  if (found->few.vertices == 0 || nodes == found->few.vertices) return &found->few;
  return nodes >= found->more.vertices ? &found->more : nullptr;
}

class ExodusReader {
 public:
  ExodusReader(const Source& source, NumberReading reading) : source_(source), reading_(reading) {}

  Result<ElementFile> read();

 private:
  tl::unexpected<FormatError> fail(std::string expected, std::string found) const {
    return tl::unexpected(FormatError{source_.name, 0, std::move(expected), std::move(found)});
  }
  const NetcdfVariable* find(std::string_view name) const {
    const auto found = variables_.find(name);
    return found == variables_.end() ? nullptr : &found->second;
  }
  // The numbers of the axes, of each in an array of its own or of all in one.
  Result<std::vector<PointRows>> read_axes();
  Status read_points();
  Status read_block(const std::string& name, const NetcdfVariable& block, Vertex label);
  Result<std::vector<Vertex>> read_labels();

  const Source& source_;
  NumberReading reading_;
  NetcdfVariables variables_;
  ElementFile file_;
};

Result<std::vector<PointRows>> ExodusReader::read_axes() {
  std::vector<PointRows> axes;
  const auto read = [&](MixedText& numbers, const NetcdfVariable& of, std::size_t count) -> Status {
    axes.emplace_back().set_columns(1);
    return numbers.points(of.type, count, {"a coordinate of ", "point", 0, count}, axes.back());
  };
  if (const NetcdfVariable* const all = find("coord"); all != nullptr) {
    if (all->lengths.size() != 2) return fail("two dimensions of \"coord\"", "another number");
    Result<MixedText> numbers = netcdf_numbers(source_, "coord", *all, reading_);
    if (!numbers) return tl::unexpected(numbers.error());
    for (std::size_t axis = 0; axis < std::min<std::size_t>(all->lengths[0], 3); ++axis) {
      if (Status one = read(*numbers, *all, all->lengths[1]); !one) {
        return tl::unexpected(one.error());
      }
    }
    return axes;
  }
  for (const char* const name : {"coordx", "coordy", "coordz"}) {
    const NetcdfVariable* const one = find(name);
    if (one == nullptr) break;
    if (one->lengths.size() != 1) return fail("one dimension of " + quote(name), "another number");
    Result<MixedText> numbers = netcdf_numbers(source_, name, *one, reading_);
    if (!numbers) return tl::unexpected(numbers.error());
    if (Status axis = read(*numbers, *one, one->lengths[0]); !axis) {
      return tl::unexpected(axis.error());
    }
  }
  return axes;
}

Status ExodusReader::read_points() {
  const Result<std::vector<PointRows>> axes = read_axes();
  if (!axes) return tl::unexpected(axes.error());
  if (axes->empty()) return fail("coordinates, as \"coordx\" or \"coord\"", "none");
  file_.points.dimension = axes->size();
  file_.points.points.set_columns(axes->size());
  const std::size_t count = axes->front().size();
  for (const PointRows& axis : *axes) {
    if (axis.size() == count) continue;
    return fail(std::to_string(count) + " coordinates along each axis",
                std::to_string(axis.size()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (const PointRows& axis : *axes) file_.points.points.add(axis.at(i, 0));
  }
  return {};
}

Status ExodusReader::read_block(const std::string& name, const NetcdfVariable& block,
                                Vertex label) {
  const auto named = block.texts.find("elem_type");
  std::string type_name = named == block.texts.end() ? "" : named->second;
  type_name.erase(std::find(type_name.begin(), type_name.end(), '\0'), type_name.end());
  const std::size_t nodes = block.lengths.empty() ? 0 : block.lengths.back();
  const ElementType* const type = type_of(type_name, nodes);
  if (type == nullptr) {
    return fail("a type of the elements of " + quote(name) + " that is known, as \"TETRA4\"",
                quote(type_name) + " of " + std::to_string(nodes) + " nodes");
  }
  if (block.lengths.size() != 2) {  // polygons and polyhedra, whose sizes are elsewhere
    file_.first_other = ElementFile::Named{std::string(type->name), 0};
    return {};
  }
  Result<MixedText> numbers = netcdf_numbers(source_, name, block, reading_);
  if (!numbers) return tl::unexpected(numbers.error());
  const std::string_view noun = type->name.substr(type->name.find(' ') + 1);
  std::vector<Vertex> vertices(nodes);
  for (std::size_t i = 0; i < block.lengths[0]; ++i) {
    for (Vertex& v : vertices) v = numbers->take(block.type, {"a node of ", noun, i, 0});
    if (numbers->has_failed()) return numbers->failure();
    add_element(file_, type->shape, vertices, type->name, 0, label);
  }
  return {};
}

// Of blocks in their order; none if the file does not number them.
Result<std::vector<Vertex>> ExodusReader::read_labels() {
  std::vector<Vertex> labels;
  const NetcdfVariable* const property = find("eb_prop1");
  if (property == nullptr || property->lengths.size() != 1) return labels;
  Result<MixedText> numbers = netcdf_numbers(source_, "eb_prop1", *property, reading_);
  if (!numbers) return tl::unexpected(numbers.error());
  for (std::size_t i = 0; i < property->lengths[0]; ++i) {
    labels.push_back(numbers->take(property->type, {"the number of a block"}));
  }
  if (numbers->has_failed()) return numbers->failure();
  return labels;
}

Result<ElementFile> ExodusReader::read() {
  if (source_.text.starts_with("\x89HDF")) {
    return fail("netCDF in its classic format",
                "netCDF in HDF5 (" +
                    read_by_meshio("IN.e", "exodus", "python3-meshio and python3-netcdf4") + ")");
  }
  Result<NetcdfVariables> variables = read_netcdf(source_);
  if (!variables) return tl::unexpected(variables.error());
  variables_ = std::move(*variables);
  file_.points.first_index = 1;
  Status status = read_points();
  if (!status) return tl::unexpected(status.error());
  const Result<std::vector<Vertex>> labels = read_labels();
  if (!labels) return tl::unexpected(labels.error());
  // Empty blocks have no list, but a number.
  for (std::size_t b = 1; b <= std::max(labels->size(), variables_.size()); ++b) {
    const std::string name = "connect" + std::to_string(b);
    const NetcdfVariable* const block = find(name);
    if (block == nullptr) continue;
    const Vertex label = b <= labels->size() ? (*labels)[b - 1] : static_cast<Vertex>(b);
    if (status = read_block(name, *block, label); !status) return tl::unexpected(status.error());
  }
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_exodus(const Beginning& beginning) { return is_netcdf(beginning.text); }

Result<ElementFile> read_exodus(const Source& source, NumberReading reading) {
  return ExodusReader(source, reading).read();
}

}  // namespace circumspect::formats
