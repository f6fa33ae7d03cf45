#include "oracle/formats/node.hpp"

#include "oracle/formats/numbered_lines.hpp"
#include "oracle/formats/rows.hpp"

namespace circumspect::formats {
namespace {

struct NodeHeader {
  std::size_t dimension = 0;
  std::size_t attributes = 0;
  std::size_t markers = 0;
};

// `may_be_empty`: without points, nothing else need be said.
Result<NodeHeader> read_header(NumberedLines& numbered, bool may_be_empty) {
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
  const Result<std::size_t> markers = numbered.header_count(3, "the number of markers");
  if (!markers) return tl::unexpected(markers.error());
  if (*markers > 1) return numbered.lines().fail_at(3, "0 or 1 markers");
  return NodeHeader{*dimension, *attributes, *markers};
}

std::string columns_in_words(const NodeHeader& header) {
  std::string text = "an index, " + std::to_string(header.dimension) + " coordinates";
  if (header.attributes > 0) text += ", " + std::to_string(header.attributes) + " attributes";
  if (header.markers > 0) text += ", a marker";
  return text;
}

Status read_point(const Lines& lines, const NodeHeader& header, NumberReading reading,
                  PointFile& file) {
  Result<Point> point = lines.numbers(1, header.dimension, reading);
  if (!point) return tl::unexpected(std::move(point.error()));
  file.points.push_back(std::move(*point));
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
  const Result<NodeHeader> header = read_header(numbered, may_be_empty);
  if (!header) return tl::unexpected(header.error());
  numbered.expect_columns(1 + header->dimension + header->attributes + header->markers,
                          columns_in_words(*header));
  PointFile file;
  file.dimension = header->dimension;
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

}  // namespace circumspect::formats
