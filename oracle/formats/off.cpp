#include "oracle/formats/off.hpp"

#include <algorithm>

#include "oracle/formats/bytes/lines.hpp"

namespace circumspect::formats {
namespace {

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (text.substr(0, prefix.size()) != prefix) return false;
  text.remove_prefix(prefix.size());
  return true;
}

// What the keyword [ST][C][N][4][n]OFF says about the lines of points.
struct Keyword {
  bool has_more_columns = false;  // textures, colours, normals after the coordinates
  bool has_fourth = false;        // one more coordinate
  bool has_dimension = false;     // given by a number of its own
};

bool parse_keyword(std::string_view token, Keyword& keyword) {
  for (const std::string_view prefix : {"ST", "C", "N"}) {
    if (take_prefix(token, prefix)) keyword.has_more_columns = true;
  }
  keyword.has_fourth = take_prefix(token, "4");
  keyword.has_dimension = take_prefix(token, "n");
  return token == "OFF";
}

// The numbers of the header follow one another, on the line of the keyword or on later ones.
class OffHeader {
 public:
  explicit OffHeader(Lines& lines) : lines_(lines) {}

  // The column of the next number, on a later line if this one is used up.
  Result<std::size_t> next(std::string_view what) {
    if (column_ == lines_.size()) {
      lines_.next();
      column_ = 0;
    }
    if (lines_.size() == 0) return lines_.fail_at(0, std::string(what));
    return lines_.count(column_++, what);
  }

  // Requires that nothing is left on the line except the number of edges, which is not needed.
  Status finish_off() {
    if (column_ < lines_.size()) {
      const Result<std::size_t> edges = lines_.count(column_++, "the number of edges");
      if (!edges) return tl::unexpected(edges.error());
    }
    if (column_ == lines_.size()) return {};
    return lines_.fail_at(column_, "the end of the line after the counts");
  }

