#include "oracle/formats/ply.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/lines.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::formats {
namespace {

using Kind = PlyType::Kind;

// Where values come from, line by line or byte by byte.
class PlyRows {
 public:
  virtual ~PlyRows() = default;
  // Goes to a row; an error if the file has ended. `what` names it, and outlives the row.
  virtual Status begin_row(const Item& what) = 0;
  virtual Status end_row() = 0;
  virtual Result<std::size_t> read_count(PlyType type) = 0;
  virtual Status skip(PlyType type, std::size_t count) = 0;
  virtual Result<Vertex> read_index(PlyType type) = 0;
  virtual Status read_number(PlyType type, Rational& to) = 0;
  virtual Status add_number(PlyType type, PointRows& to) = 0;
  virtual std::size_t line() const = 0;
  virtual Status expect_end() = 0;
};

class TextRows final : public PlyRows {
 public:
  TextRows(Lines& lines, NumberReading reading) : lines_(lines), reading_(reading) {}

  Status begin_row(const Item& what) override {
    column_ = 0;
    if (lines_.next()) return {};
    return lines_.fail(what.words(), "the end of the file");
  }
  Status end_row() override {
    if (column_ == lines_.size()) return {};
    return lines_.fail_at(column_, "the end of the line");
  }
  Result<std::size_t> read_count(PlyType) override {
    if (column_ == lines_.size()) return lines_.fail_at(column_, "the number of values of a list");
    return lines_.count(column_++, "the number of values of a list");
  }
  Status skip(PlyType, std::size_t count) override {
    if (count > lines_.size() - column_) {
      return lines_.fail_at(lines_.size(), std::to_string(count) + " values");
    }
    column_ += count;
    return {};
  }
  Result<Vertex> read_index(PlyType) override {
    if (column_ == lines_.size()) return lines_.fail_at(column_, "a vertex");
    if (const auto plain = lines_.plain_integer(column_)) {
      ++column_;
      return *plain;
    }
    return lines_.integer(column_++, "a vertex");
  }
  Status read_number(PlyType, Rational& to) override {
    if (column_ == lines_.size()) return lines_.fail_at(column_, "a coordinate");
    Result<Rational> number = lines_.number(column_++, reading_);
    if (!number) return tl::unexpected(number.error());
    to = std::move(*number);
    return {};
  }
  Status add_number(PlyType, PointRows& to) override {
    if (column_ == lines_.size()) return lines_.fail_at(column_, "a coordinate");
    return lines_.add_numbers(column_++, 1, reading_, to);
  }
  std::size_t line() const override { return lines_.line(); }
  Status expect_end() override {
    if (!lines_.next()) return {};
    return lines_.fail_at(0, "the end of the file after the last element");
  }

 private:
  Lines& lines_;
  NumberReading reading_;
  std::size_t column_ = 0;
};

class BinaryRows final : public PlyRows {
 public:
  // `end`: where the bytes end in the file.
  BinaryRows(std::string name, Bytes bytes, std::size_t end)
      : name_(std::move(name)), bytes_(bytes), end_(end) {}

  Status begin_row(const Item& what) override {
    what_ = what;
    go_on();
    if (bytes_.left() == 0) return ended();
    return {};
  }
  Status end_row() override { return {}; }
  Result<std::size_t> read_count(PlyType type) override {
    const Result<Vertex> count = read_index(type);
    if (!count) return tl::unexpected(count.error());
    if (*count < 0)
      return fail("a list of 0 or more values in " + what_.words(), std::to_string(*count));
    return count_of(*count);
  }
  Status skip(PlyType type, std::size_t count) override {
    go_on();
    // The count may be anything, so it is not multiplied before it is known to be small.
    if (count > bytes_.left() / type.size) return ended();
    bytes_.skip(count * type.size);
    return {};
  }
  Result<Vertex> read_index(PlyType type) override {
    go_on();
    const auto bits = bytes_.unsigned_integer(type.size);
    if (!bits) return ended();
    return type.kind == Kind::kSigned ? as_signed(*bits, type.size) : static_cast<Vertex>(*bits);
  }
  Status read_number(PlyType type, Rational& to) override {
    if (type.kind != Kind::kFloating) {
      const Result<Vertex> value = read_index(type);
      if (!value) return tl::unexpected(value.error());
      to = Rational(to_integer(*value));
      return {};
    }
    double number = 0;
    Status read = read_floating(type, number);
    if (read) to = exact_value(number);
    return read;
  }
  Status add_number(PlyType type, PointRows& to) override {
    double number = 0;
    if (type.kind == Kind::kFloating) {
      Status read = read_floating(type, number);
      if (read) to.add(number);
      return read;
    }
    Rational exact;
    Status read = read_number(type, exact);
    if (read) to.add(std::move(exact));
    return read;
  }
  std::size_t line() const override { return 0; }
  Status expect_end() override {
    if (bytes_.left() == 0) return {};
    go_on();
    return fail("the end of the file after the last element",
                std::to_string(bytes_.left()) + " more bytes");
  }

