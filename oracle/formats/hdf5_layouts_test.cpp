// A data set of HDF5 has the same numbers however it is stored: in whatever type, byte order,
// layout and chunks, with whatever filters; and what is missing of it is missed. The files are
// written here as the HDF5 File Format Specification 3.0 lays them out.
#include <algorithm>
#include <array>

#include <doctest/doctest.h>
#include <zlib.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/hdf5.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/written_elements_test.hpp"
#include "oracle/formats/xdmf.hpp"

namespace circumspect::formats {
namespace {

constexpr std::size_t kRows = 5, kColumns = 3;
using Lengths = std::array<std::size_t, 2>;

struct StoredInteger {
  std::size_t size = 4;
  bool is_signed = true;
  ByteOrder order = ByteOrder::kLittleEndian;
};

// Of a data set of kRows × kColumns integers.
struct Layout {
  enum Kind : unsigned { kCompact, kContiguous, kChunked } kind = kContiguous;
  Lengths chunk = {kRows, kColumns};
  bool is_shuffled = false;
  bool is_deflated = false;
  bool has_unfiltered_chunks = false;  // every second one, by its mask
  std::size_t bytes_left_out = 0;      // of contiguous data
  std::size_t chunks_left_out = 0;     // the last ones
  std::size_t second_chunk_up_by = 0;  // rows, so that it covers some of the first again
  bool has_last_chunk_twice = false;
};

std::string little(std::uint64_t value, std::size_t size) {
  return stored(value, size, ByteOrder::kLittleEndian);
}

std::string message(unsigned type, const std::string& data) {
  return little(type, 2) + little(data.size(), 2) + little(0, 4) + data;
}

std::string header(const std::string& messages) {
  return little(1, 1) + little(0, 7) + little(messages.size(), 4) + little(0, 4) + messages;
}

std::string number_type(const StoredInteger& type) {
  const bool is_big = type.order == ByteOrder::kBigEndian;
  return little(0x10, 1) + little((is_big ? 1U : 0U) | (type.is_signed ? 8U : 0U), 3) +
         little(type.size, 4) + little(0, 2) + little(8 * type.size, 2) + little(0, 4);
}

std::string shuffled(const std::string& bytes, std::size_t size) {
  std::string columns;
  for (std::size_t b = 0; b < size; ++b) {
    for (std::size_t at = b; at < bytes.size(); at += size) columns += bytes[at];
  }
  return columns;
}

class Hdf5Writer {
 public:
  Hdf5Writer(const std::vector<Vertex>& values, const StoredInteger& type, const Layout& layout)
      : values_(values), type_(type), layout_(layout) {}

  // The data set /x, behind a link to another object and a soft link that has its name.
  std::string file() {
    constexpr std::size_t kSuperblock = 48;
    const std::size_t data_at = kSuperblock + set(0).size() + root(0).size();
    const std::string data = bytes_at(data_at);
    const std::string object = set(tree_or_data_);
    return "\x89HDF\r\n\x1a\n" + little(2, 1) + little(8, 1) + little(8, 1) + little(0, 1) +
           little(0, 8) + little(~std::uint64_t{0}, 8) + little(data_at + data.size(), 8) +
           little(kSuperblock + object.size(), 8) + little(0, 4) + object + root(kSuperblock) +
           data;
  }

 private:
  std::string number(std::size_t row, std::size_t column) const {
    const Vertex value = row < kRows && column < kColumns ? values_[row * kColumns + column] : 77;
    return stored(static_cast<std::uint64_t>(value), type_.size, type_.order);
  }

  std::string part(const Lengths& first, const Lengths& size) const {
    std::string bytes;
    for (std::size_t i = 0; i < size[0]; ++i) {
      for (std::size_t j = 0; j < size[1]; ++j) bytes += number(first[0] + i, first[1] + j);
    }
    return bytes;
  }

  std::string filtered(std::string bytes) const {
    if (layout_.is_shuffled) bytes = shuffled(bytes, type_.size);
    return layout_.is_deflated ? deflated(bytes, MAX_WBITS) : bytes;
  }

  std::string root(std::size_t set_at) const {
    return header(message(0x06, little(1, 1) + little(0, 1) + little(1, 1) + "y" + little(0, 8)) +
                  message(0x06, little(1, 1) + little(8, 1) + little(1, 1) + little(1, 1) + "x" +
                                    little(8, 2) + "/nowhere") +
                  message(0x06, little(1, 1) + little(8, 1) + little(0, 1) + little(1, 1) + "x" +
                                    little(set_at, 8)));
  }

