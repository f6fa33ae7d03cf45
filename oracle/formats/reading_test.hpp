// For the tests of readers: sources, error messages, and the bytes of .npy and .npz files.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <zlib.h>

#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/formats/bytes/source.hpp"

namespace circumspect::formats {

// Shared by the tests of readers: a source with the name "f", and the message of a reader.

constexpr NumberReading kDouble = NumberReading::kDouble;

inline Source named(const std::string& text) { return {"f", text}; }

template <class T>
std::string error_of(const Result<T>& result) {
  return result ? "no error" : result.error().to_string();
}

// The bytes of .npy and .npz files, as numpy.save and numpy.savez write them.

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

// The text compressed by zlib, with the header that zlib makes for these `window_bits`: as raw data
// without one.
inline std::string deflated(const std::string& bytes, int window_bits = -MAX_WBITS) {
  std::string packed(compressBound(bytes.size()) + 32, '\0');
  z_stream stream = {};
  deflateInit2(&stream, 9, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

// A file that gzip packed.
inline std::string gzipped(const std::string& bytes) { return deflated(bytes, MAX_WBITS + 16); }

// An archive of files, each with its name; `method` is 0 or, packed by zlib, 8.
inline std::string npz(const std::vector<std::pair<std::string, std::string>>& files, int method) {
  const auto number = [](std::size_t value, std::size_t bytes) {
    std::string text;
    for (; bytes > 0; --bytes, value >>= 8) text += static_cast<char>(value & 0xff);
    return text;
  };
  std::string archive, directory;
  for (const auto& [name, bytes] : files) {
    const std::string stored = method == 8 ? deflated(bytes) : bytes;
    const std::size_t sum = crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    const std::string both = number(20, 2) + number(0, 2) +
                             number(static_cast<std::size_t>(method), 2) + number(0, 4) +
                             number(sum, 4) + number(stored.size(), 4) + number(bytes.size(), 4) +
                             number(name.size(), 2);
    directory += "PK\1\2" + number(20, 2) + both + number(0, 12) + number(archive.size(), 4) + name;
    // numpy.savez writes a further field here that the directory does not have.
    archive += "PK\3\4" + both + number(4, 2) + name + number(0, 4) + stored;
  }
  return archive + directory + "PK\5\6" + number(0, 4) + number(files.size(), 2) +
         number(files.size(), 2) + number(directory.size(), 4) + number(archive.size(), 4) +
         number(0, 2);
}

}  // namespace circumspect::formats
