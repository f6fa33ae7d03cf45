#include "oracle/formats/su2.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/vtk_cells.hpp"

namespace circumspect::formats {
namespace {

// How many vertices elements of VTK's types have that SU2 knows.
struct Size {
  Vertex type;
  std::size_t vertices;
};
constexpr std::array kSizes = {Size{1, 1},  Size{3, 2},  Size{5, 3},  Size{9, 4},
                               Size{10, 4}, Size{12, 8}, Size{13, 6}, Size{14, 5}};

constexpr char kComment = '%';

class Su2Reader {
 public:
  Su2Reader(const Source& source, NumberReading reading)
      : lines_(source, '\n', kComment), reading_(reading) {}

  Result<ElementFile> read();

 private:
  // Goes to the next line; is it a key with its value, "NDIME= 3"? It is split there.
  bool next();
  Result<std::size_t> count(const std::string& what);
  Status read_key();
  Status read_number_of_zones();
  Status begin_zone();
  Status expect_whole_zone() const;
  Status read_dimension();
  Status read_points();
  // All lines of a list have as many columns behind what they must have: else one of them lacks a
  // number, or has one too many, and its index would be taken for it.
  Status expect_as_many_behind(std::size_t columns, const std::string& which);
  Status read_elements(const std::string& noun);
  Status read_element(const std::string& noun);

