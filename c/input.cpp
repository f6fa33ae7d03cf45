#include "c/input.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include <fmt/format.h>

#include "c/guard.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::c {
namespace {

void require_finite(std::span<const double> values, const char* what) {
  const auto wrong =
      std::find_if_not(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
  if (wrong == values.end()) return;
  refuse_input(fmt::format("expected finite {}, found {} at place {}", what, *wrong,
                           wrong - values.begin()));
}

Rational exact_number(const char* text, const char* what, std::size_t place) {
  required(text, "the text of a number");
  const auto number = read_number(text, NumberReading::kDecimal);
  if (number) return *number;
  refuse_input(fmt::format("expected {}, found {} in the {} at place {}", number.error().expected,
                           std::string(text).substr(0, 60), what, place));
}

Rows<Rational> exact_rows(std::span<const char* const> texts, std::size_t columns,
                          const char* what) {
  Rows<Rational> rows(texts.size() / columns, columns);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    rows.values()[i] = exact_number(texts[i], what, i);
  }
  return rows;
}

// Doubles in place, or texts; texts become doubles if all of them are doubles.
Numbers numbers(const double* doubles, const char* const* texts, std::size_t size,
                std::size_t columns, const char* what) {
  if (doubles != nullptr || texts == nullptr) {
    const std::span<const double> values = array(doubles, size, what);
    require_finite(values, what);
    return Rows<double>::of(values, columns);
  }
  Rows<Rational> exact = exact_rows({texts, size}, columns, what);
  Rows<double> nearest(exact.rows(), columns);
  for (std::size_t i = 0; i < size; ++i) {
    const double value = exact.values()[i].get_d();
    if (!std::isfinite(value) || exact_value(value) != exact.values()[i]) return exact;
    nearest.values()[i] = value;
  }
  return nearest;
}

template <class Index>
void take_simplices(const circumspect_mesh& mesh, std::size_t size, Mesh& taken) {
  const auto columns = static_cast<std::size_t>(mesh.vertices_of_simplex);
  const auto rows = [&](const void* values, const char* what) {
    return Rows<Index>::of(array(static_cast<const Index*>(values), size, what), columns);
  };
  taken.simplices = rows(mesh.simplices, "simplices");
  if (mesh.neighbors != nullptr) taken.neighbors.emplace(rows(mesh.neighbors, "neighbors"), 0);
}

constexpr Claim kClaims[] = {Claim::kTriangulation,        Claim::kDelaunay,
                             Claim::kWeightedDelaunay,     Claim::kPlcTriangulation,
                             Claim::kSteinerTriangulation, Claim::kCdt,
                             Claim::kSteinerCdt,           Claim::kConformingDelaunay};

}  // namespace

std::size_t product(std::int64_t a, std::int64_t b, const char* what) {
  constexpr std::int64_t kMost = std::int64_t{1} << 54;
  if (b != 0 && a > kMost / b) refuse_call(fmt::format("expected fewer {}, found {}", what, a));
  return static_cast<std::size_t>(a) * static_cast<std::size_t>(b);
}

void require_count(std::int64_t count, const char* what) {
  if (count < 0) refuse_call(fmt::format("expected a number of {}, found {}", what, count));
}

void require_dimension(std::int64_t dimension, std::int64_t least, std::int64_t most) {
  if (dimension >= least && dimension <= most) return;
  refuse_call(fmt::format("expected a dimension from {} to {}, found {}", least, most, dimension));
}

void take_faces(const std::int64_t* indices, std::int64_t count, std::int64_t vertices,
                const char* what, std::vector<Simplex>& faces) {
  require_count(count, what);
  const auto all = array(indices, product(count, vertices, what), what);
  for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(vertices)) {
    const auto row = all.subspan(i, static_cast<std::size_t>(vertices));
    faces.emplace_back(row.begin(), row.end());
  }
}