  std::string set(std::size_t at) const {
    std::string layout = little(3, 1) + little(layout_.kind, 1);
    const std::size_t size = kRows * kColumns * type_.size;
    if (layout_.kind == Layout::kCompact) {
      layout += little(size, 2) + part({0, 0}, {kRows, kColumns});
    } else if (layout_.kind == Layout::kContiguous) {
      layout += little(at, 8) + little(size - layout_.bytes_left_out, 8);
    } else {
      layout += little(3, 1) + little(at, 8) + little(layout_.chunk[0], 4) +
                little(layout_.chunk[1], 4) + little(type_.size, 4);
    }
    std::string filters;
    for (const auto& [is_used, filter] :
         {std::pair{layout_.is_shuffled, 2U}, {layout_.is_deflated, 1U}}) {
      if (is_used) filters += little(filter, 2) + little(0, 6);
    }
    const std::string count = little(filters.size() / 8, 1);
    return header(
        message(0x03, number_type(type_)) +
        message(0x01, little(1, 1) + little(2, 1) + little(0, 6) + little(kRows, 8) +
                          little(kColumns, 8)) +
        (filters.empty() ? "" : message(0x0b, little(1, 1) + count + little(0, 6) + filters)) +
        message(0x08, layout));
  }

  // The data of a set, or its chunks and then their tree, which stand at this place.
  std::string bytes_at(std::size_t place) {
    tree_or_data_ = place;
    if (layout_.kind == Layout::kCompact) return "";
    if (layout_.kind == Layout::kContiguous) return part({0, 0}, {kRows, kColumns});
    std::string chunks, keys;
    std::size_t count = 0;
    const auto add = [&](const Lengths& first) {
      const bool is_plain = layout_.has_unfiltered_chunks && count % 2 == 1;
      const std::string raw = part(first, layout_.chunk);
      const std::string chunk = is_plain ? raw : filtered(raw);
      keys += little(chunk.size(), 4) + little(is_plain ? 3 : 0, 4) +
              little(first[0] - (count == 1 ? layout_.second_chunk_up_by : 0), 8) +
              little(first[1], 8) + little(0, 8) + little(place + chunks.size(), 8);
      chunks += chunk;
      ++count;
    };
    const std::size_t rows = (kRows + layout_.chunk[0] - 1) / layout_.chunk[0];
    const std::size_t columns = (kColumns + layout_.chunk[1] - 1) / layout_.chunk[1];
    for (std::size_t i = 0; i < rows * columns - layout_.chunks_left_out; ++i) {
      add({i / columns * layout_.chunk[0], i % columns * layout_.chunk[1]});
    }
    if (layout_.has_last_chunk_twice) {
      add({(rows - 1) * layout_.chunk[0], (columns - 1) * layout_.chunk[1]});
    }
    tree_or_data_ = place + chunks.size();
    return chunks + "TREE" + little(1, 1) + little(0, 1) + little(count, 2) +
           little(~std::uint64_t{0}, 8) + little(~std::uint64_t{0}, 8) + keys;
  }

