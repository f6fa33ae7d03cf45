#include "oracle/formats/nastran.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "oracle/formats/bytes/text_lines.hpp"
#include "oracle/formats/nastran_entries.hpp"
#include "oracle/formats/nastran_systems.hpp"
#include "oracle/formats/node_tags.hpp"

namespace circumspect::formats {
namespace {

using enum ElementShape;

// Entries of elements: the place of the first node among the fields, how many corners there are,
// how many nodes at most, and the shape without and with nodes between the corners.
struct EntryType {
  std::string_view name;
  std::size_t first;
  std::size_t corners;
  std::size_t nodes;
  ElementShape shape;
  ElementShape curved;
  std::string_view words;
};
constexpr std::array kEntryTypes = {
    EntryType{"CTETRA", 2, 4, 10, kTetrahedron, kCurvedTetrahedron, "a tetrahedron"},
    EntryType{"CPYRA", 2, 5, 13, kOtherSolid, kCurved, "a pyramid"},
    EntryType{"CPYRAM", 2, 5, 13, kOtherSolid, kCurved, "a pyramid"},
    EntryType{"CPENTA", 2, 6, 15, kOtherSolid, kCurved, "a prism"},
    EntryType{"CHEXA", 2, 8, 20, kOtherSolid, kCurved, "a hexahedron"},
    EntryType{"CTRIA3", 2, 3, 3, kPolygon, kPolygon, "a triangle"},
    EntryType{"CTRIAR", 2, 3, 3, kPolygon, kPolygon, "a triangle"},
    EntryType{"CTRIA6", 2, 3, 6, kPolygon, kCurvedTriangle, "a triangle"},
    EntryType{"CQUAD4", 2, 4, 4, kPolygon, kPolygon, "a quadrilateral"},
    EntryType{"CQUADR", 2, 4, 4, kPolygon, kPolygon, "a quadrilateral"},
    EntryType{"CSHEAR", 2, 4, 4, kPolygon, kPolygon, "a quadrilateral"},
    EntryType{"CQUAD8", 2, 4, 8, kPolygon, kCurved, "a quadrilateral"},
    EntryType{"CQUAD", 2, 4, 9, kPolygon, kCurved, "a quadrilateral"},
    EntryType{"CROD", 2, 2, 2, kPolyline, kPolyline, "an edge"},
    EntryType{"CTUBE", 2, 2, 2, kPolyline, kPolyline, "an edge"},
    EntryType{"CBAR", 2, 2, 2, kPolyline, kPolyline, "an edge"},
    EntryType{"CBEAM", 2, 2, 2, kPolyline, kPolyline, "an edge"},
    EntryType{"CONROD", 1, 2, 2, kPolyline, kPolyline, "an edge"},
};

constexpr std::size_t kPlaceOfSystem = 1;

class NastranReader {
 public:
  NastranReader(const Source& source, NumberReading reading)
      : entries_(source), name_(source.name), reading_(reading) {}

  Result<ElementFile> read();

 private:
  Status read_entry();
  Status read_node();
  // The system of coordinates of a node, 0 for the basic one.
  Result<Vertex> read_system() const;
  // Moves the nodes of other systems to the basic one.
  Status place_nodes();
  Status read_element(const EntryType& type);

