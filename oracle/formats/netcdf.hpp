// Arrays of netCDF's classic formats (CDF-1, CDF-2 and CDF-5), in which Exodus keeps its meshes.
//
//     "CDF", 1, 2 or 5; the number of records
//     10, count: name, length of each dimension   0 0 if there are none, likewise below
//     12, count: name, type, values               of each attribute
//     11, count: name, dimensions, attributes,    of each variable
//       type, size, where its numbers begin
//
// Integers are big-endian, and have 4 bytes, in CDF-5 8; what a file begins with, only 4 in CDF-1.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/mixed_text.hpp"
#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

struct NetcdfVariable {
  std::vector<std::size_t> lengths = {};
  std::map<std::string, std::string> texts = {};  // attributes that are text
  NumberType type = {};
  std::size_t begin = 0;  // where in the file
  bool is_plain = true;   // neither text nor a series of records
};

using NetcdfVariables = std::map<std::string, NetcdfVariable, std::less<>>;

bool is_netcdf(std::string_view bytes);

Result<NetcdfVariables> read_netcdf(const Source& source);

// The numbers of a variable. Errors: it is text, or grows by records; the file ends before its last
// number. Requires: the source outlives what comes back.
Result<MixedText> netcdf_numbers(const Source& source, const std::string& name,
                                 const NetcdfVariable& variable, NumberReading reading);

}  // namespace circumspect::formats
