#include "oracle/formats/plain_files.hpp"

#include <array>
#include <new>
#include <span>

#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {

namespace {

struct PlainNodeHeader {
  std::size_t points = 0;
  std::size_t dimension = 0;
  std::size_t attributes = 0;
  std::size_t markers = 0;
  std::size_t columns() const { return 1 + dimension + attributes + markers; }
};

std::optional<PlainNodeHeader> node_header(const PlainHeader& header) {
  const PlainNodeHeader node{header.numbers[0], header.numbers[1], header.numbers[2],
                             header.numbers[3]};
  if (header.size < 2 || node.dimension < 1 || node.dimension > kLargestDimension ||
      node.attributes > kMostPlainColumns || node.markers > 1) {
    return std::nullopt;
  }
  return node;
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

// The columns of .ele and .neigh: indices, and numbers that do not matter for a mesh.
struct IndexColumns {
  std::size_t indices = 0;
  std::size_t attributes = 0;
};

std::optional<PlainPoints> node(const RandomAccess& file, const PlainReading& reading) {
  const std::optional<PlainHeader> header = read_plain_header(file);
  if (!header) return std::nullopt;
  const std::optional<PlainNodeHeader> node = node_header(*header);
  if (!node) return std::nullopt;
  const std::optional<PlainRows> rows =
      plan_rows(file, header->end, node->points, node->columns(), reading.block_size);
  if (!rows) return std::nullopt;
  const Slice slice = reading.part.slice(node->points);
  PlainPoints points;
  points.coordinates = Rows<double>(slice.size(), node->dimension);
  if (node->attributes > 0) points.weights = Rows<double>(slice.size(), 1);
  points.first_index = rows->first_index;
  points.in_file = node->points;
  const auto read_row = [&points, &node, slice](PlainTokens& tokens, std::size_t row) {
    std::array<double, kLargestDimension> others;  // of a row outside the slice
    std::span<double> coordinates(others.data(), node->dimension);
    double ignored = 0;
    double* weight = &ignored;
    if (slice.has(row)) {
      coordinates = points.coordinates.row(row - slice.begin);
      if (node->attributes > 0) weight = &points.weights.row(row - slice.begin)[0];
    }
    for (double& coordinate : coordinates) {
      if (!tokens.number(coordinate)) return false;
    }
    for (std::size_t i = 0; i < node->attributes; ++i) {
      if (!tokens.number(i == 0 ? *weight : ignored)) return false;
    }
    std::int64_t marker = 0;
    return node->markers == 0 || tokens.integer(marker);
  };
  if (!read_plain_rows(file, blocks_with(*rows, slice), reading.threads, read_row)) {
    return std::nullopt;
  }
  return points;
}

// `to_flat(value, first_row, index)`: converts an index of the file to one from 0, given the index
// `first_row` of the first row; false if there is none.
template <class Index, class ToFlat>
std::optional<PlainIndices<Index>> indices(const RandomAccess& file, const PlainHeader& header,
                                           IndexColumns columns, const PlainReading& reading,
                                           const ToFlat& to_flat) {
  if (columns.indices < 1 || columns.indices > kMostPlainColumns) return std::nullopt;
  if (columns.attributes > kMostPlainColumns) return std::nullopt;
  const std::optional<PlainRows> rows =
      plan_rows(file, header.end, header.numbers[0], 1 + columns.indices + columns.attributes,
                reading.block_size);
  if (!rows) return std::nullopt;
  const Slice slice = reading.part.slice(header.numbers[0]);
  PlainIndices<Index> result{Rows<Index>(slice.size(), columns.indices), rows->first_index,
                             header.numbers[0]};
  const auto read_row = [&](PlainTokens& tokens, std::size_t row) {
    Index* next = nullptr;
    if (slice.has(row)) next = result.rows.row(row - slice.begin).data();
    for (std::size_t i = 0; i < columns.indices; ++i) {
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
  const std::optional<PlainHeader> header = read_plain_header(file);
  if (!header || header->size < 2 || header->size > 3) return std::nullopt;
  return indices<Index>(file, *header, {header->numbers[1], header->numbers[2]}, reading,
                        [first_point](std::int64_t value, Vertex, Index& vertex) {
                          return count_from(first_point, value, vertex);
                        });
}

std::optional<PlainIndices<std::int32_t>> neigh(const RandomAccess& file,
                                                const PlainReading& reading) {
  const std::optional<PlainHeader> header = read_plain_header(file);
  if (!header || header->size != 2) return std::nullopt;
  return indices<std::int32_t>(file, *header, {header->numbers[1], 0}, reading,
                               [](std::int64_t value, Vertex first, std::int32_t& simplex) {
                                 if (value == -1) first = 0;
                                 return count_from(first, value, simplex) &&
                                        (simplex >= 0 || value == -1);
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