  NastranEntries entries_;
  std::string name_;
  NumberReading reading_;
  bool has_elements_ = false;
  std::vector<Vertex> tags_;
  // Nodes of other systems than the basic one.
  struct Moved {
    std::size_t node = 0;
    std::size_t line = 0;
    Vertex system = 0;
  };
  std::vector<Moved> moved_;
  NastranSystems systems_;
  Vertex usual_system_ = 0;  // GRDSET
  Simplex vertices_;
  ElementFile file_;
};

Result<Vertex> NastranReader::read_system() const {
  const auto system = entries_.integer(kPlaceOfSystem, "a system of coordinates");
  if (!system) return tl::unexpected(system.error());
  return system->value_or(entries_.entry().name == "GRID" ? usual_system_ : 0);
}

// Systems may be defined behind the nodes that are given in them.
Status NastranReader::place_nodes() {
  if (moved_.empty()) return {};
  std::vector<Point> points = file_.points.points.points();
  for (const Moved& moved : moved_) {
    std::optional<Point> place = systems_.in_basic(points[moved.node], moved.system);
    if (place) {
      points[moved.node] = std::move(*place);
      continue;
    }
    return tl::unexpected(
        FormatError{name_, moved.line,
                    "GRID " + std::to_string(tags_[moved.node]) +
                        " in the basic system of coordinates, 0, or in one whose points have exact "
                        "places there",
                    systems_.words(moved.system) +
                        " (write the mesh in the basic system: here it would have to be rounded)"});
  }
  PointRows placed;
  placed.set_columns(3);
  for (const Point& point : points) placed.push_back(point);
  file_.points.points = std::move(placed);
  file_.notes.push_back(name_ + ": " + std::to_string(moved_.size()) +
                        " nodes are given in other systems of coordinates, and were moved from "
                        "there exactly");
  return {};
}

Status NastranReader::read_node() {
  const auto tag = entries_.integer(0, "the tag of a node");
  if (!tag) return tl::unexpected(tag.error());
  if (!*tag) return entries_.fail_at(0, "the tag of a node");
  const Result<Vertex> system = read_system();
  if (!system) return tl::unexpected(system.error());
  if (*system != 0) moved_.push_back({tags_.size(), entries_.entry().line, *system});
  tags_.push_back(**tag);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto number = entries_.number(2 + axis, reading_);
    if (!number) return tl::unexpected(number.error());
    file_.points.points.add(number->value_or(0));
  }
  return {};
}

Status NastranReader::read_element(const EntryType& type) {
  has_elements_ = true;
  const auto tag = entries_.integer(0, "the tag of an element");
  if (!tag) return tl::unexpected(tag.error());
  auto label = type.first == 2 ? entries_.integer(1, "a property") : std::nullopt;
  if (!label) return tl::unexpected(label.error());
  vertices_.clear();
  for (std::size_t i = 0; i < type.nodes; ++i) {
    const auto node = entries_.integer(type.first + i, "a node of an element");
    if (!node) return tl::unexpected(node.error());
    // Nodes between corners may be missing, and are 0 then in some files.
    const bool is_missing = node->value_or(0) == 0;
    if (is_missing && i < type.corners) {
      return entries_.fail_at(type.first + i, std::string(type.words) + " of " +
                                                  std::to_string(type.corners) + " nodes");
    }
    if (!is_missing) vertices_.push_back(**node);
  }
  const bool is_curved = vertices_.size() > type.corners;
  const std::string words = std::string(type.words) + (is_curved ? " of second order" : "");
  add_element(file_, is_curved ? type.curved : type.shape, vertices_, words, entries_.entry().line,
              label->value_or(tag->value_or(0)));
  return {};
}

Status NastranReader::read_entry() {
  const std::string& name = entries_.entry().name;
  if (name == "GRID") return read_node();
  if (NastranSystems::defines(name)) return systems_.add(entries_, reading_);
  if (name == "GRDSET") {
    const Result<Vertex> system = read_system();
    if (!system) return tl::unexpected(system.error());
    usual_system_ = *system;
    return {};
  }
  if (name.starts_with("GRID ")) {  // a comma in a number, not behind the name
    return tl::unexpected(FormatError{name_, entries_.entry().line,
                                      "fields in columns, or each behind a comma", quote(name)});
  }
  if (name.starts_with("INCLUDE")) {
    return tl::unexpected(FormatError{name_, entries_.entry().line, "a file to include", name});
  }
  const auto* const type = std::find_if(kEntryTypes.begin(), kEntryTypes.end(),
                                        [&](const EntryType& one) { return one.name == name; });
  return type == kEntryTypes.end() ? Status{} : read_element(*type);
}

Result<ElementFile> NastranReader::read() {
  file_.points.dimension = 3;
  file_.points.points.set_columns(3);
  while (entries_.next()) {
    if (Status entry = read_entry(); !entry) return tl::unexpected(entry.error());
  }
  if (tags_.empty()) return entries_.fail_at_end("an entry GRID");
  if (!has_elements_) return entries_.fail_at_end("an entry of elements, as CTETRA");
  if (Status placed = place_nodes(); !placed) return tl::unexpected(placed.error());
  Status tags = index_by_tags(file_, std::move(tags_), name_, "of a GRID");
  if (!tags) return tl::unexpected(tags.error());
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_nastran(const Beginning& beginning) {
  const Source text{"", std::string(beginning.text.substr(0, 4096))};
  TextLines lines(text);
  while (lines.next()) {
    const std::string line = upper(without_blanks(lines.text()));
    if (line.starts_with("BEGIN BULK") || line.starts_with("GRID,") || line.starts_with("GRID ") ||
        line.starts_with("GRID*")) {
      return true;
    }
  }
  return false;
}

std::optional<Inclusion> nastran_inclusion(TextLines lines) {
  constexpr std::string_view kName = "INCLUDE";
  constexpr std::size_t kMostLines = 20;
  std::string_view text = without_blanks(lines.text());
  if (text.size() < kName.size() || upper(text.substr(0, kName.size())) != kName) return {};
  text.remove_prefix(kName.size());
  if (!text.empty() && std::isalnum(static_cast<unsigned char>(text.front())) != 0) return {};
  text = without_blanks(text);
  if (!text.starts_with('\'') && !text.starts_with('"')) {
    return Inclusion{std::string(without_blanks(text.substr(0, text.find('$'))))};
  }
  const char mark = text.front();
  Inclusion inclusion;
  text.remove_prefix(1);
  while (text.find(mark) == std::string_view::npos) {
    inclusion.path += without_blanks(text);
    if (inclusion.lines == kMostLines || !lines.next()) return inclusion;
    ++inclusion.lines;
    text = lines.text();
  }
  inclusion.path += without_blanks(text.substr(0, text.find(mark)));
  return inclusion;
}

Result<ElementFile> read_nastran(const Source& source, NumberReading reading) {
  return NastranReader(source, reading).read();
}

}  // namespace circumspect::formats
