#include "oracle/formats/stl.hpp"

#include <array>
#include <map>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"

namespace circumspect::formats {
namespace {

constexpr std::size_t kHeader = 80;
constexpr std::size_t kTriangle = 50;

// Merges equal corners as triangles come in.
class Surface {
 public:
  explicit Surface(const std::string& name) { surface_.name = name; }

  void note(std::size_t line, const std::string& text) {
    surface_.notes.push_back(surface_.name + ":" + std::to_string(line) + ": " + text);
  }

  void add(std::array<Point, 3> corners, std::size_t line) {
    Simplex triangle;
    for (Point& corner : corners) triangle.push_back(place_of_corner(std::move(corner)));
    surface_.triangles.push_back(std::move(triangle));
    surface_.lines.push_back(line);
  }

  StlFile finish() {
    const std::size_t corners = 3 * surface_.triangles.size();
    if (corners > surface_.points.size()) {
      surface_.notes.push_back(surface_.name + ": " + std::to_string(corners) +
                               " corners of triangles merged into " +
                               std::to_string(surface_.points.size()) + " points");
    }
    return std::move(surface_);
  }

 private:
  Vertex place_of_corner(Point corner) {
    const auto next = static_cast<Vertex>(surface_.points.size());
    const auto [entry, is_new] = places_.emplace(std::move(corner), next);
    if (is_new) surface_.points.push_back(entry->first);
    return entry->second;
  }

  StlFile surface_;
  std::map<Point, Vertex> places_;
};

class TextReader {
 public:
  TextReader(const Source& source, NumberReading reading)
      : lines_(source), reading_(reading), surface_(source.name) {}

  Result<StlFile> read() {
    Status status = expect_words({"solid"}, true);
    if (!status) return tl::unexpected(status.error());
    while (true) {
      if (Status solid = read_solid(); !solid) return tl::unexpected(solid.error());
      if (!lines_.next()) return surface_.finish();
      if (!is_word(lines_.tokens()[0], "solid")) {
        return lines_.fail_at(0, "\"solid\" or the end of the file");
      }
    }
  }

 private:
  // The next line begins with these words; more text, such as a name, may follow them.
  Status expect_words(const std::vector<std::string>& words, bool more_may_follow) {
    lines_.next();
    return check_words(words, more_may_follow);
  }

  Status check_words(const std::vector<std::string>& words, bool more_may_follow) const {
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (i < lines_.size() && is_word(lines_.tokens()[i], words[i])) continue;
      return lines_.fail_at(i, "\"" + words[i] + "\"");
    }
    if (more_may_follow || lines_.size() == words.size()) return {};
    return lines_.fail_at(words.size(), "the end of the line");
  }

  // Mathematica writes no blank between "endsolid" and the name, and other programs write one
  // within "endsolid". No other line begins like that.
  bool is_end_of_solid() {
    constexpr std::string_view kEnd = "endsolid";
    const std::vector<std::string_view>& tokens = lines_.tokens();
    if (is_word(tokens[0], kEnd)) return true;
    const bool is_apart =
        tokens.size() > 1 && is_word(tokens[0], "end") && is_word(tokens[1], "solid");
    if (!is_apart && !is_word(tokens[0].substr(0, kEnd.size()), kEnd)) return false;
    if (!has_noted_end_) {
      const std::string written(is_apart ? "end solid" : tokens[0]);
      surface_.note(lines_.line(), quote(written) + " was read as \"endsolid\"");
    }
    has_noted_end_ = true;
    return true;
  }

  // The facets of a solid and its last line.
  Status read_solid() {
    while (true) {
      if (lines_.next() && is_end_of_solid()) return {};
      if (lines_.size() == 0 || !is_word(lines_.tokens()[0], "facet")) {
        return lines_.fail_at(0, "\"facet\" or \"endsolid\"");
      }
      if (Status facet = read_facet(); !facet) return facet;
    }
  }

  Status read_facet() {
    const std::size_t line = lines_.line();
    Status status = check_words({"facet"}, true);
    if (status) status = expect_words({"outer", "loop"}, false);
    std::array<Point, 3> corners;
    for (Point& corner : corners) {
      if (status) status = expect_words({"vertex"}, true);
      if (!status) return status;
      if (lines_.size() != 4) {
        return lines_.fail("\"vertex\" and 3 coordinates",
                           std::to_string(lines_.size() - 1) + " of them");
      }
      Result<Point> point = lines_.numbers(1, 3, reading_);
      if (!point) return tl::unexpected(point.error());
      corner = std::move(*point);
    }
    status = expect_words({"endloop"}, false);
    if (status) status = expect_words({"endfacet"}, false);
    if (!status) return status;
    surface_.add(std::move(corners), line);
    return {};
  }

