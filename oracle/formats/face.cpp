#include "oracle/formats/face.hpp"

#include "oracle/formats/numbered_lines.hpp"
#include "oracle/model/listed_index.hpp"

namespace circumspect::formats {
namespace {

// What a line has before TetGen's additions.
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
  const Result<std::size_t> markers = numbered.header_count(1, "the number of markers");
  if (!markers) return tl::unexpected(markers.error());
  if (*markers > 1) return numbered.lines().fail_at(1, "0 or 1 markers");
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
    file.simplices.push_back(std::move(*simplex));
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
  write_numbered(out, file.first_index, file.simplices);
}

}  // namespace circumspect::formats
