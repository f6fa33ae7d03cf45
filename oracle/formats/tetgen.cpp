#include "oracle/formats/tetgen.hpp"

#include "kernel/exact/int64.hpp"
#include "oracle/model/exact_mesh.hpp"

namespace circumspect::formats {

namespace {

// The number of markers at the end of each line, which the header gives in this column.
Result<std::size_t> marker_count(NumberedLines& numbered, std::size_t column) {
  const Result<std::size_t> markers = numbered.header_count(column, "the number of markers");
  if (markers && *markers > 1) return numbered.lines().fail_at(column, "0 or 1 markers");
  return markers;
}

}  // namespace

Result<NodeHeader> read_node_header(NumberedLines& numbered, bool may_be_empty) {
  Status status =
      numbered.read_header("points dimension [attributes [markers]]", may_be_empty ? 1 : 2, 4);
  if (!status) return tl::unexpected(status.error());
  const bool is_empty = may_be_empty && numbered.count() == 0;
  const Result<std::size_t> dimension = numbered.header_count(1, "the dimension");
  if (!dimension) return tl::unexpected(dimension.error());
  if ((*dimension < 1 && !is_empty) || *dimension > kLargestDimension) {
    return numbered.lines().fail_at(1,
                                    "a dimension from 1 to " + std::to_string(kLargestDimension));
  }
  const Result<std::size_t> attributes = numbered.header_count(2, "the number of attributes");
  if (!attributes) return tl::unexpected(attributes.error());
  const Result<std::size_t> markers = marker_count(numbered, 3);
  if (!markers) return tl::unexpected(markers.error());
  return NodeHeader{*dimension, *attributes, *markers};
}

namespace {

std::string columns_in_words(const NodeHeader& header) {
  std::string text = "an index, " + std::to_string(header.dimension) + " coordinates";
  if (header.attributes > 0) text += ", " + std::to_string(header.attributes) + " attributes";
  if (header.markers > 0) text += ", a marker";
  return text;
}

Status read_point(const Lines& lines, const NodeHeader& header, NumberReading reading,
                  PointFile& file) {
  const Status point = lines.add_numbers(1, header.dimension, reading, file.points);
  if (!point) return point;
  if (header.attributes > 0) {
    Result<std::vector<Rational>> row =
        lines.numbers(1 + header.dimension, header.attributes, reading);
    if (!row) return tl::unexpected(std::move(row.error()));
    file.attributes.push_back(std::move(*row));
  }
  if (header.markers > 0) {
    const Result<Vertex> marker = lines.integer(lines.size() - 1, "a marker");
    if (!marker) return tl::unexpected(marker.error());
    file.markers.emplace_back(lines.tokens().back());
  }
  return {};
}

Result<PointFile> read_list(NumberedLines& numbered, NumberReading reading, bool may_be_empty) {
  const Result<NodeHeader> header = read_node_header(numbered, may_be_empty);
  if (!header) return tl::unexpected(header.error());
  numbered.expect_columns(header->columns(), columns_in_words(*header));
  PointFile file;
  file.dimension = header->dimension;
  if (header->dimension > 0) file.points.set_columns(header->dimension);
  file.points.reserve(numbered.lines_at_most());
  while (true) {
    const Result<bool> more = numbered.next_in_list();
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    Status status = read_point(numbered.lines(), *header, reading, file);
    if (!status) return tl::unexpected(status.error());
  }
  file.first_index = numbered.first_index();
  return file;
}

}  // namespace

Result<PointFile> read_node(const Source& source, NumberReading reading) {
  NumberedLines numbered(source, "point", "points");
  Result<PointFile> file = read_list(numbered, reading, false);
  if (!file) return file;
  if (Status end = numbered.expect_end(); !end) return tl::unexpected(end.error());
  return file;
}

Result<PointFile> read_node_list(NumberedLines& numbered, NumberReading reading) {
  return read_list(numbered, reading, true);
}

void write_node(std::ostream& out, const PointFile& file) {
  const std::size_t attributes = file.attributes.empty() ? 0 : file.attributes.front().size();
  std::string text = std::to_string(file.points.size()) + " " + std::to_string(file.dimension) +
                     " " + std::to_string(attributes) + (file.markers.empty() ? " 0\n" : " 1\n");
  out << text;
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    text = std::to_string(file.first_index + static_cast<Vertex>(i)) + " " + joined(file.points[i]);
    if (attributes > 0) text += " " + joined(file.attributes[i]);
    if (!file.markers.empty()) text += " " + file.markers[i];
    text += "\n";
    out << text;
  }
}