  Lines lines_;
  NumberReading reading_;
  Surface surface_;
  bool has_noted_end_ = false;
};

Result<Point> read_corner(Bytes& bytes, const Source& source, const std::string& triangle) {
  Point corner;
  for (int i = 0; i < 3; ++i) {
    const std::size_t at = source.text.size() - bytes.left();
    const auto bits = bytes.unsigned_integer(4);
    const std::optional<Rational> value = bits ? as_floating(*bits, 4) : std::nullopt;
    if (!value) {
      return tl::unexpected(
          FormatError{source.name, 0, "finite coordinates of " + triangle,
                      (bits ? "NaN or an infinity at byte " : "the end of the file at byte ") +
                          std::to_string(at)});
    }
    corner.push_back(*value);
  }
  return corner;
}

Result<StlFile> read_binary(const Source& source) {
  Bytes bytes(source.text, ByteOrder::kLittleEndian);
  const bool has_header = bytes.skip(kHeader);
  const auto count = has_header ? bytes.unsigned_integer(4) : std::nullopt;
  if (!count) {
    return tl::unexpected(FormatError{
        source.name, 0, "\"solid\", or 80 bytes and the number of triangles of a binary STL file",
        std::to_string(source.text.size()) + " bytes"});
  }
  Surface surface(source.name);
  for (std::uint64_t i = 0; i < *count; ++i) {
    const std::string triangle =
        "triangle " + std::to_string(i + 1) + " of " + std::to_string(*count);
    if (bytes.left() < kTriangle) {
      return tl::unexpected(
          FormatError{source.name, 0, triangle,
                      "the end of the file at byte " + std::to_string(source.text.size())});
    }
    bytes.skip(12);
    std::array<Point, 3> corners;
    for (Point& corner : corners) {
      Result<Point> point = read_corner(bytes, source, triangle);
      if (!point) return tl::unexpected(point.error());
      corner = std::move(*point);
    }
    bytes.skip(2);
    surface.add(std::move(corners), 0);
  }
  if (bytes.left() == 0) return surface.finish();
  return tl::unexpected(FormatError{
      source.name, 0, "the end of the file after " + std::to_string(*count) + " triangles",
      std::to_string(bytes.left()) + " more bytes"});
}

// The number of triangles of a binary file has a byte 0, unless it is larger than 16 million.
bool is_binary(const Source& source) {
  if (source.text.find('\0') != std::string::npos) return true;
  Lines lines(source);
  return !lines.next() || !is_word(lines.tokens()[0], "solid");
}

}  // namespace

bool is_binary_stl(std::string_view text) {
  Bytes bytes(text, ByteOrder::kLittleEndian);
  if (!bytes.skip(kHeader)) return false;
  const auto count = bytes.unsigned_integer(4);
  return count && *count > 0 && bytes.left() == *count * kTriangle;
}

Result<StlFile> read_stl_file(const Source& source, NumberReading reading) {
  if (is_binary(source)) return read_binary(source);
  return TextReader(source, reading).read();
}

Result<DomainFile> read_stl(const Source& source, NumberReading reading) {
  Result<StlFile> surface = read_stl_file(source, reading);
  if (!surface) return tl::unexpected(surface.error());
  DomainFile file;
  file.name = source.name;
  file.dimension = 3;
  file.input.points = std::move(surface->points);
  file.notes = std::move(surface->notes);
  std::size_t collapsed = 0;
  for (std::size_t i = 0; i < surface->triangles.size(); ++i) {
    Simplex& triangle = surface->triangles[i];
    if (!has_repeated_vertex(triangle)) {
      add_facet(file, {{std::move(triangle)}, {}}, surface->lines[i]);
      continue;
    }
    ++collapsed;
    const Vertex other = triangle[0] == triangle[1] ? triangle[2] : triangle[1];
    if (other != triangle[0]) add_segment(file, {triangle[0], other}, surface->lines[i]);
  }
  if (collapsed > 0) {
    file.notes.push_back(file.name + ": " + std::to_string(collapsed) +
                         " triangles with equal corners read as the segments that they are");
  }
  return file;
}

Result<ElementFile> read_stl_elements(const Source& source, NumberReading reading) {
  Result<StlFile> surface = read_stl_file(source, reading);
  if (!surface) return tl::unexpected(surface.error());
  ElementFile file;
  file.points.dimension = 3;
  file.points.points.set_columns(3);
  for (const Point& point : surface->points) file.points.points.push_back(point);
  file.notes = std::move(surface->notes);
  for (std::size_t i = 0; i < surface->triangles.size(); ++i) {
    add_element(file, ElementShape::kPolygon, surface->triangles[i], "a triangle",
                surface->lines[i]);
  }
  finish_elements(file);
  return file;
}

}  // namespace circumspect::formats