  Lines lines_;
  NumberReading reading_;
  std::string key_;    // empty: the line has none
  std::string value_;  // the first word behind it
  bool is_skipping_ = false;
  Vertex zones_ = 1;
  Vertex zone_ = 0;           // the current one, from 1; 0: before the first
  Vertex first_of_zone_ = 0;  // the place of its first point
  bool has_dimension_ = false;
  bool has_points_ = false;
  bool has_elements_ = false;
  std::optional<std::size_t> behind_;  // so many columns, in the list that is read
  Simplex vertices_;
  ElementFile file_;
};

bool Su2Reader::next() {
  key_.clear();
  value_.clear();
  if (!lines_.next()) return false;
  std::string line;
  for (const std::string_view token : lines_.tokens()) line += std::string(token) + " ";
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos) return true;
  key_ = line.substr(0, line.find_last_not_of(' ', equals == 0 ? 0 : equals - 1) + 1);
  const std::size_t begin = line.find_first_not_of(' ', equals + 1);
  if (begin != std::string::npos) value_ = line.substr(begin, line.find(' ', begin) - begin);
  return true;
}

Result<std::size_t> Su2Reader::count(const std::string& what) {
  Vertex value = 0;
  if (parse_integer(value_, value) == std::errc() && value >= 0) return count_of(value);
  return lines_.fail(what + ", 0 or more", value_.empty() ? "the end of the line" : quote(value_));
}

Status Su2Reader::read_dimension() {
  if (has_dimension_) return lines_.fail("one NDIME", "another");
  has_dimension_ = true;
  const Result<std::size_t> dimension = count("the dimension");
  if (!dimension) return tl::unexpected(dimension.error());
  if (*dimension != 2 && *dimension != 3) return lines_.fail("dimension 2 or 3", quote(value_));
  if (zone_ > 1 && *dimension != file_.points.dimension) {
    return lines_.fail("dimension " + std::to_string(file_.points.dimension) + ", as in zone 1",
                       quote(value_));
  }
  file_.points.dimension = *dimension;
  file_.points.points.set_columns(*dimension);
  return {};
}

Status Su2Reader::expect_as_many_behind(std::size_t columns, const std::string& which) {
  const std::size_t behind = lines_.size() - columns;
  if (!behind_) behind_ = behind;
  if (behind == *behind_) return {};
  return lines_.fail(std::to_string(columns + *behind_) + " columns" + which +
                         ", by those of the first in its list",
                     std::to_string(lines_.size()));
}

Status Su2Reader::read_points() {
  const std::size_t dimension = file_.points.dimension;
  if (!has_dimension_) return lines_.fail("NDIME before NPOIN", "NPOIN");
  if (has_points_) return lines_.fail("one NPOIN", "another");
  has_points_ = true;
  const Result<std::size_t> points = count("the number of points");
  if (!points) return tl::unexpected(points.error());
  behind_.reset();
  for (std::size_t i = 0; i < *points; ++i) {
    const std::string which =
        " of point " + std::to_string(i + 1) + " of " + std::to_string(*points);
    if (!lines_.next()) return lines_.fail_at(0, "the coordinates" + which);
    // Meshes that were cut for several processors have two indices.
    if (lines_.size() < dimension || lines_.size() > dimension + 2) {
      return lines_.fail(std::to_string(dimension) + " coordinates and perhaps the index" + which,
                         std::to_string(lines_.size()) + " columns");
    }
    if (Status as = expect_as_many_behind(dimension, which); !as) return as;
    Status read = lines_.add_numbers(0, dimension, reading_, file_.points.points);
    for (std::size_t column = dimension; read && column < lines_.size(); ++column) {
      const Result<Vertex> index = lines_.integer(column, "the index" + which);
      if (!index) return tl::unexpected(index.error());
    }
    if (!read) return read;
  }
  return {};
}

Status Su2Reader::read_element(const std::string& noun) {
  const Result<Vertex> type = lines_.integer(0, "the type of an " + noun);
  if (!type) return tl::unexpected(type.error());
  const auto* const size = std::find_if(kSizes.begin(), kSizes.end(),
                                        [&](const Size& one) { return one.type == *type; });
  if (size == kSizes.end()) {
    return lines_.fail_at(0, "a type of elements that SU2 knows (3, 5, 9, 10, 12, 13 or 14)");
  }
  if (lines_.size() != 1 + size->vertices && lines_.size() != 2 + size->vertices) {
    return lines_.fail("type " + std::to_string(*type) + ", " + std::to_string(size->vertices) +
                           " vertices and perhaps an index",
                       std::to_string(lines_.size()) + " columns");
  }
  const std::string which = " of an " + noun + " of type " + std::to_string(*type);
  if (Status as = expect_as_many_behind(1 + size->vertices, which); !as) return as;
  const Status vertices = lines_.integers(1, size->vertices, "a vertex", vertices_);
  if (!vertices) return vertices;
  if (lines_.size() > 1 + size->vertices) {
    const Result<Vertex> index = lines_.integer(1 + size->vertices, "the index of an " + noun);
    if (!index) return tl::unexpected(index.error());
  }
  for (Vertex& v : vertices_) {
    if (__builtin_add_overflow(v, first_of_zone_, &v)) return lines_.fail_at(1, "a vertex");
  }
  const auto label = zones_ > 1 ? std::optional(zone_) : std::nullopt;
  add_vtk_cell(file_, *type, vertices_, lines_.line(), label);
  return {};
}

Status Su2Reader::read_elements(const std::string& noun) {
  const Result<std::size_t> elements = count("the number of elements");
  if (!elements) return tl::unexpected(elements.error());
  behind_.reset();
  for (std::size_t i = 0; i < *elements; ++i) {
    bool is_there = lines_.next();
    // Vertices that a zone or a processor sends to another one, and from which side.
    if (i == 0 && is_there && lines_.tokens()[0].starts_with("SEND_TO=")) is_there = lines_.next();
    if (!is_there) {
      return lines_.fail_at(
          0, noun + " " + std::to_string(i + 1) + " of " + std::to_string(*elements));
    }
    if (Status read = read_element(noun); !read) return read;
  }
  return {};
}

Status Su2Reader::read_number_of_zones() {
  const Result<std::size_t> zones = count("the number of zones");
  if (!zones) return tl::unexpected(zones.error());
  if (*zones == 0) return lines_.fail("1 zone or more", "0");
  zones_ = static_cast<Vertex>(*zones);
  return {};
}

// Each zone is a mesh with indices of its own.
Status Su2Reader::begin_zone() {
  const Result<std::size_t> zone = count("the number of a zone");
  if (!zone) return tl::unexpected(zone.error());
  if (static_cast<Vertex>(*zone) != zone_ + 1 || *zone > static_cast<std::size_t>(zones_)) {
    return lines_.fail("zone " + std::to_string(zone_ + 1) + " of " + std::to_string(zones_),
                       quote(value_));
  }
  if (zone_ > 0) {
    if (Status whole = expect_whole_zone(); !whole) return whole;
  }
  ++zone_;
  first_of_zone_ = static_cast<Vertex>(file_.points.points.size());
  has_dimension_ = has_points_ = has_elements_ = false;
  return {};
}

Status Su2Reader::expect_whole_zone() const {
  if (!has_points_) return lines_.fail_at(0, "the key NPOIN");
  if (!has_elements_) return lines_.fail_at(0, "the key NELEM");
  return {};
}

Status Su2Reader::read_key() {
  is_skipping_ = false;
  if (key_ == "NDIME") return read_dimension();
  if (key_ == "NPOIN") return read_points();
  if (key_ == "NELEM") {
    if (has_elements_) return lines_.fail("one NELEM", "another");
    has_elements_ = true;
    return read_elements("element");
  }
  if (key_ == "MARKER_ELEMS") return read_elements("element of a marker");
  if (key_ == "NZONE") return read_number_of_zones();
  if (key_ == "IZONE") return begin_zone();
  is_skipping_ = true;
  return {};
}

Result<ElementFile> Su2Reader::read() {
  while (next()) {
    if (key_.empty() && is_skipping_) continue;
    if (key_.empty()) return lines_.fail_at(0, "a key, as NDIME= 3");
    if (Status key = read_key(); !key) return tl::unexpected(key.error());
  }
  if (Status whole = expect_whole_zone(); !whole) return tl::unexpected(whole.error());
  if (zones_ > 1 && zone_ < zones_) {
    return lines_.fail("zone " + std::to_string(zone_ + 1) + " of " + std::to_string(zones_),
                       "the end of the file");
  }
  if (zones_ > 1) {
    file_.notes.push_back(lines_.file() + ": " + std::to_string(zones_) +
                          " zones are read as one mesh, with the number of the zone as label; "
                          "points are listed one zone after the other");
  }
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_su2(std::string_view text) {
  const Source beginning{"", std::string(text.substr(0, 4096))};
  Lines lines(beginning, '\n', kComment);
  if (!lines.next()) return false;
  const std::string_view first = lines.tokens()[0];
  return first.starts_with("NDIME") || first.starts_with("NZONE");
}

Result<ElementFile> read_su2(const Source& source, NumberReading reading) {
  return Su2Reader(source, reading).read();
}

}  // namespace circumspect::formats