 private:
  Lines& lines_;
  std::size_t column_ = 1;  // after the keyword
};

// The layout of the file according to its header.
struct Layout {
  std::size_t dimension = 3;
  bool has_more_columns = false;
  std::size_t points = 0;
  std::size_t faces = 0;
};

Result<Layout> read_header(Lines& lines) {
  Keyword keyword;
  if (!lines.next() || !parse_keyword(lines.tokens()[0], keyword)) {
    return lines.fail_at(0, "the keyword OFF");
  }
  if (lines.size() > 1 && lines.tokens()[1] == "BINARY") {
    return lines.fail_at(1, "an OFF file in text");
  }
  Layout layout;
  layout.has_more_columns = keyword.has_more_columns;
  OffHeader header(lines);
  if (keyword.has_dimension) {
    const Result<std::size_t> dimension = header.next("the dimension");
    if (!dimension) return tl::unexpected(dimension.error());
    if (*dimension < 1 || *dimension >= kLargestDimension) {
      return lines.fail("a dimension from 1 to " + std::to_string(kLargestDimension - 1),
                        std::to_string(*dimension));
    }
    layout.dimension = *dimension;
  }
  if (keyword.has_fourth) ++layout.dimension;
  const Result<std::size_t> points = header.next("the number of points");
  if (!points) return tl::unexpected(points.error());
  const Result<std::size_t> faces = header.next("the number of faces");
  if (!faces) return tl::unexpected(faces.error());
  if (Status end = header.finish_off(); !end) return tl::unexpected(end.error());
  layout.points = *points;
  layout.faces = *faces;
  return layout;
}

// Goes to line `done` of `count` lines of one kind.
Status next_of(Lines& lines, std::string_view one, std::size_t done, std::size_t count) {
  if (lines.next()) return {};
  return lines.fail(
      std::string(one) + " " + std::to_string(done + 1) + " of " + std::to_string(count),
      "the end of the file");
}

// What follows the columns that matter: colours, normals, textures. No claim is about them, but
// they have to be numbers.
Status check_others(const Lines& lines, std::size_t first, NumberReading reading) {
  return lines.check_numbers(first, lines.size() - first, reading);
}

Status read_point(const Lines& lines, const Layout& layout, NumberReading reading,
                  PointRows& points) {
  const bool fits =
      layout.has_more_columns ? lines.size() >= layout.dimension : lines.size() == layout.dimension;
  if (!fits) {
    return lines.fail(std::to_string(layout.dimension) + " coordinates",
                      std::to_string(lines.size()));
  }
  const Status point = lines.add_numbers(0, layout.dimension, reading, points);
  return point ? check_others(lines, layout.dimension, reading) : point;
}

Status read_face(const Lines& lines, NumberReading reading, Simplex& face) {
  const Result<std::size_t> size = lines.count(0, "the number of vertices of a face");
  if (!size) return tl::unexpected(size.error());
  if (*size == 0) return lines.fail_at(0, "a face of at least 1 vertex");
  if (*size > lines.size() - 1) {
    return lines.fail("a face of " + std::to_string(*size) + " vertices",
                      std::to_string(lines.size() - 1));
  }
  const Status vertices = lines.integers(1, *size, "a vertex", face);
  return vertices ? check_others(lines, 1 + *size, reading) : vertices;
}

Status read_points(Lines& lines, const Layout& layout, NumberReading reading, OffFile& file) {
  file.points.dimension = layout.dimension;
  file.points.points.set_columns(layout.dimension);
  for (std::size_t i = 0; i < layout.points; ++i) {
    const Status line = next_of(lines, "point", i, layout.points);
    if (!line) return tl::unexpected(line.error());
    const Status point = read_point(lines, layout, reading, file.points.points);
    if (!point) return point;
  }
  return {};
}

Result<OffFile> finish_off(Lines& lines, OffFile file) {
  if (lines.next()) return lines.fail_at(0, "the end of the file after the last face");
  file.faces.vertices_per_simplex = file.faces.simplices.columns();
  return file;
}

// The usual form: a line each.
Result<OffFile> read_unwrapped(const Source& source, NumberReading reading) {
  Lines lines(source);
  const Result<Layout> layout = read_header(lines);
  if (!layout) return tl::unexpected(layout.error());
  OffFile file;
  Status status = read_points(lines, *layout, reading, file);
  Simplex face;
  for (std::size_t i = 0; status && i < layout->faces; ++i) {
    status = next_of(lines, "face", i, layout->faces);
    if (status) status = read_face(lines, reading, face);
    if (!status) break;
    file.faces.simplices.push_back(face);
    file.faces.lines.push_back(lines.line());
  }
  if (!status) return tl::unexpected(status.error());
  return finish_off(lines, std::move(file));
}

// Faces whose vertices continue over further lines, each face up to the end of a line.
Result<OffFile> read_wrapped(const Source& source, NumberReading reading) {
  Lines lines(source);
  const Result<Layout> layout = read_header(lines);
  if (!layout) return tl::unexpected(layout.error());
  OffFile file;
  if (Status points = read_points(lines, *layout, reading, file); !points) {
    return tl::unexpected(points.error());
  }
  for (std::size_t i = 0; i < layout->faces; ++i) {
    if (Status line = next_of(lines, "face", i, layout->faces); !line) {
      return tl::unexpected(line.error());
    }
    const Result<std::size_t> size = lines.count(0, "the number of vertices of a face");
    if (!size) return tl::unexpected(size.error());
    file.faces.lines.push_back(lines.line());
    Simplex face;
    std::size_t column = 1;
    while (face.size() < *size) {
      if (column == lines.size()) {
        column = 0;
        if (!lines.next()) return lines.fail_at(0, "a vertex");
      }
      const Result<Vertex> vertex = lines.integer(column++, "a vertex");
      if (!vertex) return tl::unexpected(vertex.error());
      face.push_back(*vertex);
    }
    const bool is_on_one_line = lines.line() == file.faces.lines.back();
    if (face.empty() || (column < lines.size() && !is_on_one_line)) {
      return lines.fail_at(column, "the end of the line behind a face");
    }
    if (Status colour = check_others(lines, column, reading); !colour) {
      return tl::unexpected(colour.error());
    }
    file.faces.simplices.push_back(face);
  }
  return finish_off(lines, std::move(file));
}

}  // namespace

bool is_off_keyword(std::string_view token) {
  Keyword keyword;
  return parse_keyword(token, keyword);
}

Result<OffFile> read_off(const Source& source, NumberReading reading) {
  Result<OffFile> file = read_unwrapped(source, reading);
  if (file) return file;
  Result<OffFile> wrapped = read_wrapped(source, reading);
  return wrapped ? wrapped : file;  // errors are reported for the usual form
}

void write_off(std::ostream& out, const OffFile& file) {
  const PointRows& points = file.points.points;
  const bool in_space = file.points.dimension == 3;
  std::string text = in_space ? "OFF\n" : "nOFF\n" + std::to_string(file.points.dimension) + "\n";
  text +=
      std::to_string(points.size()) + " " + std::to_string(file.faces.simplices.size()) + " 0\n";
  out << text;
  for (const Point& point : points) out << joined(point) + "\n";
  for (const Simplex& face : file.faces.simplices) {
    out << std::to_string(face.size()) + " " + joined(face) + "\n";
  }
}

}  // namespace circumspect::formats