  const std::vector<Vertex>& values_;
  const StoredInteger& type_;
  const Layout& layout_;
  std::size_t tree_or_data_ = 0;
};

// The smallest and the largest numbers of a type among others.
std::vector<Vertex> telling_values(const StoredInteger& type) {
  const std::size_t bits = 8 * type.size - 1;
  const auto most = static_cast<Vertex>((std::uint64_t{1} << bits) - 1);
  std::vector<Vertex> values;
  for (std::size_t i = 0; i < kRows * kColumns; ++i) values.push_back(static_cast<Vertex>(i) * 7);
  values[4] = most;
  if (type.is_signed) values[5] = -most - 1;
  if (!type.is_signed && type.size < 8) values[5] = 2 * most + 1;
  return values;
}

// As the readers of elements take them.
std::vector<Vertex> values_of(const Hdf5Array& array) {
  MixedText text("f", array.bytes, kDouble);
  text.set_binary(array.order);
  std::vector<Vertex> values;
  for (std::size_t i = 0; i < kRows * kColumns; ++i)
    values.push_back(text.take(array.type, {"a number"}));
  return values;
}

Result<Hdf5Array> read_back(const std::vector<Vertex>& values, const StoredInteger& type,
                            const Layout& layout) {
  const Source source = named(Hdf5Writer(values, type, layout).file());
  return read_hdf5(source, "/x");
}

std::vector<Layout> all_layouts() {
  std::vector<Layout> all = {{Layout::kCompact}, {Layout::kContiguous}};
  for (const Lengths& chunk : {Lengths{kRows, kColumns}, {2, 2}, {3, 1}, {1, 3}, {8, 8}}) {
    for (unsigned filters = 0; filters < 8; ++filters) {
      all.push_back(
          {Layout::kChunked, chunk, (filters & 1U) != 0, (filters & 2U) != 0, (filters & 4U) != 0});
    }
  }
  return all;
}

}  // namespace

TEST_CASE("hdf5: a number is the same in every type, byte order and layout that can store it") {
  for (const std::size_t size : {1U, 2U, 4U, 8U}) {
    for (const bool is_signed : {false, true}) {
      for (const ByteOrder order : {ByteOrder::kLittleEndian, ByteOrder::kBigEndian}) {
        const StoredInteger type{size, is_signed, order};
        const std::vector<Vertex> values = telling_values(type);
        for (const Layout& layout : all_layouts()) {
          const auto read = read_back(values, type, layout);
          CAPTURE(size);
          CAPTURE(layout.chunk[0]);
          REQUIRE_MESSAGE(read, error_of(read));
          CHECK(values_of(*read) == values);
        }
      }
    }
  }
}

TEST_CASE("hdf5: numbers that are not there are missed") {
  const StoredInteger type;
  const std::vector<Vertex> values = telling_values(type);
  const auto said = [&](const Layout& layout) { return error_of(read_back(values, type, layout)); };
  for (const Lengths& chunk : {Lengths{kRows, kColumns}, {2, 2}, {3, 1}, {1, 3}}) {
    CHECK(said({.kind = Layout::kChunked, .chunk = chunk, .chunks_left_out = 1})
              .find("bytes in chunks of") != std::string::npos);
  }
  const Lengths whole_rows = {2, kColumns};  // of which the last is for one row alone
  CHECK(said({.kind = Layout::kChunked, .chunk = whole_rows, .second_chunk_up_by = 1})
            .find("one outside of it") != std::string::npos);
  CHECK(said({.kind = Layout::kContiguous, .bytes_left_out = 1}).find("60 bytes of the data set") !=
        std::string::npos);
  CHECK(said({.kind = Layout::kChunked, .chunk = {2, 2}, .has_last_chunk_twice = true}) ==
        "f: expected chunks for 60 bytes of the data set \"/x\", found more");
  // Where bytes of the header are changed.
  const auto said_with = [&](const Layout& layout, const std::string& bytes,
                             const std::string& others) {
    std::string text = Hdf5Writer(values, type, layout).file();
    const std::size_t place = text.find(bytes);
    REQUIRE(place != std::string::npos);
    return error_of(read_hdf5(named(text.replace(place, bytes.size(), others)), "/x"));
  };
  const Layout chunked = {.kind = Layout::kChunked, .chunk = {3, 1}};
  const std::string sizes = little(3, 4) + little(1, 4) + little(4, 4);
  for (const std::string& others :
       {little(0, 4) + little(1, 4) + little(4, 4), little(3, 4) + little(0, 4) + little(4, 4),
        little(3, 4) + little(1, 4) + little(8, 4)}) {
    CHECK(said_with(chunked, sizes, others) ==
          "f: expected sizes of chunks of the data set \"/x\", found others than the numbers have");
  }
  const std::string lengths = little(kRows, 8) + little(kColumns, 8);
  CHECK(said_with({}, lengths, little(1'000'000, 8) + little(kColumns, 8)) ==
        "f: expected at most 1000000 bytes of the data set \"/x\", found more");
  const std::string whole = Hdf5Writer(values, type, {}).file();
  CHECK(error_of(read_hdf5(named(whole), "/z")) ==
        "f: expected a data set \"/z\", found no \"z\" in it");
  const std::string address = little(whole.size() - 60, 8) + little(60, 8);
  CHECK(said_with({}, address, std::string(8, '\xff') + little(60, 8)) ==
        "f: expected data of the data set \"/x\", found none that were written");
}

TEST_CASE("hdf5: the header of an object may go on elsewhere, behind a signature") {
  const auto part = [](unsigned type, const std::string& data) {
    return little(type, 1) + little(data.size(), 2) + little(0, 1) + data;
  };
  const std::string numbers = little(5, 4) + little(6, 4), checksum = little(0, 4);
  const std::string rest =
      "OCHK" + part(0x08, little(3, 1) + little(0, 1) + little(8, 2) + numbers) + checksum;
  const auto file = [&](const std::string& behind, std::size_t length) {
    constexpr std::size_t kSuperblock = 48;
    const auto set_with = [&](std::size_t at) {
      const std::string parts =
          part(0x03, number_type({})) +
          part(0x01, little(2, 1) + little(1, 1) + little(0, 2) + little(2, 8)) +
          part(0x10, little(at, 8) + little(length, 8));
      return "OHDR" + little(2, 1) + little(0, 1) + little(parts.size(), 1) + parts + checksum;
    };
    const std::string root = header(
        message(0x06, little(1, 1) + little(0, 1) + little(1, 1) + "x" + little(kSuperblock, 8)));
    const std::size_t root_at = kSuperblock + set_with(0).size();
    const std::size_t rest_at = root_at + root.size();
    return "\x89HDF\r\n\x1a\n" + little(2, 1) + little(8, 1) + little(8, 1) + little(0, 1) +
           little(0, 8) + little(~std::uint64_t{0}, 8) + little(rest_at + behind.size(), 8) +
           little(root_at, 8) + little(0, 4) + set_with(rest_at) + root + behind;
  };
  const auto read = [](const std::string& text) { return read_hdf5(named(text), "/x"); };
  const std::string whole = file(rest, rest.size());
  const Source source = named(whole);
  const auto array = read_hdf5(source, "/x");
  REQUIRE_MESSAGE(array, error_of(array));
  CHECK(array->bytes == numbers);
  CHECK(error_of(read(file("OHDR" + rest.substr(4), rest.size())))
            .find("expected where a header goes on") != std::string::npos);
  CHECK(error_of(read(file(rest, 7))).find("expected where a header goes on") != std::string::npos);
}

TEST_CASE("xdmf: bytes beside it are the same numbers in every type and byte order") {
  const ScratchFolder folder;
  const auto mesh_with = [&](const std::string& attributes, const std::string& path) {
    const std::string text =
        "<Xdmf><Domain><Grid><Geometry GeometryType=\"XY\"><DataItem Dimensions=\"3 2\">0 0 1 0 0 1"
        "</DataItem></Geometry><Topology TopologyType=\"Triangle\"><DataItem Dimensions=\"1 3\" "
        "Format=\"Binary\" " +
        attributes + ">" + path + "</DataItem></Topology></Grid></Domain></Xdmf>";
    Source source = named(text);
    source.name = folder.path("x.xdmf");
    return read_xdmf(source, kDouble);
  };
  const std::vector<Simplex> expected = {{2, 0, 1}};
  std::string attributes, bytes;
  for (const char* const type : {"Int", "UInt", "Char", "UChar"}) {
    for (const ByteOrder order : {ByteOrder::kLittleEndian, ByteOrder::kBigEndian}) {
      for (const std::size_t size : {4U, 8U}) {
        const bool is_char = std::string(type).ends_with("Char");
        bytes.clear();
        for (const Vertex v : expected.front())
          bytes += stored(static_cast<std::uint64_t>(v), is_char ? 1 : size, order);
        attributes = std::string("NumberType=\"") + type + "\" Precision=\"" +
                     std::to_string(size) + "\" Endian=\"" +
                     (order == ByteOrder::kBigEndian ? "Big" : "Little") + "\"";
        folder.write("cells.bin", bytes);
        const auto read = mesh_with(attributes, "cells.bin");
        CAPTURE(attributes);
        REQUIRE_MESSAGE(read, error_of(read));
        CHECK(read->triangles.simplices == expected);
      }
    }
  }
  // From another place in the file, or from a file elsewhere, they would be others.
  attributes = "NumberType=\"UChar\"";
  folder.write("cells.bin", std::string("\2\0\1", 3));
  CHECK(mesh_with(attributes, "cells.bin"));
  CHECK(error_of(mesh_with(attributes + " Seek=\"1\"", "cells.bin"))
            .find("without Compression or Seek") != std::string::npos);
  const std::size_t slash = folder.path("").find_last_not_of('/');
  const std::string name = folder.path("").substr(0, slash + 1);
  const std::string up = "../" + name.substr(name.rfind('/') + 1) + "/cells.bin";
  CHECK(error_of(mesh_with(attributes, up)).find("a file in the same folder or below it") !=
        std::string::npos);
}

}  // namespace circumspect::formats
