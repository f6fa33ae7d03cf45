#include "oracle/formats/tet.hpp"

#include <algorithm>

#include "oracle/formats/bytes/mixed_text.hpp"

namespace circumspect::formats {
namespace {

constexpr NumberType kUint32{NumberType::Kind::kUnsigned, 4};

struct TetCounts {
  std::size_t vertices = 0;
  std::size_t tetrahedra = 0;
  std::size_t outer = 0;
};

// "8 vertices".
Result<std::size_t> read_labelled_count(MixedText& text, std::string_view word) {
  const std::string what = "the number of " + std::string(word);
  const Result<std::size_t> count = text.count_in_text(what);
  if (!count) return count;
  if (text.word() != word) return text.fail_at_word("\"" + std::string(word) + "\"");
  return count;
}

Result<TetCounts> read_tet_counts(MixedText& text) {
  TetCounts counts;
  const Result<std::size_t> vertices = read_labelled_count(text, "vertices");
  if (!vertices) return tl::unexpected(vertices.error());
  counts.vertices = *vertices;
  const Result<std::size_t> tetrahedra = text.count_in_text("the number of tets");
  if (!tetrahedra) return tl::unexpected(tetrahedra.error());
  counts.tetrahedra = *tetrahedra;
  const bool has_outer = text.peek() == "inner";
  if (has_outer) text.word();
  if (text.word() != "tets") return text.fail_at_word("\"tets\" or \"inner tets\"");
  if (has_outer) {
    const Result<std::size_t> outer = read_labelled_count(text, "outer");
    if (!outer) return tl::unexpected(outer.error());
    counts.outer = *outer;
    if (text.word() != "tets") return text.fail_at_word("\"tets\"");
  }
  text.rest_of_line();
  return counts;
}

// Is there a byte that does not occur in text? Binary vertices contain a byte 0, unless there are
// more than 16 million.
bool has_bytes_of_no_text(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return !is_space(c) && (c < '!' || c > '~'); });
}

Status read_tetrahedron(MixedText& text, const Item& one, Simplex& vertices, std::size_t& line) {
  if (!text.is_binary()) {
    const Item of_size = {"the number of vertices of ", one.noun, one.place, one.count};
    const Vertex size = text.take(kUint32, of_size);
    if (text.has_failed()) return text.failure();
    if (size < 0) return text.fail(of_size.words() + ", 0 or more", std::to_string(size));
    if (size != 4) return text.fail_at_word("4, " + of_size.words());
  }
  line = text.line();
  for (Vertex& vertex : vertices) {
    vertex = text.take(kUint32, {"a vertex of ", one.noun, one.place, one.count});
  }
  if (text.has_failed()) return text.failure();
  return {};
}

}  // namespace

Result<ElementFile> read_tet(const Source& source, NumberReading reading) {
  MixedText text(source, reading);
  const Result<TetCounts> counts = read_tet_counts(text);
  if (!counts) return tl::unexpected(counts.error());
  const std::string_view body = source.text;
  if (has_bytes_of_no_text(body.substr(body.size() - text.bytes_left()))) {
    text.set_binary(ByteOrder::kLittleEndian);
  }
  ElementFile file;
  file.points.dimension = 3;
  file.points.points.set_columns(3);
  Status status =
      text.points(kFloat64, counts->vertices, {"a coordinate of ", "vertex", 0, counts->vertices},
                  file.points.points);
  if (!status) return tl::unexpected(status.error());
  const auto read = [&](std::size_t count, std::string_view kind, bool is_kept) -> Status {
    Simplex vertices(4);
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t line = 0;
      Status one = read_tetrahedron(text, {"", kind, i, count}, vertices, line);
      if (!one) return one;
      if (!is_kept) continue;
      add_element(file, ElementShape::kTetrahedron, vertices, "a tetrahedron", line);
    }
    return {};
  };
  status = read(counts->tetrahedra, "tetrahedron", true);
  if (status) status = read(counts->outer, "outer tetrahedron", false);
  if (!status) return tl::unexpected(status.error());
  if (!text.is_at_end()) {
    const std::string more =
        text.is_binary() ? std::to_string(text.bytes_left()) + " more bytes" : quote(text.word());
    return text.fail("the end of the file after the last tetrahedron", more);
  }
  if (counts->outer > 0) {
    file.notes.push_back(source.name + ": " + std::to_string(counts->outer) +
                         " outer tetrahedra were left out");
  }
  finish_elements(file);
  return file;
}

}  // namespace circumspect::formats
