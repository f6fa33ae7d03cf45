#include "oracle/formats/npy.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include <zlib.h>

#include "oracle/formats/bytes/mixed_text.hpp"

namespace circumspect::formats {
namespace {

// The shape of an array, and which of its rows are read.
struct Shape {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::size_t first = 0;  // from this row on
  std::size_t count = 0;  // so many
};

// What is expected of an array, for messages.
struct Wanted {
  std::string_view what;
  std::string_view shape;
  std::string_view types;
  std::string_view as_wanted;  // the Python call that converts it
};

constexpr Wanted kPoints = {"points", "(n, d)", "float64 or float32 ('<f8', '<f4')",
                            "points.astype('<f8')"};
constexpr Wanted kSimplices = {"simplices", "(m, d + 1)", "integers ('<i8', '<i4', '<u4', ...)",
                               "simplices.astype('<i8')"};
constexpr Wanted kIndices = {"indices", "(n,)", kSimplices.types, "indices.astype('<i8')"};

tl::unexpected<FormatError> fail(const std::string& name, std::string expected, std::string found) {
  return tl::unexpected(FormatError{name, 0, std::move(expected), std::move(found)});
}

tl::unexpected<FormatError> wrong_type(const std::string& name, const Wanted& wanted,
                                       const std::string& type) {
  return fail(name, std::string(wanted.what) + " of type " + std::string(wanted.types),
              quote(type) + "; numpy.save(file, " + std::string(wanted.as_wanted) +
                  ") writes what is read");
}

// Rows and columns, if the header is consistent with itself and with the size of the file.
Result<Shape> shape_of(const NpyHeader& header, const RandomAccess& file, const std::string& name,
                       const Wanted& wanted, std::size_t bytes_each, Slice rows) {
  const bool is_list = wanted.what == kIndices.what;
  if (header.shape.size() != (is_list ? 1 : 2)) {
    return fail(name, "an array of shape " + std::string(wanted.shape),
                "shape " + header.shape_in_words());
  }
  Shape shape{header.shape[0], is_list ? 1 : header.shape[1]};
  shape.first = std::min<std::size_t>(rows.begin, shape.rows);
  shape.count = std::min<std::size_t>(rows.end, shape.rows) - shape.first;
  std::size_t bytes = 0;
  const bool overflows = __builtin_mul_overflow(shape.rows, shape.columns, &bytes) ||
                         __builtin_mul_overflow(bytes, bytes_each, &bytes);
  const std::size_t found = file.size() - header.end;
  if (overflows || bytes != found) {
    return fail(name,
                (overflows ? "more bytes than fit a file" : std::to_string(bytes) + " bytes") +
                    " of data, for shape " + header.shape_in_words(),
                std::to_string(found));
  }
  return shape;
}

// Reads the bytes as numbers in the order of the file, from number `first` of the array on.
template <class Value>
Status read_values(const RandomAccess& file, const NpyHeader& header, const std::string& name,
                   std::size_t first, std::span<Value> to) {
  const std::size_t offset = header.end + first * sizeof(Value);
  if (!file.read(offset, to.size_bytes(), reinterpret_cast<char*>(to.data()))) {
    return fail(name, std::to_string(to.size_bytes()) + " bytes of data", "fewer");
  }
  const auto order = header.type.front() == '>' ? std::endian::big : std::endian::little;
  if (order == std::endian::native || sizeof(Value) == 1) return {};
  for (Value& value : to) {
    char* const bytes = reinterpret_cast<char*>(&value);
    std::reverse(bytes, bytes + sizeof value);
  }
  return {};
}

// Rows of numbers that are read as `Stored` and kept as `Value`, which can represent each of them.
template <class Value, class Stored = Value>
Result<Rows<Value>> read_rows(const NpyHeader& header, const RandomAccess& file,
                              const std::string& name, const Shape& shape) {
  Rows<Value> rows(shape.count, shape.columns);
  if constexpr (std::is_same_v<Value, Stored>) {
    if (!header.fortran_order) {
      const std::size_t first = shape.first * shape.columns;
      if (Status read = read_values(file, header, name, first, rows.values()); !read) {
        return tl::unexpected(read.error());
      }
      return rows;
    }
  }
  // In Fortran order, columns follow one another.
  const std::size_t runs = header.fortran_order ? shape.columns : 1;
  std::vector<Stored> stored(rows.values().size() / std::max<std::size_t>(runs, 1));
  for (std::size_t run = 0; run < runs; ++run) {
    const std::size_t first =
        header.fortran_order ? run * shape.rows + shape.first : shape.first * shape.columns;
    if (Status read = read_values(file, header, name, first, std::span(stored)); !read) {
      return tl::unexpected(read.error());
    }
    for (std::size_t i = 0; i < stored.size(); ++i) {
      const std::size_t to = header.fortran_order ? i * shape.columns + run : i;
      rows.values()[to] = static_cast<Value>(stored[i]);
    }
  }
  return rows;
}

// Checks that all are finite, and turns −0 into 0.
Status check_coordinates(Rows<double>& points, std::size_t first_row, const std::string& name) {
  const std::span<double> values = points.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      return fail(name, "finite coordinates",
                  std::string(std::isnan(values[i]) ? "NaN" : "an infinity") + " in row " +
                      std::to_string(first_row + i / points.columns()) + ", column " +
                      std::to_string(i % points.columns()) + ", counted from 0");
    }
    values[i] += 0.0;
  }
  return {};
}

