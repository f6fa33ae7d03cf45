// Data sets of HDF5, in which XDMF leaves its large arrays: as h5py, meshio,
// DOLFIN and DOLFINx write them. Nothing of libhdf5 is needed, which trusts its
// files more than this reader does.
//
// Read are superblocks 0 to 3, headers of version 1 and 2, groups as symbol
// tables or as links in the header; integers and IEEE numbers of either byte
// order; data that are compact, contiguous or in chunks found by a tree of
// version 1, unpacked by deflate, unshuffled, with or without Fletcher's
// checksum. Everything else is refused by its name.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

struct Hdf5Array {
  std::vector<std::size_t> dimensions = {};
  NumberType type = {};
  ByteOrder order = ByteOrder::kLittleEndian;
  std::string bytes = {};  // of all numbers, the last dimension fastest
};

// The data set at a path, as "/Mesh/mesh/topology". Errors: there is none, or
// it is not laid out as above; it would take more memory than a megabyte, or
// two hundred times the size of the file.
Result<Hdf5Array> read_hdf5(const Source& source, std::string_view path);

}  // namespace circumspect::formats
