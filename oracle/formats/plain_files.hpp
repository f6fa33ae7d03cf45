// .node, .ele and .neigh files as programs write them, read at the speed of memory into flat arrays.
// What is not of the plain form (plain_tokens.hpp) or at fault has no answer here: node.hpp, ele.hpp
// and neigh.hpp then read it, or say what is wrong with it. Where there is an answer, they have the
// same, with NumberReading::kDouble.
#pragma once

#include <cstdint>
#include <optional>

#include "oracle/formats/plain_rows.hpp"
#include "oracle/model/index_lists.hpp"

namespace circumspect::formats {

struct PlainReading {
  unsigned threads = 0;  // 0: as many as the machine has; the answer is the same for any number
  std::size_t block_size = kPlainBlock;
};

struct PlainPoints {
  Rows<double> coordinates = {};  // n × d, finite, without −0
  Rows<double> weights = {};      // n × 1, the first attributes; 0 × 0 if there are none
  Vertex first_index = 0;         // the user's index of the first point
};

// Rows of indices: the vertices of simplices, or their neighbours.
template <class Index>
struct PlainIndices {
  Rows<Index> rows = {};   // m × (d + 1), counted from 0
  Vertex first_index = 0;  // the user's index of the first simplex
};

// As read_node.
std::optional<PlainPoints> read_plain_node(const RandomAccess& file,
                                           const PlainReading& reading = {});

// As read_ele, each vertex less `first_point`, the user's index of the first point. Some may name no
// point.
std::optional<PlainIndices<std::int32_t>> read_plain_ele(const RandomAccess& file,
                                                         Vertex first_point,
                                                         const PlainReading& reading = {});

// As read_neigh, each simplex less the index of the first; −1 stays −1, and none is below.
std::optional<PlainIndices<std::int32_t>> read_plain_neigh(const RandomAccess& file,
                                                           const PlainReading& reading = {});

}  // namespace circumspect::formats
