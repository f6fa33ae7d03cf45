#include "oracle/formats/voronoi_file.hpp"

#include <span>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {
namespace {

// Vertex 0 is at infinity.
ListedCell cell_of(std::span<const Vertex> vertices) {
  ListedCell cell;
  for (const Vertex v : vertices) {
    if (v == 0) {
      cell.is_unbounded = true;
    } else {
      cell.corners.push_back(v - 1);
    }
  }
  return cell;
}

class VoronoiReader {
 public:
  VoronoiReader(const Source& source, NumberReading reading) : lines_(source), reading_(reading) {}

  Result<VoronoiFile> read() {
    for (const auto& part : {&VoronoiReader::read_header, &VoronoiReader::read_vertices,
                             &VoronoiReader::read_cells, &VoronoiReader::read_ridges}) {
      if (Status status = (this->*part)(); !status) return tl::unexpected(status.error());
    }
    return std::move(file_);
  }

 private:
  // Goes to a line that must be there, with so many tokens or more.
  Status next(std::size_t tokens, const std::string& what) {
    if (!lines_.next()) return lines_.fail(what, "the end of the file");
    if (lines_.size() < tokens) {
      return lines_.fail(what, std::to_string(lines_.size()) + " numbers");
    }
    return {};
  }

  Status read_header() {
    const std::string dimension = "a line with the dimension, as qvoronoi o writes it";
    if (Status status = next(1, dimension); !status) return status;
    const auto axes = lines_.count(0, "the dimension");
    if (!axes) return tl::unexpected(axes.error());
    if (lines_.size() != 1 || *axes < 1 || *axes > kLargestDimension) {
      return lines_.fail_at(0, dimension);
    }
    file_.dimension = *axes;
    if (Status status = next(2, "a line \"vertices cells 1\""); !status) return status;
    const auto vertices = lines_.count(0, "the number of vertices");
    const auto cells = lines_.count(1, "the number of cells");
    if (!vertices) return tl::unexpected(vertices.error());
    if (!cells) return tl::unexpected(cells.error());
    if (*vertices == 0) return lines_.fail_at(0, "at least one vertex, the one at infinity");
    vertices_ = *vertices;
    cells_ = *cells;
    return {};
  }

  Status read_vertices() {
    for (std::size_t v = 0; v < vertices_; ++v) {
      const std::string what = "vertex " + std::to_string(v) + " with " +
                               std::to_string(file_.dimension) + " coordinates";
      if (Status status = next(file_.dimension, what); !status) return status;
      if (lines_.size() > file_.dimension) return lines_.fail_at(file_.dimension, what + " alone");
      auto point = lines_.numbers(0, file_.dimension, reading_);
      if (!point) return tl::unexpected(point.error());
      if (v > 0) file_.vertices.push_back(std::move(*point));
    }
    return {};
  }

  // A number and as many indices. The first vertex is at infinity.
  Result<std::vector<Vertex>> indices(const std::string& what) {
    if (Status status = next(1, what); !status) return tl::unexpected(status.error());
    const auto size = lines_.count(0, "how many follow");
    if (!size) return tl::unexpected(size.error());
    if (lines_.size() - 1 != *size) {
      return lines_.fail(what + ", " + std::to_string(*size) + " of them",
                         std::to_string(lines_.size() - 1));
    }
    return lines_.integers(1, *size, "an index");
  }

  Status read_cells() {
    for (std::size_t c = 0; c < cells_; ++c) {
      const auto row = indices("the vertices of cell " + std::to_string(c) + " after their number");
      if (!row) return tl::unexpected(row.error());
      file_.cells.push_back(cell_of(*row));
    }
    return {};
  }

  Status read_ridges() {
    if (!lines_.next()) return {};
    const auto ridges = lines_.count(0, "the number of ridges");
    if (!ridges) return tl::unexpected(ridges.error());
    for (std::size_t r = 0; r < *ridges; ++r) {
      const auto row = indices("two sites and the vertices of their ridge after their number");
      if (!row) return tl::unexpected(row.error());
      if (row->size() < 2) return lines_.fail("a ridge of two sites", "fewer numbers");
      file_.neighbors.push_back({(*row)[0], (*row)[1]});
      file_.ridges.push_back(cell_of(std::span(*row).subspan(2)));
    }
    if (lines_.next()) return lines_.fail("the end of the file", "more lines");
    return {};
  }

  Lines lines_;
  NumberReading reading_;
  VoronoiFile file_;
  std::size_t vertices_ = 0, cells_ = 0;
};

}  // namespace

Result<VoronoiFile> read_voronoi(const Source& source, NumberReading reading) {
  return VoronoiReader(source, reading).read();
}

}  // namespace circumspect::formats