Result<EleHeader> read_ele_header(NumberedLines& numbered) {
  const Status status = numbered.read_header("simplices vertices-of-each [attributes]", 2, 3);
  if (!status) return tl::unexpected(status.error());
  const Result<std::size_t> vertices = numbered.header_count(1, "the number of vertices of each");
  if (!vertices) return tl::unexpected(vertices.error());
  if (*vertices == 0) return numbered.lines().fail_at(1, "simplices of at least 1 vertex");
  const Result<std::size_t> attributes = numbered.header_count(2, "the number of attributes");
  if (!attributes) return tl::unexpected(attributes.error());
  return EleHeader{*vertices, *attributes};
}

namespace {

// No claim is about the attributes, but they have to be numbers. The first one, in which TetGen and
// Triangle write the region of a simplex, is its label if it is an integer.
Status read_attributes(const Lines& lines, std::size_t first, std::size_t count,
                       NumberReading reading, SimplexFile& file) {
  const auto attributes = lines.numbers(first, count, reading);
  if (!attributes) return tl::unexpected(attributes.error());
  if (count == 0 || file.labels.size() < file.simplices.size()) return {};
  const Rational& label = attributes->front();
  const auto integer = label.get_den() == 1 ? to_int64(label.get_num()) : std::nullopt;
  if (integer) {
    file.labels.push_back(*integer);
  } else {
    file.labels.clear();
  }
  return {};
}

}  // namespace

Result<SimplexFile> read_ele(const Source& source, NumberReading reading) {
  NumberedLines numbered(source, "simplex", "simplices");
  const Result<EleHeader> header = read_ele_header(numbered);
  if (!header) return tl::unexpected(header.error());
  const std::size_t k = header->vertices;
  std::string meaning = "an index, " + std::to_string(k) + " vertices";
  if (header->attributes > 0) meaning += ", " + std::to_string(header->attributes) + " attributes";
  numbered.expect_columns(header->columns(), std::move(meaning));
  SimplexFile file;
  file.vertices_per_simplex = k;
  if (k <= numbered.lines().bytes_left()) file.simplices.reserve(numbered.lines_at_most() * k);
  Simplex simplex;
  const Lines& lines = numbered.lines();
  while (true) {
    const Result<bool> more = numbered.next();
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    const Status vertices = lines.integers(1, k, "a vertex", simplex);
    if (!vertices) return tl::unexpected(vertices.error());
    const Status attributes = read_attributes(lines, 1 + k, header->attributes, reading, file);
    if (!attributes) return tl::unexpected(attributes.error());
    file.simplices.push_back(simplex);
    file.lines.push_back(lines.line());
  }
  file.first_index = numbered.first_index();
  return file;
}

Result<std::vector<Simplex>> read_ele_offsets(const Source& source, std::size_t dimension) {
  NumberedLines numbered(source, "simplex", "simplices");
  const Result<EleHeader> header = read_ele_header(numbered);
  if (!header) return tl::unexpected(header.error());
  const std::size_t expected = header->vertices * dimension;
  if (header->attributes != expected) {
    return numbered.lines().fail(
        std::to_string(expected) + " attributes of each cell, the offset of each corner",
        std::to_string(header->attributes));
  }
  numbered.expect_columns(header->columns(), "an index, vertices, and offsets");
  std::vector<Simplex> offsets;
  while (true) {
    const Result<bool> more = numbered.next();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return offsets;
    auto row = numbered.lines().integers(1 + header->vertices, expected, "an integer offset");
    if (!row) return tl::unexpected(row.error());
    offsets.push_back(std::move(*row));
  }
}

void write_ele(std::ostream& out, const SimplexFile& file) {
  out << std::to_string(file.simplices.size()) + " " + std::to_string(file.vertices_per_simplex) +
             " 0\n";
  write_numbered(out, file.first_index, file.simplices.lists());
}

namespace {

// The columns of a line before TetGen's additions.
struct Columns {
  std::size_t vertices = 0;
  std::size_t markers = 0;
  std::size_t least() const { return 1 + vertices + markers; }
  std::string meaning() const {
    return "an index, " + std::to_string(vertices) + " vertices" +
           (markers == 1 ? ", a marker" : "");
  }
};

// The first line says how many columns there are: at most three more than announced, a marker and
// two tetrahedra.
Status take_columns(NumberedLines& numbered, const Columns& columns) {
  constexpr std::size_t kAdditions = 3;
  const std::size_t found = numbered.lines().size();
  if (found >= columns.least() && found <= columns.least() + kAdditions) {
    numbered.expect_columns(found, columns.meaning() + ", and what the first line has");
    return {};
  }
  return numbered.lines().fail(std::to_string(columns.least()) + " columns (" + columns.meaning() +
                                   ") and at most " + std::to_string(kAdditions) + " more",
                               std::to_string(found));
}

}  // namespace