template <class Index, class Stored = Index>
Result<NpySimplices> read_simplices(const NpyHeader& header, const RandomAccess& file,
                                    const std::string& name, const Wanted& wanted, Slice rows) {
  const Result<Shape> shape = shape_of(header, file, name, wanted, sizeof(Stored), rows);
  if (!shape) return tl::unexpected(shape.error());
  if (shape->columns == 0) {
    return fail(name, "simplices of at least 1 vertex", "shape " + header.shape_in_words());
  }
  Result<Rows<Index>> read = read_rows<Index, Stored>(header, file, name, *shape);
  if (!read) return tl::unexpected(read.error());
  if constexpr (std::is_same_v<Stored, std::uint64_t>) {
    // Values that did not fit became negative.
    const auto values = read->values();
    if (std::any_of(values.begin(), values.end(), [](Index v) { return v < 0; })) {
      return fail(name, "vertices below 2^63", "a larger one");
    }
  }
  return NpySimplices(std::move(*read));
}

template <class Stored>
Result<Rows<double>> read_points(const NpyHeader& header, const RandomAccess& file,
                                 const std::string& name, Slice rows) {
  const Result<Shape> shape = shape_of(header, file, name, kPoints, sizeof(Stored), rows);
  if (!shape) return tl::unexpected(shape.error());
  if (shape->columns < 1 || shape->columns > kLargestDimension) {
    return fail(name, "points of dimension 1 to " + std::to_string(kLargestDimension),
                "shape " + header.shape_in_words());
  }
  Result<Rows<double>> points = read_rows<double, Stored>(header, file, name, *shape);
  if (!points) return points;
  if (Status finite = check_coordinates(*points, shape->first, name); !finite) {
    return tl::unexpected(finite.error());
  }
  return points;
}

// The type without its byte order: "f8".
std::string_view kind_of(const NpyHeader& header) {
  const std::string_view type = header.type;
  const bool has_order = type.size() == 3 && std::string_view("<>|").find(type[0]) != type.npos;
  return has_order ? type.substr(1) : "";
}

constexpr std::string_view kEntry = "PK\1\2", kLocalHeader = "PK\3\4", kEndOfArchive = "PK\5\6";
constexpr std::size_t kSizeOfEnd = 22, kLongestComment = 0xffff;

// How large an array may be: so many bytes in any case, and more for each byte of the archive. zlib
// compresses data by a factor of up to 1032, but not the numbers of meshes.
constexpr std::size_t kSmallEntry = 1'000'000;
constexpr std::size_t kLargestGrowthOfEntry = 100;

// What an archive says about a file in it.
struct ZipEntry {
  std::string_view name;
  bool is_encrypted = false;
  std::uint64_t method = 0;  // 0: stored, 8: packed by zlib
  std::uint64_t checksum = 0;
  std::uint64_t packed_size = 0;
  std::uint64_t size = 0;
  std::uint64_t offset = 0;  // of its header
};

