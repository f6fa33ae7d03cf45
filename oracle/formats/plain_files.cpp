#include "oracle/formats/plain_files.hpp"

#include <limits>
#include <new>

#include "oracle/formats/point_file.hpp"

namespace circumspect::formats {
namespace {

using Indices = PlainIndices<std::int32_t>;

struct NodeHeader {
  std::size_t points = 0;
  std::size_t dimension = 0;
  std::size_t attributes = 0;
  std::size_t markers = 0;
  std::size_t columns() const { return 1 + dimension + attributes + markers; }
};

std::optional<NodeHeader> node_header(const PlainHeader& header) {
  const NodeHeader node{header.numbers[0], header.numbers[1], header.numbers[2], header.numbers[3]};
  if (header.size < 2 || node.dimension < 1 || node.dimension > kLargestDimension ||
      node.attributes > kMostPlainColumns || node.markers > 1) {
    return std::nullopt;
  }
  return node;
}

// `value` less `first`; false if 32 bits do not hold it.
bool count_from(Vertex first, std::int64_t value, std::int32_t& difference) {
  std::int64_t wide = 0;
  if (__builtin_sub_overflow(value, std::int64_t{first}, &wide)) return false;
  difference = static_cast<std::int32_t>(wide);
  return wide == difference;
}

// The columns of .ele and .neigh: indices, and numbers that say nothing of a mesh.
struct IndexColumns {
  std::size_t indices = 0;
  std::size_t attributes = 0;
};

std::optional<PlainPoints> node(const RandomAccess& file, const PlainReading& reading) {
  const std::optional<PlainHeader> header = read_plain_header(file);
  if (!header) return std::nullopt;
  const std::optional<NodeHeader> node = node_header(*header);
  if (!node) return std::nullopt;
  const std::optional<PlainRows> rows =
      plan_rows(file, header->end, node->points, node->columns(), reading.block_size);
  if (!rows) return std::nullopt;
  PlainPoints points;
  points.coordinates = Rows<double>(node->points, node->dimension);
  if (node->attributes > 0) points.weights = Rows<double>(node->points, 1);
  points.first_index = rows->first_index;
  const auto read_row = [&points, &node](PlainTokens& tokens, std::size_t row) {
    for (double& coordinate : points.coordinates.row(row)) {
      if (!tokens.number(coordinate)) return false;
    }
    for (std::size_t i = 0; i < node->attributes; ++i) {
      double ignored = 0;
      if (!tokens.number(i == 0 ? points.weights.row(row)[0] : ignored)) return false;
    }
    std::int64_t marker = 0;
    return node->markers == 0 || tokens.integer(marker);
  };
  if (!read_plain_rows(file, *rows, reading.threads, read_row)) return std::nullopt;
  return points;
}

// `to_flat(value, first_row, index)`: the index from 0 for what the file says, where the first row has
// the index `first_row`; false if there is none.
template <class ToFlat>
std::optional<Indices> indices(const RandomAccess& file, const PlainHeader& header,
                               IndexColumns columns, const PlainReading& reading,
                               const ToFlat& to_flat) {
  if (columns.indices < 1 || columns.indices > kMostPlainColumns) return std::nullopt;
  if (columns.attributes > kMostPlainColumns) return std::nullopt;
  const std::optional<PlainRows> rows =
      plan_rows(file, header.end, header.numbers[0], 1 + columns.indices + columns.attributes,
                reading.block_size);
  if (!rows) return std::nullopt;
  Indices result{Rows<std::int32_t>(header.numbers[0], columns.indices), rows->first_index};
  const auto read_row = [&](PlainTokens& tokens, std::size_t row) {
    for (std::int32_t& index : result.rows.row(row)) {
      std::int64_t value = 0;
      if (!tokens.integer(value) || !to_flat(value, rows->first_index, index)) return false;
    }
    for (std::size_t i = 0; i < columns.attributes; ++i) {
      double ignored = 0;
      if (!tokens.number(ignored)) return false;
    }
    return true;
  };
  if (!read_plain_rows(file, *rows, reading.threads, read_row)) return std::nullopt;
  return result;
}

std::optional<Indices> ele(const RandomAccess& file, Vertex first_point,
                           const PlainReading& reading) {
  const std::optional<PlainHeader> header = read_plain_header(file);
  if (!header || header->size < 2 || header->size > 3) return std::nullopt;
  return indices(file, *header, {header->numbers[1], header->numbers[2]}, reading,
                 [first_point](std::int64_t value, Vertex, std::int32_t& vertex) {
                   return count_from(first_point, value, vertex);
                 });
}

std::optional<Indices> neigh(const RandomAccess& file, const PlainReading& reading) {
  const std::optional<PlainHeader> header = read_plain_header(file);
  if (!header || header->size != 2) return std::nullopt;
  return indices(file, *header, {header->numbers[1], 0}, reading,
                 [](std::int64_t value, Vertex first, std::int32_t& simplex) {
                   if (value == -1) first = 0;
                   return count_from(first, value, simplex) && (simplex >= 0 || value == -1);
                 });
}

// Memory that there is not is no answer either: the slow reader says so.
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

std::optional<Indices> read_plain_ele(const RandomAccess& file, Vertex first_point,
                                      const PlainReading& reading) {
  return or_nothing([&] { return ele(file, first_point, reading); });
}

std::optional<Indices> read_plain_neigh(const RandomAccess& file, const PlainReading& reading) {
  return or_nothing([&] { return neigh(file, reading); });
}

}  // namespace circumspect::formats
