#include "oracle/formats/ele.hpp"

#include "oracle/formats/numbered_lines.hpp"

namespace circumspect::formats {
namespace {

struct EleHeader {
  std::size_t vertices = 0;
  std::size_t attributes = 0;
};

Result<EleHeader> read_header(NumberedLines& numbered) {
  const Status status = numbered.read_header("simplices vertices-of-each [attributes]", 2, 3);
  if (!status) return tl::unexpected(status.error());
  const Result<std::size_t> vertices = numbered.header_count(1, "the number of vertices of each");
  if (!vertices) return tl::unexpected(vertices.error());
  if (*vertices == 0) return numbered.lines().fail_at(1, "simplices of at least 1 vertex");
  const Result<std::size_t> attributes = numbered.header_count(2, "the number of attributes");
  if (!attributes) return tl::unexpected(attributes.error());
  return EleHeader{*vertices, *attributes};
}

// No claim is about the attributes; they have to be numbers all the same. The first of them, which TetGen
// and Triangle let the region say in which a simplex lies, is its label, if it is an integer.
Status read_attributes(const Lines& lines, std::size_t first, std::size_t count,
                       NumberReading reading, SimplexFile& file) {
  const auto attributes = lines.numbers(first, count, reading);
  if (!attributes) return tl::unexpected(attributes.error());
  if (count == 0 || file.labels.size() < file.simplices.size()) return {};
  const Rational& label = attributes->front();
  if (label.get_den() == 1 && label.get_num().fits_slong_p()) {
    file.labels.push_back(label.get_num().get_si());
  } else {
    file.labels.clear();
  }
  return {};
}

}  // namespace

Result<SimplexFile> read_ele(const Source& source, NumberReading reading) {
  NumberedLines numbered(source, "simplex", "simplices");
  const Result<EleHeader> header = read_header(numbered);
  if (!header) return tl::unexpected(header.error());
  const std::size_t k = header->vertices;
  std::string meaning = "an index, " + std::to_string(k) + " vertices";
  if (header->attributes > 0) meaning += ", " + std::to_string(header->attributes) + " attributes";
  numbered.expect_columns(1 + k + header->attributes, std::move(meaning));
  SimplexFile file;
  file.vertices_per_simplex = k;
  file.simplices.reserve(numbered.lines_at_most());
  file.lines.reserve(numbered.lines_at_most());
  const Lines& lines = numbered.lines();
  while (true) {
    const Result<bool> more = numbered.next();
    if (!more) return tl::unexpected(more.error());
    if (!*more) break;
    Result<Simplex> simplex = lines.integers(1, k, "a vertex");
    if (!simplex) return tl::unexpected(simplex.error());
    const Status attributes = read_attributes(lines, 1 + k, header->attributes, reading, file);
    if (!attributes) return tl::unexpected(attributes.error());
    file.simplices.push_back(std::move(*simplex));
    file.lines.push_back(lines.line());
  }
  file.first_index = numbered.first_index();
  return file;
}

void write_ele(std::ostream& out, const SimplexFile& file) {
  out << std::to_string(file.simplices.size()) + " " + std::to_string(file.vertices_per_simplex) +
             " 0\n";
  write_numbered(out, file.first_index, file.simplices);
}

}  // namespace circumspect::formats
