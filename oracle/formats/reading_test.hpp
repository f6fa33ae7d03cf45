// What the tests of readers have in common: a source, what a reader complains of, and the bytes
// of .npy files.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "oracle/formats/source.hpp"
#include "reference/kernel/exact/number.hpp"

namespace circumspect::formats {

// ---- Reading ----
// What the tests of readers have in common: a source that has the name "f", and what a reader complains of.

constexpr NumberReading kDouble = NumberReading::kDouble;

inline Source named(const std::string& text) { return {"f", text}; }

template <class T>
std::string error_of(const Result<T>& result) {
  return result ? "no error" : result.error().to_string();
}

// ---- NPY bytes ----
// The bytes of .npy files, as numpy.save writes them.

// `version` 1 counts the header's bytes with two bytes, later ones with four.
inline std::string npy_with_header(std::string header, const std::string& data, char version = 1) {
  const std::size_t before = version == 1 ? 10 : 12;
  while ((before + header.size() + 1) % 64 != 0) header += ' ';
  header += '\n';
  std::string bytes = "\x93NUMPY" + std::string{version, '\0'};
  for (std::size_t i = 0; i < before - 8; ++i) {
    bytes += static_cast<char>(static_cast<unsigned char>(header.size() >> 8 * i));
  }
  return bytes + header + data;
}

// Numbers of a little-endian machine.
template <class Value>
std::string npy(const std::string& type, const std::string& shape, const std::vector<Value>& values,
                const std::string& fortran_order = "False") {
  std::string data(values.size() * sizeof(Value), '\0');
  if (!values.empty()) std::memcpy(data.data(), values.data(), data.size());
  return npy_with_header(
      "{'descr': '" + type + "', 'fortran_order': " + fortran_order + ", 'shape': " + shape + ", }",
      data);
}

}  // namespace circumspect::formats
