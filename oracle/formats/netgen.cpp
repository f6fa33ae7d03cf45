#include "oracle/formats/netgen.hpp"

#include <algorithm>
#include <array>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"

namespace circumspect::formats {
namespace {

using enum ElementShape;

// A section of elements: which column is their label, and which says how many nodes follow, or 0 if
// two nodes do.
struct Section {
  std::string_view keyword;
  std::size_t label;
  std::size_t count;
  std::string_view noun;
};
constexpr std::array kSections = {
    Section{"surfaceelements", 1, 4, "a surface element"},
    Section{"surfaceelementsgi", 1, 4, "a surface element"},
    Section{"surfaceelementsuv", 1, 4, "a surface element"},
    Section{"volumeelements", 0, 1, "a volume element"},
    Section{"edgesegments", 0, 0, "a segment"},
    Section{"edgesegmentsgi", 0, 0, "a segment"},
    Section{"edgesegmentsgi2", 0, 0, "a segment"},
};
constexpr std::size_t kNodesOfSegment = 2;  // their column

constexpr std::array kOfSurface = {
    ElementType{0, 3, kPolygon, "a triangle"},
    ElementType{0, 4, kPolygon, "a quadrilateral"},
    ElementType{0, 6, kCurvedTriangle, "a triangle of second order"},
    ElementType{0, 8, kCurved, "a quadrilateral of second order"},
};
constexpr std::array kOfVolume = {
    ElementType{0, 4, kTetrahedron, "a tetrahedron"},
    ElementType{0, 5, kOtherSolid, "a pyramid"},
    ElementType{0, 6, kOtherSolid, "a prism"},
    ElementType{0, 8, kOtherSolid, "a hexahedron"},
    ElementType{0, 10, kCurvedTetrahedron, "a tetrahedron of second order"},
    ElementType{0, 13, kCurved, "a pyramid of second order"},
    ElementType{0, 15, kCurved, "a prism of second order"},
    ElementType{0, 20, kCurved, "a hexahedron of second order"},
};
constexpr ElementType kSegment = {0, 2, kPolyline, "an edge"};

template <std::size_t kCount>
const ElementType* type_of(const std::array<ElementType, kCount>& types, std::size_t nodes) {
  const auto* const found =
      std::find_if(types.begin(), types.end(),
                   [nodes](const ElementType& type) { return type.vertices == nodes; });
  return found == types.end() ? nullptr : found;
}

class NetgenReader {
 public:
  NetgenReader(const Source& source, NumberReading reading) : lines_(source), reading_(reading) {}

  Result<ElementFile> read();

 private:
  Result<std::size_t> read_count(std::string_view of);
  Status read_elements(const Section& section);
  Status read_element(const Section& section);
  Status read_points();

  Lines lines_;
  NumberReading reading_;
  ElementFile file_;
  Simplex nodes_;
  bool has_points_ = false;
};

Result<std::size_t> NetgenReader::read_count(std::string_view of) {
  const std::string what = "the number of " + std::string(of);
  if (!lines_.next()) return lines_.fail_at(0, what);
  return lines_.count(0, what);
}

Status NetgenReader::read_element(const Section& section) {
  const ElementType* type = &kSegment;
  std::size_t first = kNodesOfSegment;
  if (section.count > 0) {
    const std::string words = "the number of nodes of " + std::string(section.noun);
    if (lines_.size() <= section.count) return lines_.fail_at(lines_.size(), words);
    const Result<std::size_t> nodes = lines_.count(section.count, words);
    if (!nodes) return tl::unexpected(nodes.error());
    const bool is_of_volume = section.keyword == "volumeelements";
    type = is_of_volume ? type_of(kOfVolume, *nodes) : type_of(kOfSurface, *nodes);
    if (type == nullptr) return lines_.fail_at(section.count, words + ", as 3 or 4");
    first = section.count + 1;
  }
  if (lines_.size() < first + type->vertices) {
    return lines_.fail_at(lines_.size(), "a node of " + std::string(type->name));
  }
  if (Status read = lines_.integers(first, type->vertices, "a node", nodes_); !read) return read;
  const Result<Vertex> label = lines_.integer(section.label, "a label");
  if (!label) return tl::unexpected(label.error());
  add_element(file_, type->shape, nodes_, type->name, lines_.line(), *label);
  return {};
}

Status NetgenReader::read_elements(const Section& section) {
  const Result<std::size_t> count = read_count("elements");
  if (!count) return tl::unexpected(count.error());
  for (std::size_t i = 0; i < *count; ++i) {
    if (!lines_.next()) return lines_.fail_at(0, Item("", section.noun, i, *count).words());
    if (Status element = read_element(section); !element) return element;
  }
  return {};
}

Status NetgenReader::read_points() {
  const Result<std::size_t> count = read_count("points");
  if (!count) return tl::unexpected(count.error());
  if (has_points_) return lines_.fail("one section of points", "another");
  has_points_ = true;
  for (std::size_t i = 0; i < *count; ++i) {
    if (!lines_.next() || lines_.size() != 3) {
      return lines_.fail_at(lines_.size() < 3 ? lines_.size() : 3,
                            "3 coordinates of " + Item("", "point", i, *count).words());
    }
    if (Status read = lines_.add_numbers(0, 3, reading_, file_.points.points); !read) return read;
  }
  return {};
}

Result<ElementFile> NetgenReader::read() {
  file_.points.first_index = 1;
  file_.points.dimension = 3;
  file_.points.points.set_columns(3);
  if (!lines_.next() || lines_.tokens()[0] != "mesh3d") {
    return lines_.fail_at(0, "the keyword mesh3d");
  }
  while (lines_.next() && lines_.tokens()[0] != "endmesh") {
    const auto* const section =
        std::find_if(kSections.begin(), kSections.end(),
                     [&](const Section& one) { return one.keyword == lines_.tokens()[0]; });
    Status status;
    if (section != kSections.end()) {
      status = read_elements(*section);
    } else if (lines_.tokens()[0] == "points") {
      status = read_points();
    }
    if (!status) return tl::unexpected(status.error());
  }
  if (!has_points_) return lines_.fail("the section points", "the end of the file");
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_netgen(const Beginning& beginning) { return beginning.first_token == "mesh3d"; }

Result<ElementFile> read_netgen(const Source& source, NumberReading reading) {
  return NetgenReader(source, reading).read();
}

}  // namespace circumspect::formats
