#include "oracle/formats/plain_files.hpp"

#include <array>
#include <new>
#include <span>

#include "oracle/formats/tetgen.hpp"

namespace circumspect::formats {

namespace {

// What the header says, how many rows it announces, and where they begin.
template <class Header>
struct BegunRows {
  Header header;
  std::size_t rows;
  std::size_t end;
};

// `read(numbered)` reads the header as for the other reader. Nothing if there is a fault.
template <class Header, class Read>
std::optional<BegunRows<Header>> beginning(const RandomAccess& file, const Read& read) {
  const std::optional<Source> text = beginning_of(file);
  if (!text) return std::nullopt;
  NumberedLines numbered(*text, "", "");
  const Result<Header> header = read(numbered);
  if (!header) return std::nullopt;
  return BegunRows<Header>{*header, numbered.count(),
                           text->text.size() - numbered.lines().bytes_left()};
}

// `value` minus `first`; false if the difference does not fit.
template <class Index>
bool count_from(Vertex first, std::int64_t value, Index& difference) {
  return !__builtin_sub_overflow(value, std::int64_t{first}, &difference);
}

// Leaves out blocks that have rows but none of the slice.
PlainRows blocks_with(PlainRows rows, Slice slice) {
  std::erase_if(rows.blocks, [slice](const PlainBlock& block) {
    return block.first < block.last && (block.last <= slice.begin || block.first >= slice.end);
  });
  return rows;
}

std::optional<PlainPoints> node(const RandomAccess& file, const PlainReading& reading) {
  const auto begun = beginning<NodeHeader>(
      file, [](NumberedLines& numbered) { return read_node_header(numbered, false); });
  if (!begun) return std::nullopt;
  const NodeHeader& node = begun->header;
  const std::optional<PlainRows> rows =
      plan_rows(file, begun->end, begun->rows, node.columns(), reading.block_size);
  if (!rows) return std::nullopt;
  const Slice slice = reading.part.slice(begun->rows);
  PlainPoints points;
  points.coordinates = Rows<double>(slice.size(), node.dimension);
  if (node.attributes > 0) points.weights = Rows<double>(slice.size(), 1);
  points.first_index = rows->first_index;
  points.in_file = begun->rows;
  const auto read_row = [&points, &node, slice](PlainTokens& tokens, std::size_t row) {
    std::array<double, kLargestDimension> others;  // of a row outside the slice
    std::span<double> coordinates(others.data(), node.dimension);
    double ignored = 0;
    double* weight = &ignored;
    if (slice.has(row)) {
      coordinates = points.coordinates.row(row - slice.begin);
      if (node.attributes > 0) weight = &points.weights.row(row - slice.begin)[0];
    }
    for (double& coordinate : coordinates) {
      if (!tokens.number(coordinate)) return false;
    }
    for (std::size_t i = 0; i < node.attributes; ++i) {
      if (!tokens.number(i == 0 ? *weight : ignored)) return false;
    }
    std::int64_t marker = 0;
    return node.markers == 0 || tokens.integer(marker);
  };
  if (!read_plain_rows(file, blocks_with(*rows, slice), reading.threads, read_row)) {
    return std::nullopt;
  }
  return points;
}

// `to_flat(value, first_row, index)`: converts an index of the file to one from 0, given the index
// `first_row` of the first row; false if there is none.
template <class Index, class ToFlat>
std::optional<PlainIndices<Index>> indices(const RandomAccess& file,
                                           const BegunRows<EleHeader>& begun,
                                           const PlainReading& reading, const ToFlat& to_flat) {
  const EleHeader& columns = begun.header;
  const std::optional<PlainRows> rows =
      plan_rows(file, begun.end, begun.rows, columns.columns(), reading.block_size);
  if (!rows) return std::nullopt;
  const Slice slice = reading.part.slice(begun.rows);
  PlainIndices<Index> result{Rows<Index>(slice.size(), columns.vertices), rows->first_index,
                             begun.rows};
  const auto read_row = [&](PlainTokens& tokens, std::size_t row) {
    Index* next = nullptr;
    if (slice.has(row)) next = result.rows.row(row - slice.begin).data();
    for (std::size_t i = 0; i < columns.vertices; ++i) {
      std::int64_t value = 0;
      Index index = 0;
      if (!tokens.integer(value) || !to_flat(value, rows->first_index, index)) return false;
      if (next != nullptr) next[i] = index;
    }
    for (std::size_t i = 0; i < columns.attributes; ++i) {
      double ignored = 0;
      if (!tokens.number(ignored)) return false;
    }
    return true;
  };
  if (!read_plain_rows(file, blocks_with(*rows, slice), reading.threads, read_row)) {
    return std::nullopt;
  }
  return result;
}

template <class Index>
std::optional<PlainIndices<Index>> ele(const RandomAccess& file, Vertex first_point,
                                       const PlainReading& reading) {
  const auto begun = beginning<EleHeader>(file, read_ele_header);
  if (!begun) return std::nullopt;
  return indices<Index>(file, *begun, reading,
                        [first_point](std::int64_t value, Vertex, Index& vertex) {
                          return count_from(first_point, value, vertex);
                        });
}

std::optional<PlainIndices<std::int32_t>> neigh(const RandomAccess& file,
                                                const PlainReading& reading) {
  const auto begun = beginning<EleHeader>(file, [](NumberedLines& numbered) {
    return read_neigh_header(numbered).map([](std::size_t k) { return EleHeader{k, 0}; });
  });
  if (!begun) return std::nullopt;
  return indices<std::int32_t>(
      file, *begun, reading, [](std::int64_t value, Vertex first, std::int32_t& simplex) {
        if (value == -1) first = 0;
        return count_from(first, value, simplex) && (simplex >= 0 || value == -1);
      });
}

// If memory runs out, there is no answer either, and the slow reader says so.
template <class Read>
auto or_nothing(const Read& read) -> decltype(read()) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<PlainPoints> read_plain_node(const RandomAccess& file, const PlainReading& reading) {
  return or_nothing([&] { return node(file, reading); });
}

std::optional<PlainIndices<std::int32_t>> read_plain_ele(const RandomAccess& file,
                                                         Vertex first_point,
                                                         const PlainReading& reading) {
  return or_nothing([&] { return ele<std::int32_t>(file, first_point, reading); });
}

std::optional<PlainIndices<std::int64_t>> read_plain_wide_ele(const RandomAccess& file,
                                                              Vertex first_point,
                                                              const PlainReading& reading) {
  return or_nothing([&] { return ele<std::int64_t>(file, first_point, reading); });
}

std::optional<PlainIndices<std::int32_t>> read_plain_neigh(const RandomAccess& file,
                                                           const PlainReading& reading) {
  return or_nothing([&] { return neigh(file, reading); });
}

}  // namespace circumspect::formats