Mesh mesh_of(const circumspect_mesh& mesh, bool weighted) {
  if (mesh.struct_size != sizeof(circumspect_mesh)) {
    refuse_call("expected a mesh that began as CIRCUMSPECT_MESH, found another struct_size");
  }
  require_dimension(mesh.dimension, 1, kLargestDimension);
  require_count(mesh.point_count, "points");
  require_count(mesh.simplex_count, "simplices");
  require_count(mesh.vertices_of_simplex, "vertices of a simplex");
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  Mesh taken;
  taken.coordinates =
      numbers(mesh.coordinates, mesh.exact_coordinates,
              product(mesh.point_count, mesh.dimension, "points"), dimension, "coordinates");
  if (weighted && (mesh.weights != nullptr || mesh.exact_weights != nullptr)) {
    taken.weights = numbers(mesh.weights, mesh.exact_weights,
                            static_cast<std::size_t>(mesh.point_count), 1, "weights");
  }
  if (mesh.simplex_count > 0) {
    if (mesh.vertices_of_simplex == 0) refuse_call("expected vertices of a simplex, found 0");
    const std::size_t size = product(mesh.simplex_count, mesh.vertices_of_simplex, "simplices");
    if (mesh.index_bytes == 4) {
      take_simplices<std::int32_t>(mesh, size, taken);
    } else if (mesh.index_bytes == 8) {
      take_simplices<std::int64_t>(mesh, size, taken);
    } else {
      refuse_call(fmt::format("expected indices of 4 or 8 bytes, found {}", mesh.index_bytes));
    }
  }
  take_faces(mesh.triangles, mesh.triangle_count, 3, "triangles", taken.faces);
  take_faces(mesh.edges, mesh.edge_count, 2, "edges", taken.faces);
  return taken;
}

Mesh points_of(const circumspect_mesh* points) {
  circumspect_mesh alone = *required(points, "a mesh");
  alone.simplex_count = alone.triangle_count = alone.edge_count = 0;
  alone.neighbors = nullptr;
  return mesh_of(alone, true);
}

void refuse_empty(const Mesh& mesh, const Option& option) {
  if (mesh.points() > 0 || !mesh.simplices.empty() || !mesh.faces.empty()) return;
  refuse_input(
      "expected a mesh, found neither points nor simplices, as where a program made nothing",
      option);
}

void refuse_equal_points(const std::vector<Duplicate>& repeated, const Option& option) {
  if (repeated.empty()) return;
  const Duplicate& first = repeated.front();
  refuse_input(report::fault_of_equal_points(first.kept, first.again, repeated.size(), ""), option);
}

std::vector<Point> exact_points(std::int64_t count, std::int64_t dimension, const double* doubles,
                                const char* const* texts) {
  const std::size_t size = product(count, dimension, "points");
  const auto columns = static_cast<std::size_t>(dimension);
  const Numbers all = numbers(doubles, texts, size, columns, "coordinates");
  std::vector<Point> points(static_cast<std::size_t>(count), Point(columns));
  std::visit(
      [&](const auto& rows) {
        for (std::size_t i = 0; i < size; ++i) {
          if constexpr (std::is_same_v<std::decay_t<decltype(rows)>, Rows<double>>) {
            points[i / columns][i % columns] = exact_value(rows.values()[i]);
          } else {
            points[i / columns][i % columns] = rows.values()[i];
          }
        }
      },
      all);
  return points;
}

Claim claim_of(const char* text, bool has_domain) {
  const std::string word = required(text, "a claim");
  std::string known;
  for (const ClaimEntry& one : claims()) {
    if (one.is_about_a_domain != has_domain) continue;
    if (one.name == word) return one.claim;
    known += fmt::format(" {}", one.name);
  }
  refuse_call(fmt::format("expected a claim about a mesh {} domain, one of{}; found '{}'",
                          has_domain ? "and its" : "without a", known, on_one_line(word)));
}

}  // namespace circumspect::c
