// .node, .ele and .neigh files as programs write them, read at the speed of memory into flat
// arrays. Files that are faulty or not of the plain form have no answer here: tetgen.hpp then reads
// them, or says what is wrong. An answer is always the same as that of tetgen.hpp with
// NumberReading::kDouble.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "kernel/exact/number_text.hpp"
#include "kernel/predicates/configuration.hpp"
#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/plain_rows.hpp"
#include "oracle/model/index_lists.hpp"

namespace circumspect::formats {

struct PlainReading {
  unsigned threads = 0;  // 0: as many as the machine has; the answer is the same for any number
  std::size_t block_size = kPlainBlock;
  PartOf part = {};  // of the rows; no others are read or checked
};

struct PlainPoints {
  Rows<double> coordinates = {};  // n × d, finite, without −0
  Rows<double> weights = {};      // n × 1, the first attributes; 0 × 0 if there are none
  Vertex first_index = 0;         // the user's index of the first point of the file
  std::size_t in_file = 0;        // how many points the file has
};

// Rows of indices: the vertices of simplices, or their neighbours.
template <class Index>
struct PlainIndices {
  Rows<Index> rows = {};    // m × (d + 1), counted from 0
  Vertex first_index = 0;   // the user's index of the first simplex of the file
  std::size_t in_file = 0;  // how many rows the file has
};

// As read_node.
std::optional<PlainPoints> read_plain_node(const RandomAccess& file,
                                           const PlainReading& reading = {});

// As read_ele, with `first_point`, the user's index of the first point, subtracted from each
// vertex. Some may name no point.
std::optional<PlainIndices<std::int32_t>> read_plain_ele(const RandomAccess& file,
                                                         Vertex first_point,
                                                         const PlainReading& reading = {});
// The same in 64 bits.
std::optional<PlainIndices<std::int64_t>> read_plain_wide_ele(const RandomAccess& file,
                                                              Vertex first_point,
                                                              const PlainReading& reading = {});

// As read_neigh, with the index of the first simplex subtracted from each; −1 stays −1, and no
// result is less.
std::optional<PlainIndices<std::int32_t>> read_plain_neigh(const RandomAccess& file,
                                                           const PlainReading& reading = {});

}  // namespace circumspect::formats
