#include "oracle/formats/npy.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace circumspect::formats {
namespace {

struct Shape {
  std::size_t rows = 0;
  std::size_t columns = 0;
};

// What is wanted of an array, for messages.
struct Wanted {
  std::string_view what;
  std::string_view shape;
  std::string_view types;
  std::string_view as_wanted;  // what makes it so in Python
};

constexpr Wanted kPoints = {"points", "(n, d)", "float64 or float32 ('<f8', '<f4')",
                            "points.astype('<f8')"};
constexpr Wanted kSimplices = {"simplices", "(m, d + 1)", "integers ('<i8', '<i4', '<u4', ...)",
                               "simplices.astype('<i8')"};

tl::unexpected<FormatError> fail(const std::string& name, std::string expected, std::string found) {
  return tl::unexpected(FormatError{name, 0, std::move(expected), std::move(found)});
}

tl::unexpected<FormatError> wrong_type(const std::string& name, const Wanted& wanted,
                                       const std::string& type) {
  return fail(name, std::string(wanted.what) + " of type " + std::string(wanted.types),
              quote(type) + "; numpy.save(file, " + std::string(wanted.as_wanted) +
                  ") writes what is read");
}

// Rows and columns, if all that the header says of them fits together and to the size of the file.
Result<Shape> shape_of(const NpyHeader& header, const RandomAccess& file, const std::string& name,
                       const Wanted& wanted, std::size_t bytes_each) {
  if (header.shape.size() != 2) {
    return fail(name, "an array of shape " + std::string(wanted.shape),
                "shape " + header.shape_in_words());
  }
  const Shape shape{header.shape[0], header.shape[1]};
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

// Takes the bytes as numbers, as they lie there. Requires: they are as many as `to` holds.
template <class Value>
Status read_values(const RandomAccess& file, const NpyHeader& header, const std::string& name,
                   std::span<Value> to) {
  if (!file.read(header.end, to.size_bytes(), reinterpret_cast<char*>(to.data()))) {
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

// Rows of numbers that are read as `Stored` and kept as `Value`, which has room for each of them.
template <class Value, class Stored = Value>
Result<Rows<Value>> read_rows(const NpyHeader& header, const RandomAccess& file,
                              const std::string& name, const Shape& shape) {
  Rows<Value> rows(shape.rows, shape.columns);
  if constexpr (std::is_same_v<Value, Stored>) {
    if (!header.fortran_order) {
      if (Status read = read_values(file, header, name, rows.values()); !read) {
        return tl::unexpected(read.error());
      }
      return rows;
    }
  }
  std::vector<Stored> stored(rows.values().size());
  if (Status read = read_values(file, header, name, std::span(stored)); !read) {
    return tl::unexpected(read.error());
  }
  // In Fortran order the columns stand one after the other.
  const std::size_t next_row = header.fortran_order ? 1 : shape.columns;
  const std::size_t next_column = header.fortran_order ? shape.rows : 1;
  for (std::size_t i = 0; i < shape.rows; ++i) {
    for (std::size_t j = 0; j < shape.columns; ++j) {
      rows.row(i)[j] = static_cast<Value>(stored[i * next_row + j * next_column]);
    }
  }
  return rows;
}

// All finite, and −0 made 0.
Status check_coordinates(Rows<double>& points, const std::string& name) {
  const std::span<double> values = points.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      return fail(name, "finite coordinates",
                  std::string(std::isnan(values[i]) ? "NaN" : "an infinity") + " in row " +
                      std::to_string(i / points.columns()) + ", column " +
                      std::to_string(i % points.columns()) + ", counted from 0");
    }
    values[i] += 0.0;
  }
  return {};
}

template <class Index, class Stored = Index>
Result<NpySimplices> read_simplices(const NpyHeader& header, const RandomAccess& file,
                                    const std::string& name) {
  const Result<Shape> shape = shape_of(header, file, name, kSimplices, sizeof(Stored));
  if (!shape) return tl::unexpected(shape.error());
  if (shape->columns == 0) {
    return fail(name, "simplices of at least 1 vertex", "shape " + header.shape_in_words());
  }
  Result<Rows<Index>> rows = read_rows<Index, Stored>(header, file, name, *shape);
  if (!rows) return tl::unexpected(rows.error());
  if constexpr (std::is_same_v<Stored, std::uint64_t>) {
    // What had no room became negative.
    const auto values = rows->values();
    if (std::any_of(values.begin(), values.end(), [](Index v) { return v < 0; })) {
      return fail(name, "vertices below 2^63", "a larger one");
    }
  }
  return NpySimplices(std::move(*rows));
}

template <class Stored>
Result<Rows<double>> read_points(const NpyHeader& header, const RandomAccess& file,
                                 const std::string& name) {
  const Result<Shape> shape = shape_of(header, file, name, kPoints, sizeof(Stored));
  if (!shape) return tl::unexpected(shape.error());
  if (shape->columns < 1 || shape->columns > kLargestDimension) {
    return fail(name, "points of dimension 1 to " + std::to_string(kLargestDimension),
                "shape " + header.shape_in_words());
  }
  Result<Rows<double>> points = read_rows<double, Stored>(header, file, name, *shape);
  if (!points) return points;
  if (Status finite = check_coordinates(*points, name); !finite) {
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

template <class Index>
SimplexFile as_lists(const Rows<Index>& rows) {
  SimplexFile file;
  file.vertices_per_simplex = rows.columns();
  file.simplices.reserve(rows.rows());
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    file.simplices.emplace_back(rows.row(i).begin(), rows.row(i).end());
  }
  file.lines.assign(rows.rows(), 0);
  return file;
}

}  // namespace

Result<Rows<double>> read_rows_of_npy_points(const RandomAccess& file, const std::string& name) {
  const Result<NpyHeader> header = read_npy_header(file, name);
  if (!header) return tl::unexpected(header.error());
  const std::string_view kind = kind_of(*header);
  // Every float is a double.
  if (kind == "f8") return read_points<double>(*header, file, name);
  if (kind == "f4") return read_points<float>(*header, file, name);
  return wrong_type(name, kPoints, header->type);
}

Result<NpySimplices> read_rows_of_npy_simplices(const RandomAccess& file, const std::string& name) {
  const Result<NpyHeader> header = read_npy_header(file, name);
  if (!header) return tl::unexpected(header.error());
  const std::string_view kind = kind_of(*header);
  if (kind == "i4") return read_simplices<std::int32_t>(*header, file, name);
  if (kind == "i8") return read_simplices<std::int64_t>(*header, file, name);
  if (kind == "u8") return read_simplices<std::int64_t, std::uint64_t>(*header, file, name);
  if (kind == "u4") return read_simplices<std::int64_t, std::uint32_t>(*header, file, name);
  if (kind == "i2") return read_simplices<std::int32_t, std::int16_t>(*header, file, name);
  if (kind == "u2") return read_simplices<std::int32_t, std::uint16_t>(*header, file, name);
  if (kind == "i1") return read_simplices<std::int32_t, std::int8_t>(*header, file, name);
  if (kind == "u1") return read_simplices<std::int32_t, std::uint8_t>(*header, file, name);
  return wrong_type(name, kSimplices, header->type);
}

Result<PointFile> read_npy_points(const Source& source) {
  const auto points =
      read_rows_of_npy_points(RandomAccess(std::string_view(source.text)), source.name);
  if (!points) return tl::unexpected(points.error());
  PointFile file;
  file.dimension = points->columns();
  file.points.reserve(points->rows());
  for (std::size_t i = 0; i < points->rows(); ++i) {
    Point& point = file.points.emplace_back();
    for (const double coordinate : points->row(i)) point.push_back(exact_value(coordinate));
  }
  return file;
}

Result<SimplexFile> read_npy_simplices(const Source& source) {
  const auto simplices =
      read_rows_of_npy_simplices(RandomAccess(std::string_view(source.text)), source.name);
  if (!simplices) return tl::unexpected(simplices.error());
  return std::visit([](const auto& rows) { return as_lists(rows); }, *simplices);
}

}  // namespace circumspect::formats
