#include "oracle/formats/npy.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <string_view>

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

constexpr Wanted kPoints = {"points", "(n, d)", "float64 ('<f8')", "points.astype('<f8')"};
constexpr Wanted kSimplices = {"simplices", "(m, d + 1)", "int32 or int64 ('<i4', '<i8')",
                               "simplices.astype('<i8')"};

tl::unexpected<FormatError> fail(const std::string& name, std::string expected, std::string found) {
  return tl::unexpected(FormatError{name, 0, std::move(expected), std::move(found)});
}

tl::unexpected<FormatError> wrong_type(const std::string& name, const Wanted& wanted,
                                       const std::string& type) {
  const std::string order = type.starts_with('>') ? " (big-endian)" : "";
  return fail(name, std::string(wanted.what) + " of type " + std::string(wanted.types),
              quote(type) + order + "; numpy.save(file, " + std::string(wanted.as_wanted) +
                  ") writes what is read");
}

// Rows and columns, if all that the header says of them fits together and to the size of the file.
Result<Shape> shape_of(const NpyHeader& header, const RandomAccess& file, const std::string& name,
                       const Wanted& wanted, std::size_t bytes_each) {
  if (header.fortran_order) {
    return fail(name, std::string(wanted.what) + " row after row (C order)",
                "Fortran order; numpy.save(file, numpy.ascontiguousarray(" +
                    std::string(wanted.what) + ")) writes what is read");
  }
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

// Takes the bytes as numbers in little-endian order. Requires: they are as many as `to` holds.
template <class Value>
Status read_values(const RandomAccess& file, std::size_t begin, const std::string& name,
                   std::span<Value> to) {
  if (!file.read(begin, to.size_bytes(), reinterpret_cast<char*>(to.data()))) {
    return fail(name, std::to_string(to.size_bytes()) + " bytes of data", "fewer");
  }
  if constexpr (std::endian::native == std::endian::big) {
    for (Value& value : to) {
      char* const bytes = reinterpret_cast<char*>(&value);
      std::reverse(bytes, bytes + sizeof value);
    }
  }
  return {};
}

template <class Value>
Result<Rows<Value>> read_rows(const NpyHeader& header, const RandomAccess& file,
                              const std::string& name, const Shape& shape) {
  Rows<Value> rows(shape.rows, shape.columns);
  if (Status read = read_values(file, header.end, name, rows.values()); !read) {
    return tl::unexpected(read.error());
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

template <class Index>
Result<NpySimplices> read_simplices(const NpyHeader& header, const RandomAccess& file,
                                    const std::string& name) {
  const Result<Shape> shape = shape_of(header, file, name, kSimplices, sizeof(Index));
  if (!shape) return tl::unexpected(shape.error());
  if (shape->columns == 0) {
    return fail(name, "simplices of at least 1 vertex", "shape " + header.shape_in_words());
  }
  Result<Rows<Index>> rows = read_rows<Index>(header, file, name, *shape);
  if (!rows) return tl::unexpected(rows.error());
  return NpySimplices(std::move(*rows));
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
  if (header->type != "<f8") return wrong_type(name, kPoints, header->type);
  const Result<Shape> shape = shape_of(*header, file, name, kPoints, sizeof(double));
  if (!shape) return tl::unexpected(shape.error());
  if (shape->columns < 1 || shape->columns > kLargestDimension) {
    return fail(name, "points of dimension 1 to " + std::to_string(kLargestDimension),
                "shape " + header->shape_in_words());
  }
  Result<Rows<double>> points = read_rows<double>(*header, file, name, *shape);
  if (!points) return points;
  if (Status finite = check_coordinates(*points, name); !finite) {
    return tl::unexpected(finite.error());
  }
  return points;
}

Result<NpySimplices> read_rows_of_npy_simplices(const RandomAccess& file, const std::string& name) {
  const Result<NpyHeader> header = read_npy_header(file, name);
  if (!header) return tl::unexpected(header.error());
  if (header->type == "<i4") return read_simplices<std::int32_t>(*header, file, name);
  if (header->type == "<i8") return read_simplices<std::int64_t>(*header, file, name);
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
