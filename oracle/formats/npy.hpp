// Arrays as NumPy saves them, .npy, and the header with which their files begin. Points are an
// array n × d of float64 or float32, simplices one m × k of integers, row after row or column after
// column (Fortran order), in either byte order. Each number is taken exactly. Vertices are counted
// from 0.
//
// An archive of such arrays, .npz, is a ZIP file as numpy.savez and numpy.savez_compressed write
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "oracle/formats/bytes/source.hpp"
#include "oracle/formats/point_file.hpp"
#include "oracle/model/index_lists.hpp"

namespace circumspect::formats {

// The beginning of an .npy file of NumPy (format versions 1.0, 2.0 and 3.0): eight bytes, the
// length of the header, and the header, a dictionary of Python:
//
//     {'descr': '<f8', 'fortran_order': False, 'shape': (4, 3), }
struct NpyHeader {
  std::string type = {};  // as written: "<f8"; structured types in brackets
  bool fortran_order = false;
  std::vector<std::size_t> shape = {};
  std::size_t end = 0;  // where the numbers begin

  std::string shape_in_words() const;  // "(4, 3)"
};

// Does a file begin as one of NumPy does?
bool is_npy(std::string_view beginning);

// `name` stands for the file in errors, which say what is wrong in the header.
Result<NpyHeader> read_npy_header(const RandomAccess& file, const std::string& name);

// Arrays as NumPy saves them: .npy. Points are an array n × d of float64 or float32, simplices one
// m × k of integers, row after row or column after column (Fortran order), in either byte order.
// Each number is taken exactly. Vertices are counted from 0.

// Indices of 32 bits if the file has such or shorter ones, else of 64 bits.
using NpySimplices = std::variant<Rows<std::int32_t>, Rows<std::int64_t>>;

inline constexpr Slice kAllRows{0, std::numeric_limits<std::uint64_t>::max()};

// Points of dimension 1 to kLargestDimension, finite, 0 for −0. Errors: another type
// or shape, each with what to do about it; more or fewer numbers than the shape says; NaN and
// infinities. `name` stands for the file in errors. Only the rows of the slice are read and
// checked.
Result<Rows<double>> read_rows_of_npy_points(const RandomAccess& file, const std::string& name,
                                             Slice rows = kAllRows);

// Simplices of at least one vertex; a vertex may name no point. Errors: the same.
Result<NpySimplices> read_rows_of_npy_simplices(const RandomAccess& file, const std::string& name,
                                                Slice rows = kAllRows);

// A list of indices, such as those of the points of a part in a whole: of shape (n,), as one
// column. Errors: the same.
Result<NpySimplices> read_npy_indices(const RandomAccess& file, const std::string& name);

// The same as exact numbers and as lists, as the other formats have them.
Result<PointFile> read_npy_points(const Source& source);
Result<SimplexFile> read_npy_simplices(const Source& source);

// Does a file begin as a ZIP file does?
bool is_npz(std::string_view beginning);

// The array `name`, such as "points", of an archive as an .npy file; messages call it
// "x.npz/points.npy". Errors: not an archive, no array of that name, one that is packed differently
// from NumPy's, more than 4 GiB, damage.
Result<Source> array_of_npz(const Source& archive, std::string_view name);

}  // namespace circumspect::formats
