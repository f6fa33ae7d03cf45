#include "oracle/formats/freefem.hpp"

#include <array>
#include <utility>

#include "oracle/formats/bytes/lines.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"

namespace circumspect::formats {
namespace {

class FreefemReader {
 public:
  FreefemReader(const Source& source, NumberReading reading) : lines_(source), reading_(reading) {}

  Result<ElementFile> read();

 private:
  // Goes to the next line, one of so many, which has to have so many columns.
  Status next_row(std::size_t columns, const Item& item);
  Status read_vertices(std::size_t count);
  Status read_elements(std::size_t count, std::size_t size, std::string_view name);

  Lines lines_;
  NumberReading reading_;
  ElementFile file_;
};

Status FreefemReader::next_row(std::size_t columns, const Item& item) {
  if (!lines_.next()) return lines_.fail_at(0, item.words());
  if (lines_.size() == columns) return {};
  return lines_.fail(std::to_string(columns) + " columns of " + item.words(),
                     std::to_string(lines_.size()));
}

Status FreefemReader::read_vertices(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const Item item("", "vertex", i, count);
    if (i == 0) {  // which tells the dimension
      if (!lines_.next()) return lines_.fail_at(0, item.words());
      if (lines_.size() != 3 && lines_.size() != 4) {
        return lines_.fail("2 or 3 coordinates and a label of " + item.words(),
                           std::to_string(lines_.size()) + " columns");
      }
      file_.points.dimension = lines_.size() - 1;
      file_.points.points.set_columns(file_.points.dimension);
    } else if (Status row = next_row(file_.points.dimension + 1, item); !row) {
      return row;
    }
    const std::size_t columns = file_.points.dimension;
    if (Status read = lines_.add_numbers(0, columns, reading_, file_.points.points); !read) {
      return read;
    }
    const Result<Vertex> label = lines_.integer(columns, "a label");
    if (!label) return tl::unexpected(label.error());
  }
  return {};
}

Status FreefemReader::read_elements(std::size_t count, std::size_t size, std::string_view name) {
  const ElementShape shape = size == 4   ? ElementShape::kTetrahedron
                             : size == 3 ? ElementShape::kPolygon
                                         : ElementShape::kPolyline;
  Simplex vertices;
  for (std::size_t i = 0; i < count; ++i) {
    if (Status row = next_row(size + 1, {"", name, i, count}); !row) return row;
    if (Status read = lines_.integers(0, size, "a vertex", vertices); !read) return read;
    const Result<Vertex> label = lines_.integer(size, "a label");
    if (!label) return tl::unexpected(label.error());
    add_element(file_, shape, vertices, name, lines_.line(), *label);
  }
  return {};
}

Result<ElementFile> FreefemReader::read() {
  file_.points.first_index = 1;
  if (!lines_.next() || lines_.size() != 3) {
    return lines_.fail_at(lines_.size(), "the numbers of vertices and of two kinds of elements");
  }
  std::array<std::size_t, 3> counts = {};
  for (std::size_t column = 0; column < 3; ++column) {
    const Result<std::size_t> count = lines_.count(column, "a count");
    if (!count) return tl::unexpected(count.error());
    counts[column] = *count;
  }
  if (counts[0] == 0) return lines_.fail("1 vertex or more", "0");
  Status status = read_vertices(counts[0]);
  const bool is_space = file_.points.dimension == 3;
  if (status) {
    status = is_space ? read_elements(counts[1], 4, "tetrahedron")
                      : read_elements(counts[1], 3, "triangle");
  }
  if (status) {
    status =
        is_space ? read_elements(counts[2], 3, "triangle") : read_elements(counts[2], 2, "edge");
  }
  if (status && lines_.next()) status = lines_.fail_at(0, "the end of the file");
  if (!status) return tl::unexpected(status.error());
  finish_elements(file_);
  return std::move(file_);
}

}  // namespace

bool is_freefem(const Beginning& beginning) {
  return beginning.is_number() && beginning.on_first_line == 3 &&
         (beginning.on_second_line == 3 || beginning.on_second_line == 4);
}

Result<ElementFile> read_freefem(const Source& source, NumberReading reading) {
  return FreefemReader(source, reading).read();
}

}  // namespace circumspect::formats