 private:
  // A finite number, and not −0.
  Status read_floating(PlyType type, double& number) {
    go_on();
    const auto bits = bytes_.unsigned_integer(type.size);
    if (!bits) return ended();
    number = double_of_bits(*bits, type.size) + 0.0;
    if (std::isfinite(number)) return {};
    return fail("finite coordinates of " + what_.words(), "NaN or an infinity");
  }
  tl::unexpected<FormatError> fail(std::string expected, std::string found) const {
    return tl::unexpected(
        FormatError{name_, 0, std::move(expected), found + " at byte " + std::to_string(at_)});
  }
  void go_on() { at_ = end_ - bytes_.left(); }
  tl::unexpected<FormatError> ended() const { return fail(what_.words(), "the end of the file"); }

  std::string name_;
  Bytes bytes_;
  std::size_t end_;
  std::size_t at_ = 0;  // where what is read next, or was read last, begins
  Item what_ = "";
};

Status skip_property(PlyRows& rows, const PlyProperty& property) {
  if (!property.count) return rows.skip(property.type, 1);
  const Result<std::size_t> count = rows.read_count(*property.count);
  if (!count) return tl::unexpected(count.error());
  return rows.skip(property.type, *count);
}

// Calls `read` for each row with the number of each property; `read` reads it or returns false.
template <class Read>
Status for_each_row(PlyRows& rows, const PlyElement& element, const Read& read) {
  const bool is_known = element.name == "vertex" || element.name == "face";
  const std::string noun = is_known ? element.name : "element " + quote(element.name);
  for (std::size_t i = 0; i < element.count; ++i) {
    Status status = rows.begin_row({"", noun, i, element.count});
    for (std::size_t j = 0; status && j < element.properties.size(); ++j) {
      const Result<bool> was_read = read(j);
      if (!was_read) return tl::unexpected(was_read.error());
      if (!*was_read) status = skip_property(rows, element.properties[j]);
    }
    if (status) status = rows.end_row();
    if (!status) return status;
  }
  return {};
}

Status read_points(PlyRows& rows, const PlyElement& element, PointRows& points) {
  const std::array<std::size_t, 3> places = {*element.find("x", false), *element.find("y", false),
                                             *element.find("z", false)};
  // Usually the coordinates come in their order, and need no place of their own.
  const bool are_in_order = places[0] < places[1] && places[1] < places[2];
  Point point(3);
  points.set_columns(3);
  return for_each_row(rows, element, [&](std::size_t j) -> Result<bool> {
    const auto* const found = std::find(places.begin(), places.end(), j);
    if (found != places.end()) {
      const PlyType type = element.properties[j].type;
      const Status number =
          are_in_order
              ? rows.add_number(type, points)
              : rows.read_number(type, point[static_cast<std::size_t>(found - places.begin())]);
      if (!number) return tl::unexpected(number.error());
    }
    if (!are_in_order && j + 1 == element.properties.size()) points.push_back(point);
    return found != places.end();
  });
}

Status read_faces(PlyRows& rows, const PlyElement& element, std::size_t place, SimplexFile& faces) {
  const PlyProperty& list = element.properties[place];
  Simplex face;
  return for_each_row(rows, element, [&](std::size_t j) -> Result<bool> {
    if (j != place) return false;
    const Result<std::size_t> count = rows.read_count(*list.count);
    if (!count) return tl::unexpected(count.error());
    face.clear();
    while (face.size() < *count) {
      const Result<Vertex> index = rows.read_index(list.type);
      if (!index) return tl::unexpected(index.error());
      face.push_back(*index);
    }
    faces.simplices.push_back(face);
    faces.lines.push_back(rows.line());
    return true;
  });
}

// A strip joins each vertex to the two before it, and -1 ends it. Every second triangle is listed
// with its first two vertices exchanged, so that all are turned alike.
Status read_strips(PlyRows& rows, const PlyElement& element, std::size_t place,
                   SimplexFile& faces) {
  SimplexFile strips;
  if (Status read = read_faces(rows, element, place, strips); !read) return read;
  for (std::size_t i = 0; i < strips.simplices.size(); ++i) {
    const Simplex strip = strips.simplices[i];
    std::size_t begin = 0;
    for (std::size_t j = 0; j < strip.size(); ++j) {
      if (strip[j] < 0) begin = j + 1;
      if (j < begin + 2) continue;
      const bool is_even = (j - begin) % 2 == 0;
      faces.simplices.push_back(
          Simplex{strip[is_even ? j - 2 : j - 1], strip[is_even ? j - 1 : j - 2], strip[j]});
      faces.lines.push_back(strips.lines[i]);
    }
  }
  return {};
}

// The list of vertices among the properties of a face.
std::optional<std::size_t> corners_of(const PlyElement& element) {
  const auto indices = element.find("vertex_indices", true);
  return indices ? indices : element.find("vertex_index", true);
}

Status check_header(const Lines& lines, const PlyHeader& header, bool wants_faces) {
  bool has_points = false;
  bool has_faces = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      if (has_points || !element.find("x", false) || !element.find("y", false) ||
          !element.find("z", false)) {
        return lines.fail("one element vertex with properties x, y, z",
                          has_points ? "two elements" : "another element vertex");
      }
      has_points = true;
    } else if (element.name == "face" || element.name == "tristrips") {
      const auto place = corners_of(element);
      if (has_faces || !place || element.properties[*place].type.kind == Kind::kFloating) {
        return lines.fail("one element face, or tristrips, with a list of integers vertex_indices",
                          has_faces ? "two elements" : "another element " + element.name);
      }
      has_faces = true;
    }
  }
  if (has_points && (has_faces || !wants_faces)) return {};
  return lines.fail(wants_faces ? "elements vertex and face" : "an element vertex",
                    has_points ? "no element face" : "no element vertex");
}

