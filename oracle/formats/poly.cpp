#include "oracle/formats/poly.hpp"

#include "oracle/formats/bytes/numbered_lines.hpp"
#include "oracle/formats/tetgen.hpp"

namespace circumspect::formats {
namespace {

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

// Walks through the lists of one file, in their order.
class PolyReader {
 public:
  PolyReader(const Source& source, NumberReading reading)
      : numbered_(source, "point", "points"), reading_(reading) {
    file_.name = source.name;
  }

  Status read_points(const PointsElsewhere& points_elsewhere);
  Status read_segments();
  Status read_facets(bool one_polygon_each);
  Status read_holes();
  Status read_regions();
  Result<DomainFile> finish();

  std::size_t dimension() const { return file_.dimension; }

 private:
  using Facet = PolygonLines;

  Status read_markers();
  Status next_line(const std::string& one, std::size_t done, std::size_t count);
  Result<std::vector<Vertex>> corners(std::size_t count, std::size_t& column);
  Result<std::vector<Vertex>> polygon(std::size_t& column);
  Status expect_end_of_line(std::size_t column, const std::string& behind);
  Result<Facet> facet();
  Result<Facet> facet_of_one_polygon();
  Result<Point> facet_hole();

  Lines& lines() { return numbered_.lines(); }

  NumberedLines numbered_;
  NumberReading reading_;
  DomainFile file_;
  std::size_t markers_ = 0;
  Vertex marker_ = 0;  // of the facet read last
};

Status PolyReader::read_points(const PointsElsewhere& points_elsewhere) {
  Result<PointFile> points = read_node_list(numbered_, reading_);
  if (!points) return tl::unexpected(points.error());
  const std::size_t line = lines().line();
  const std::size_t announced = points->dimension;
  if (points->points.empty()) {
    points = points_elsewhere();
    if (!points) return tl::unexpected(points.error());
  }
  if (announced != 0 && points->dimension != announced) {
    return tl::unexpected(FormatError{file_.name, line,
                                      "points of dimension " + std::to_string(announced),
                                      "dimension " + std::to_string(points->dimension)});
  }
  return take_points(file_, std::move(*points), line);
}

// The number of boundary markers for each line, which follows the count in a header.
Status PolyReader::read_markers() {
  const Result<std::size_t> markers = numbered_.header_count(1, "the number of markers");
  if (!markers) return tl::unexpected(markers.error());
  if (*markers > 1) return lines().fail_at(1, "0 or 1 markers");
  markers_ = *markers;
  return {};
}

Status PolyReader::read_segments() {
  numbered_.begin_list("segment", "segments");
  numbered_.allow_any_index();
  Status status = numbered_.read_header("segments [markers]", 1, 2);
  if (status) status = read_markers();
  if (!status) return status;
  numbered_.expect_columns(3 + markers_,
                           markers_ == 0 ? "an index, 2 ends" : "an index, 2 ends, a marker");
  while (true) {
    const Result<bool> more = numbered_.next_in_list();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    std::size_t column = 1;
    const auto ends = corners(2, column);
    if (!ends) return tl::unexpected(ends.error());
    if ((*ends)[0] == (*ends)[1]) return lines().fail_at(2, "another end than the first");
    if (markers_ == 1) {
      const Result<Vertex> marker = lines().integer(3, "a marker");
      if (!marker) return tl::unexpected(marker.error());
    }
    add_segment(file_, *ends, lines().line());
  }
}

Status PolyReader::next_line(const std::string& one, std::size_t done, std::size_t count) {
  if (lines().next()) return {};
  return lines().fail(one + " " + std::to_string(done + 1) + " of " + std::to_string(count),
                      "the end of the file");
}

// `count` vertices from a column on, continuing on the following lines.
Result<std::vector<Vertex>> PolyReader::corners(std::size_t count, std::size_t& column) {
  std::vector<Vertex> places;
  while (places.size() < count) {
    if (column == lines().size()) {
      Status line = next_line("corner", places.size(), count);
      if (!line) return tl::unexpected(line.error());
      column = 0;
    }
    const Result<Vertex> index = lines().integer(column, "a vertex");
    if (!index) return tl::unexpected(index.error());
    const Result<Vertex> place = place_of(file_, *index, lines().line());
    if (!place) return tl::unexpected(place.error());
    places.push_back(*place);
    ++column;
  }
  return places;
}

// The number of corners on the current line, and the corners.
Result<std::vector<Vertex>> PolyReader::polygon(std::size_t& column) {
  const Result<std::size_t> count = lines().count(0, "the number of corners of a polygon");
  if (!count) return tl::unexpected(count.error());
  if (*count == 0) return lines().fail_at(0, "a polygon of at least 1 corner");
  column = 1;
  return corners(*count, column);
}

Status PolyReader::expect_end_of_line(std::size_t column, const std::string& behind) {
  if (column == lines().size()) return {};
  return lines().fail_at(column, "the end of the line after " + behind);
}

Result<Point> PolyReader::facet_hole() {
  if (lines().size() != 4) {
    return lines().fail("4 columns (an index, 3 coordinates)", std::to_string(lines().size()));
  }
  const Result<Vertex> index = lines().integer(0, "the index of a hole");
  if (!index) return tl::unexpected(index.error());
  return lines().numbers(1, 3, reading_);
}

Result<PolyReader::Facet> PolyReader::facet() {
  std::size_t counts[2] = {0, 0};
  for (std::size_t i = 0; i < 2 && i < lines().size(); ++i) {
    const Result<std::size_t> count =
        lines().count(i, i == 0 ? "the number of polygons of a facet" : "its number of holes");
    if (!count) return tl::unexpected(count.error());
    counts[i] = *count;
  }
  if (counts[0] == 0) return lines().fail_at(0, "a facet of at least 1 polygon");
  marker_ = 0;
  if (lines().size() > 2 && markers_ == 1) {
    const Result<Vertex> marker = lines().integer(2, "a marker");
    if (!marker) return tl::unexpected(marker.error());
    marker_ = *marker;
  }
  if (lines().size() > 2 + markers_) {
    return lines().fail_at(2 + markers_,
                           "the end of the line (" + counted(markers_, "marker") + " a facet)");
  }
  Facet facet;
  for (std::size_t i = 0; i < counts[0]; ++i) {
    Status line = next_line("polygon", i, counts[0]);
    if (!line) return tl::unexpected(line.error());
    std::size_t column = 0;
    auto polygon_corners = polygon(column);
    if (!polygon_corners) return tl::unexpected(polygon_corners.error());
    Status end = expect_end_of_line(column, counted(polygon_corners->size(), "corner"));
    if (!end) return tl::unexpected(end.error());
    facet.lines.push_back(std::move(*polygon_corners));
  }
  for (std::size_t i = 0; i < counts[1]; ++i) {
    Status line = next_line("hole", i, counts[1]);
    if (!line) return tl::unexpected(line.error());
    Result<Point> seed = facet_hole();
    if (!seed) return tl::unexpected(seed.error());
    facet.hole_seeds.push_back(std::move(*seed));
  }
  return facet;
}

Result<PolyReader::Facet> PolyReader::facet_of_one_polygon() {
  std::size_t column = 0;
  auto line = polygon(column);
  if (!line) return tl::unexpected(line.error());
  marker_ = 0;
  if (markers_ == 1 && column < lines().size()) {
    const Result<Vertex> marker = lines().integer(column++, "a marker");
    if (!marker) return tl::unexpected(marker.error());
    marker_ = *marker;
  }
  Status end = expect_end_of_line(
      column, counted(line->size(), "corner") + " and " + counted(markers_, "marker"));
  if (!end) return tl::unexpected(end.error());
  return Facet{{std::move(*line)}, {}};
}

Status PolyReader::read_facets(bool one_polygon_each) {
  numbered_.begin_list("facet", "facets");
  Status status = numbered_.read_header("facets [markers]", 1, 2);
  if (status) status = read_markers();
  if (!status) return status;
  const std::size_t count = numbered_.count();
  for (std::size_t i = 0; i < count; ++i) {
    if (Status line = next_line("facet", i, count); !line) return line;
    const std::size_t line = lines().line();
    Result<Facet> read = one_polygon_each ? facet_of_one_polygon() : facet();
    if (!read) return tl::unexpected(read.error());
    add_facet(file_, std::move(*read), line, marker_);
  }
  return {};
}

Status PolyReader::read_holes() {
  numbered_.begin_list("hole", "holes");
  numbered_.allow_any_index();
  const Result<bool> listed = numbered_.read_optional_header("holes", 1, 1);
  if (!listed) return tl::unexpected(listed.error());
  if (!*listed && file_.dimension == 2) {
    return lines().fail("a header \"holes\"", "the end of the file");
  }
  if (!*listed) {
    file_.notes.push_back(file_.name + ": ends before the list of holes, read as none");
    return {};
  }
  numbered_.expect_columns(1 + file_.dimension,
                           "an index, " + std::to_string(file_.dimension) + " coordinates");
  while (true) {
    const Result<bool> more = numbered_.next_in_list();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    Result<Point> seed = lines().numbers(1, file_.dimension, reading_);
    if (!seed) return tl::unexpected(seed.error());
    file_.input.hole_seeds.push_back(std::move(*seed));
  }
}

// A region gives an attribute to the elements in it, and a bound on their size.
Status PolyReader::read_regions() {
  const Result<bool> listed = numbered_.read_optional_header("regions", 1, 1);
  if (!listed) return tl::unexpected(listed.error());
  const std::size_t count = *listed ? numbered_.count() : 0;
  const std::size_t least = 2 + file_.dimension;
  for (std::size_t i = 0; i < count; ++i) {
    if (Status line = next_line("region", i, count); !line) return line;
    if (lines().size() != least && lines().size() != least + 1) {
      return lines().fail(std::to_string(least) + " or " + std::to_string(least + 1) +
                              " columns (an index, " + std::to_string(file_.dimension) +
                              " coordinates, an attribute, a bound)",
                          std::to_string(lines().size()));
    }
    const Result<Vertex> index = lines().integer(0, "the index of a region");
    if (!index) return tl::unexpected(index.error());
    auto numbers = lines().numbers(1, lines().size() - 1, reading_);
    if (!numbers) return tl::unexpected(numbers.error());
    const Rational most = numbers->back();
    numbers->resize(file_.dimension);
    if (sign(most) > 0) file_.region_bounds.push_back({std::move(*numbers), most});
  }
  return {};
}

Result<DomainFile> PolyReader::finish() {
  if (lines().next()) return lines().fail_at(0, "the end of the file after the last list");
  return std::move(file_);
}

Result<DomainFile> read(const Source& source, NumberReading reading,
                        const PointsElsewhere& points_elsewhere, bool one_polygon_each) {
  PolyReader reader(source, reading);
  if (Status points = reader.read_points(points_elsewhere); !points) {
    return tl::unexpected(points.error());
  }
  if (one_polygon_each && reader.dimension() == 2) {
    return tl::unexpected(
        FormatError{source.name, 0, "points in space, for a .smesh file", "points in the plane"});
  }
  Status status =
      reader.dimension() == 2 ? reader.read_segments() : reader.read_facets(one_polygon_each);
  if (status) status = reader.read_holes();
  if (status) status = reader.read_regions();
  if (!status) return tl::unexpected(status.error());
  return reader.finish();
}

}  // namespace

Result<DomainFile> read_poly(const Source& source, NumberReading reading,
                             const PointsElsewhere& points_elsewhere) {
  return read(source, reading, points_elsewhere, false);
}

Result<DomainFile> read_smesh(const Source& source, NumberReading reading,
                              const PointsElsewhere& points_elsewhere) {
  return read(source, reading, points_elsewhere, true);
}

}  // namespace circumspect::formats