// The place of the directory, which follows the files; nothing if there is none.
std::optional<std::string_view> directory_of(std::string_view archive) {
  const std::size_t farthest = kSizeOfEnd + kLongestComment;
  const std::size_t first = archive.size() > farthest ? archive.size() - farthest : 0;
  const std::size_t end = archive.rfind(kEndOfArchive);
  if (end == archive.npos || end < first || archive.size() - end < kSizeOfEnd) return std::nullopt;
  Bytes bytes(archive.substr(end), ByteOrder::kLittleEndian);
  bytes.skip(12);
  const std::uint64_t size = *bytes.unsigned_integer(4);
  const std::uint64_t offset = *bytes.unsigned_integer(4);
  if (offset > end || size > end - offset) return std::nullopt;
  return archive.substr(offset, size);
}

// Takes an entry from the front of the directory; nothing if it is not an entry.
std::optional<ZipEntry> next_entry(std::string_view& directory) {
  constexpr std::size_t kSize = 46;
  if (directory.size() < kSize || !directory.starts_with(kEntry)) return std::nullopt;
  Bytes bytes(directory, ByteOrder::kLittleEndian);
  ZipEntry entry;
  bytes.skip(8);
  entry.is_encrypted = (*bytes.unsigned_integer(2) & 1) != 0;
  entry.method = *bytes.unsigned_integer(2);
  bytes.skip(4);
  entry.checksum = *bytes.unsigned_integer(4);
  entry.packed_size = *bytes.unsigned_integer(4);
  entry.size = *bytes.unsigned_integer(4);
  const std::uint64_t length_of_name = *bytes.unsigned_integer(2);
  const std::uint64_t behind = *bytes.unsigned_integer(2) + *bytes.unsigned_integer(2);
  bytes.skip(8);
  entry.offset = *bytes.unsigned_integer(4);
  if (directory.size() - kSize < length_of_name + behind) return std::nullopt;
  entry.name = directory.substr(kSize, length_of_name);
  directory.remove_prefix(kSize + length_of_name + behind);
  return entry;
}

// The bytes of a file in the archive as they are stored; nothing if they are missing.
std::optional<std::string_view> stored_bytes(std::string_view archive, const ZipEntry& entry) {
  constexpr std::size_t kSize = 30;
  if (entry.offset > archive.size() || archive.size() - entry.offset < kSize) return std::nullopt;
  archive.remove_prefix(entry.offset);
  if (!archive.starts_with(kLocalHeader)) return std::nullopt;
  Bytes bytes(archive, ByteOrder::kLittleEndian);
  bytes.skip(26);
  const std::uint64_t before = kSize + *bytes.unsigned_integer(2) + *bytes.unsigned_integer(2);
  if (before > archive.size() || archive.size() - before < entry.packed_size) return std::nullopt;
  return archive.substr(before, entry.packed_size);
}

// Decompresses raw zlib data to so many bytes; nothing if that fails. Requires: both sizes fit 32
// bits.
std::optional<std::string> inflated(std::string_view packed, std::size_t size) {
  std::string bytes(size, '\0');
  z_stream stream = {};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return std::nullopt;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(size);
  const bool is_whole = ::inflate(&stream, Z_FINISH) == Z_STREAM_END && stream.avail_out == 0;
  inflateEnd(&stream);
  return is_whole ? std::optional(std::move(bytes)) : std::nullopt;
}

}  // namespace

bool is_npz(std::string_view beginning) { return beginning.starts_with(kLocalHeader); }

Result<Source> array_of_npz(const Source& archive, std::string_view name) {
  const std::string file = std::string(name) + ".npy";
  const std::string path = archive.name + "/" + file;
  std::optional<std::string_view> directory = directory_of(archive.text);
  if (!directory) {
    return fail(archive.name, "an archive of arrays, as numpy.savez writes it", "no ZIP file");
  }
  std::optional<ZipEntry> wanted;
  std::string names;
  while (const auto entry = next_entry(*directory)) {
    if (entry->name == file) wanted = entry;
    if (names.size() < kLongestQuote)
      names += (names.empty() ? "" : " ") + std::string(entry->name);
  }
  if (!wanted) {
    return fail(archive.name,
                "an array named " + std::string(name) +
                    ", as numpy.savez(file, points=..., simplices=...) writes it",
                names.empty() ? "none" : quote(names));
  }
  if (wanted->is_encrypted || (wanted->method != 0 && wanted->method != 8)) {
    return fail(path, "an array as numpy.savez or numpy.savez_compressed packs it",
                wanted->is_encrypted ? "one that is encrypted"
                                     : "method " + std::to_string(wanted->method));
  }
  if (wanted->size == 0xffffffff || wanted->packed_size == 0xffffffff) {
    return fail(path, "less than 4 GiB (numpy.save writes larger arrays)", "more");
  }
  const std::size_t most = kSmallEntry + kLargestGrowthOfEntry * archive.text.size();
  if (wanted->size > most) {
    return fail(path,
                "at most " + std::to_string(most) + " bytes in an archive of " +
                    std::to_string(archive.text.size()),
                std::to_string(wanted->size));
  }
  const auto stored = stored_bytes(archive.text, *wanted);
  std::optional<std::string> bytes;
  if (stored && wanted->method == 8) bytes = inflated(*stored, wanted->size);
  if (stored && wanted->method == 0) bytes = std::string(*stored);
  const auto checksum = [](const std::string& text) {
    return crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size());
  };
  if (!bytes || bytes->size() != wanted->size || checksum(*bytes) != wanted->checksum) {
    return fail(path,
                std::to_string(wanted->size) + " bytes with the checksum that the archive lists",
                "other data");
  }
  return Source{path, std::move(*bytes)};
}

