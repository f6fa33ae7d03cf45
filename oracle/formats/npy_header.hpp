// How an .npy file of NumPy begins (its format versions 1.0, 2.0 and 3.0): eight bytes, the length of
// the header, and the header, a dictionary of Python:
//
//     {'descr': '<f8', 'fortran_order': False, 'shape': (4, 3), }
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "oracle/formats/source.hpp"

namespace circumspect::formats {

struct NpyHeader {
  std::string type = {};  // as written: "<f8"; structured types in brackets
  bool fortran_order = false;
  std::vector<std::size_t> shape = {};
  std::size_t end = 0;  // where the numbers begin

  std::string shape_in_words() const;  // "(4, 3)"
};

// Does a file begin as one of NumPy does?
bool is_npy(std::string_view beginning);

// `name` stands for the file in errors, which say what in the header is not as it should be.
Result<NpyHeader> read_npy_header(const RandomAccess& file, const std::string& name);

}  // namespace circumspect::formats