Result<PlyFile> read_ply_body(PlyRows& rows, const PlyHeader& header) {
  PlyFile file;
  file.points.dimension = 3;
  for (const PlyElement& element : header.elements) {
    Status status;
    if (element.name == "vertex") {
      status = read_points(rows, element, file.points.points);
    } else if (element.name == "face") {
      status = read_faces(rows, element, *corners_of(element), file.faces);
    } else if (element.name == "tristrips") {
      status = read_strips(rows, element, *corners_of(element), file.faces);
    } else {
      status = for_each_row(rows, element, [](std::size_t) -> Result<bool> { return false; });
    }
    if (!status) return tl::unexpected(status.error());
  }
  if (Status end = rows.expect_end(); !end) return tl::unexpected(end.error());
  file.faces.vertices_per_simplex = file.faces.simplices.columns();
  return file;
}

// The line end: a carriage return alone, if the first line ends with one.
char end_of_lines(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  if (end == std::string_view::npos || text[end] == '\n') return '\n';
  const std::size_t next = text.find_first_not_of('\r', end);
  return next != std::string_view::npos && text[next] == '\n' ? '\n' : '\r';
}

Result<PlyFile> read_points_and_faces(const Source& source, NumberReading reading,
                                      bool wants_faces) {
  Lines lines(source, end_of_lines(source.text));
  const Result<PlyHeader> header = read_ply_header(lines);
  if (!header) return tl::unexpected(header.error());
  if (Status known = check_header(lines, *header, wants_faces); !known) {
    return tl::unexpected(known.error());
  }
  if (!header->binary) {
    TextRows rows(lines, reading);
    return read_ply_body(rows, *header);
  }
  const std::string_view text = source.text;
  BinaryRows rows(source.name,
                  Bytes(text.substr(text.size() - lines.bytes_left()), *header->binary),
                  text.size());
  return read_ply_body(rows, *header);
}

}  // namespace

Result<PlyFile> read_ply_file(const Source& source, NumberReading reading) {
  return read_points_and_faces(source, reading, false);
}

Result<ElementFile> read_ply_elements(const Source& source, NumberReading reading) {
  Result<PlyFile> ply = read_ply_file(source, reading);
  if (!ply) return tl::unexpected(ply.error());
  ElementFile file;
  file.points = std::move(ply->points);
  if (ply->faces.simplices.columns() == 3) {
    file.triangles = std::move(ply->faces);
    finish_elements(file);
    return file;
  }
  for (std::size_t i = 0; i < ply->faces.simplices.size(); ++i) {
    const Simplex face = ply->faces.simplices[i];
    const std::size_t size = face.size();
    std::string name;
    if (size != 3) name = "a face of " + std::to_string(size) + " vertices";
    const std::size_t line = ply->faces.lines[i];
    const auto fault = add_element(file, ElementShape::kPolygon, face, name, line);
    if (!fault) continue;
    return tl::unexpected(
        FormatError{source.name, line, "a face of 3 vertices or more", std::to_string(size)});
  }
  finish_elements(file);
  return file;
}

Result<DomainFile> read_ply(const Source& source, NumberReading reading) {
  Result<PlyFile> ply = read_points_and_faces(source, reading, true);
  if (!ply) return tl::unexpected(ply.error());
  DomainFile file;
  file.name = source.name;
  Status status = take_points(file, std::move(ply->points), 0);
  if (status) status = add_faces(file, ply->faces);
  if (!status) return tl::unexpected(status.error());
  return file;
}

void write_ply(std::ostream& out, const ElementFile& file) {
  const std::vector<Simplex> surface = surface_of(file);
  const SimplexRows& edges = file.edges.simplices;
  out << "ply\nformat ascii 1.0\nelement vertex " + std::to_string(file.points.points.size()) +
             "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
             std::to_string(surface.size()) + "\nproperty list uchar int vertex_indices\n";
  if (!edges.empty()) {
    out << "element edge " + std::to_string(edges.size()) +
               "\nproperty int vertex1\nproperty int vertex2\n";
  }
  out << "end_header\n";
  for (const Point& point : file.points.points) {
    out << joined(point) + (point.size() == 2 ? " 0\n" : "\n");
  }
  const auto from_zero = [&](Simplex vertices) {
    for (Vertex& v : vertices) v = place_of_index(v, file.points.first_index);
    return joined(vertices) + "\n";
  };
  for (const Simplex& triangle : surface) out << "3 " + from_zero(triangle);
  for (const Simplex& edge : edges) out << from_zero(edge);
}

}  // namespace circumspect::formats