Result<Rows<double>> read_rows_of_npy_points(const RandomAccess& file, const std::string& name,
                                             Slice rows) {
  const Result<NpyHeader> header = read_npy_header(file, name);
  if (!header) return tl::unexpected(header.error());
  const std::string_view kind = kind_of(*header);
  // Every float is a double.
  if (kind == "f8") return read_points<double>(*header, file, name, rows);
  if (kind == "f4") return read_points<float>(*header, file, name, rows);
  return wrong_type(name, kPoints, header->type);
}

namespace {

Result<NpySimplices> read_integers(const RandomAccess& file, const std::string& name,
                                   const Wanted& wanted, Slice rows) {
  const Result<NpyHeader> header = read_npy_header(file, name);
  if (!header) return tl::unexpected(header.error());
  const std::string_view kind = kind_of(*header);
  if (kind == "i4") return read_simplices<std::int32_t>(*header, file, name, wanted, rows);
  if (kind == "i8") return read_simplices<std::int64_t>(*header, file, name, wanted, rows);
  if (kind == "u8")
    return read_simplices<std::int64_t, std::uint64_t>(*header, file, name, wanted, rows);
  if (kind == "u4")
    return read_simplices<std::int64_t, std::uint32_t>(*header, file, name, wanted, rows);
  if (kind == "i2")
    return read_simplices<std::int32_t, std::int16_t>(*header, file, name, wanted, rows);
  if (kind == "u2")
    return read_simplices<std::int32_t, std::uint16_t>(*header, file, name, wanted, rows);
  if (kind == "i1")
    return read_simplices<std::int32_t, std::int8_t>(*header, file, name, wanted, rows);
  if (kind == "u1")
    return read_simplices<std::int32_t, std::uint8_t>(*header, file, name, wanted, rows);
  return wrong_type(name, wanted, header->type);
}

}  // namespace

Result<NpySimplices> read_rows_of_npy_simplices(const RandomAccess& file, const std::string& name,
                                                Slice rows) {
  return read_integers(file, name, kSimplices, rows);
}

Result<NpySimplices> read_npy_indices(const RandomAccess& file, const std::string& name) {
  return read_integers(file, name, kIndices, kAllRows);
}

Result<PointFile> read_npy_points(const Source& source) {
  const auto points =
      read_rows_of_npy_points(RandomAccess(std::string_view(source.text)), source.name);
  if (!points) return tl::unexpected(points.error());
  PointFile file;
  file.dimension = points->columns();
  file.points.set_columns(points->columns());
  file.points.reserve(points->rows());
  for (const double coordinate : points->values()) file.points.add(coordinate);
  return file;
}

Result<SimplexFile> read_npy_simplices(const Source& source) {
  const auto simplices =
      read_rows_of_npy_simplices(RandomAccess(std::string_view(source.text)), source.name);
  if (!simplices) return tl::unexpected(simplices.error());
  SimplexFile file;
  std::visit(
      [&file](const auto& rows) {
        Indices indices;
        indices.reserve(rows.values().size());
        for (const auto index : rows.values()) indices.push_back(index);
        file.vertices_per_simplex = rows.columns();
        file.simplices = SimplexRows(std::move(indices), rows.columns());
        for (std::size_t i = 0; i < rows.rows(); ++i) file.lines.push_back(0);
      },
      *simplices);
  return file;
}

}  // namespace circumspect::formats