Result<SimplexFile> read_face(const Source& source, std::size_t vertices) {
  const bool is_face = vertices == 3;
  NumberedLines numbered(source, is_face ? "face" : "edge", is_face ? "faces" : "edges");
  Status status = numbered.read_header(is_face ? "faces [markers]" : "edges [markers]", 1, 2);
  if (!status) return tl::unexpected(status.error());
  const Result<std::size_t> markers = marker_count(numbered, 1);
  if (!markers) return tl::unexpected(markers.error());
  const Columns columns{vertices, *markers};
  numbered.allow_any_columns();
  SimplexFile file;
  file.vertices_per_simplex = vertices;
  while (true) {
    const Result<bool> more = numbered.next();
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    if (file.simplices.empty()) status = take_columns(numbered, columns);
    if (!status) return tl::unexpected(status.error());
    const Lines& lines = numbered.lines();
    Result<Simplex> simplex = lines.integers(1, vertices, "a vertex");
    if (!simplex) return tl::unexpected(simplex.error());
    const auto rest =
        lines.integers(1 + vertices, lines.size() - 1 - vertices, "a marker or a tetrahedron");
    if (!rest) return tl::unexpected(rest.error());
    file.simplices.push_back(*simplex);
    if (*markers == 1) file.labels.push_back(rest->front());
    file.lines.push_back(lines.line());
  }
  file.first_index = numbered.first_index();
  return file;
}

void add_markers(const SimplexFile& file, Vertex first_index, std::map<Simplex, Vertex>& markers) {
  for (std::size_t i = 0; i < file.labels.size() && file.vertices_per_simplex == 3; ++i) {
    if (file.labels[i] == 0) continue;
    Simplex face = file.simplices[i];
    for (Vertex& v : face) v = place_of_index(v, first_index);
    markers.emplace(sorted(face), file.labels[i]);
  }
}

void write_face(std::ostream& out, const SimplexFile& file) {
  out << std::to_string(file.simplices.size()) + " 0\n";
  write_numbered(out, file.first_index, file.simplices.lists());
}

Result<std::size_t> read_neigh_header(NumberedLines& numbered) {
  const Status status = numbered.read_header("simplices neighbours-of-each", 2, 2);
  if (!status) return tl::unexpected(status.error());
  const Result<std::size_t> k = numbered.header_count(1, "the number of neighbours of each");
  if (k && *k == 0) return numbered.lines().fail_at(1, "at least 1 neighbour of each");
  return k;
}

namespace {

// Requires: the line of the header is the current one.
Status check_header(const NumberedLines& numbered, std::size_t neighbors,
                    const ListedSimplices& simplices) {
  if (numbered.count() != simplices.count) {
    return numbered.lines().fail_at(
        0, std::to_string(simplices.count) + " simplices, as " + simplices.name + " has them");
  }
  if (neighbors == simplices.vertices) return {};
  return numbered.lines().fail_at(1, std::to_string(simplices.vertices) +
                                         " neighbours of each, as many as a simplex of " +
                                         simplices.name + " has vertices");
}

}  // namespace

Result<NeighborFile> read_neigh(const Source& source,
                                const std::optional<ListedSimplices>& simplices) {
  NumberedLines numbered(source, "simplex", "simplices");
  const Result<std::size_t> k = read_neigh_header(numbered);
  if (!k) return tl::unexpected(k.error());
  if (simplices) {
    const Status agrees = check_header(numbered, *k, *simplices);
    if (!agrees) return tl::unexpected(agrees.error());
  }
  numbered.expect_columns(1 + *k, "an index, " + std::to_string(*k) + " neighbours");
  NeighborFile file;
  file.neighbors_per_simplex = *k;
  file.neighbors.reserve(numbered.lines_at_most());
  while (true) {
    const Result<bool> more = numbered.next();
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    Result<std::vector<Vertex>> row = numbered.lines().integers(1, *k, "a neighbour");
    if (!row) return tl::unexpected(row.error());
    file.neighbors.push_back(std::move(*row));
  }
  file.first_index = numbered.first_index();
  return file;
}

void write_neigh(std::ostream& out, const NeighborFile& file) {
  out << std::to_string(file.neighbors.size()) + " " + std::to_string(file.neighbors_per_simplex) +
             "\n";
  write_numbered(out, file.first_index, file.neighbors);
}

}  // namespace circumspect::formats
