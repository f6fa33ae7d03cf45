#include "oracle/formats/qhull.hpp"

#include "oracle/formats/bytes/lines.hpp"

namespace circumspect::formats {

namespace {

// A line that holds only a count.
Result<std::size_t> read_count(Lines& lines, const std::string& what) {
  if (!lines.next()) return lines.fail_at(0, what);
  const Result<std::size_t> count = lines.count(0, what);
  if (!count) return count;
  if (lines.size() > 1) return lines.fail_at(1, "the end of the line after " + what);
  return count;
}

// The first line: the dimension, and perhaps a comment.
Result<std::size_t> read_dimension(Lines& lines) {
  if (!lines.next()) return lines.fail_at(0, "the dimension");
  const Result<std::size_t> dimension = lines.count(0, "the dimension");
  if (!dimension) return dimension;
  if (*dimension < 1 || *dimension > kLargestDimension) {
    return lines.fail_at(0, "a dimension from 1 to " + std::to_string(kLargestDimension));
  }
  return dimension;
}

Status read_point(const Lines& lines, std::size_t dimension, NumberReading reading,
                  PointRows& points) {
  if (lines.size() != dimension) {
    return lines.fail(std::to_string(dimension) + " coordinates", std::to_string(lines.size()));
  }
  return lines.add_numbers(0, dimension, reading, points);
}

}  // namespace

Result<PointFile> read_qhull_points(const Source& source, NumberReading reading) {
  Lines lines(source);
  const Result<std::size_t> dimension = read_dimension(lines);
  if (!dimension) return tl::unexpected(dimension.error());
  const Result<std::size_t> count = read_count(lines, "the number of points");
  if (!count) return tl::unexpected(count.error());
  PointFile file;
  file.dimension = *dimension;
  file.points.set_columns(*dimension);
  for (std::size_t i = 0; i < *count; ++i) {
    if (!lines.next()) {
      return lines.fail("point " + std::to_string(i + 1) + " of " + std::to_string(*count),
                        "the end of the file");
    }
    const Status point = read_point(lines, *dimension, reading, file.points);
    if (!point) return tl::unexpected(point.error());
  }
  if (lines.next()) return lines.fail_at(0, "the end of the file after the last point");
  return file;
}

Result<SimplexFile> read_qhull_simplices(const Source& source) {
  Lines lines(source);
  const Result<std::size_t> count = read_count(lines, "the number of facets");
  if (!count) return tl::unexpected(count.error());
  SimplexFile file;
  Simplex simplex;
  for (std::size_t i = 0; i < *count; ++i) {
    if (!lines.next()) {
      return lines.fail("facet " + std::to_string(i + 1) + " of " + std::to_string(*count),
                        "the end of the file");
    }
    const Status vertices = lines.integers(0, lines.size(), "a vertex", simplex);
    if (!vertices) return tl::unexpected(vertices.error());
    file.simplices.push_back(simplex);
    file.lines.push_back(lines.line());
  }
  if (lines.next()) return lines.fail_at(0, "the end of the file after the last facet");
  file.vertices_per_simplex = file.simplices.columns();
  return file;
}

void write_qhull_points(std::ostream& out, const PointFile& file) {
  out << std::to_string(file.dimension) + "\n" + std::to_string(file.points.size()) + "\n";
  for (const Point& point : file.points) out << joined(point) + "\n";
}

void write_qhull_simplices(std::ostream& out, const SimplexFile& file) {
  out << std::to_string(file.simplices.size()) + "\n";
  for (const Simplex& simplex : file.simplices) out << joined(simplex) + "\n";
}

}  // namespace circumspect::formats
