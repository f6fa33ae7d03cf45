// Which simplices are neighbours, as Triangle and TetGen write it: .neigh.
//
//     simplices k                                   k: neighbours of each
//     index n0 … n(k-1)                             one line a simplex
//
// Neighbour i shares the facet opposite vertex i of the .ele file; -1: there is none.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "oracle/formats/source.hpp"
#include "reference/kernel/predicates/configuration.hpp"

namespace circumspect::formats {

struct NeighborFile {
  std::vector<std::vector<Vertex>> neighbors = {};  // indices of simplices exactly as in the file
  std::size_t neighbors_per_simplex = 0;
  Vertex first_index = 0;  // the user's index of the first simplex

  friend bool operator==(const NeighborFile&, const NeighborFile&) = default;
};

// The simplices whose neighbours a file is to list.
struct ListedSimplices {
  std::size_t count = 0;
  std::size_t vertices = 0;  // of each
  std::string name = {};     // of their file, for messages
};

// Errors, besides those of the format: there are neighbours of more or fewer simplices, or more or fewer
// of each, than `simplices` says, if that is given.
Result<NeighborFile> read_neigh(const Source& source,
                                const std::optional<ListedSimplices>& simplices = {});

// Requires: every simplex has neighbors_per_simplex neighbours, at least 1.
void write_neigh(std::ostream& out, const NeighborFile& file);

}  // namespace circumspect::formats
