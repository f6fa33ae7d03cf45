#include "oracle/formats/neigh.hpp"

#include "oracle/formats/numbered_lines.hpp"

namespace circumspect::formats {

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
  const Status status = numbered.read_header("simplices neighbours-of-each", 2, 2);
  if (!status) return tl::unexpected(status.error());
  const Result<std::size_t> k = numbered.header_count(1, "the number of neighbours of each");
  if (!k) return tl::unexpected(k.error());
  if (*k == 0) return numbered.lines().fail_at(1, "at least 1 neighbour of each");
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
