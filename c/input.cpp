#include "c/input.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "c/guard.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/judge/domain/triangle_walls.hpp"
#include "oracle/model/printable.hpp"

namespace circumspect::c {
namespace {

// a·b, if arrays of so many entries can exist. Requires: neither is negative.
std::size_t product(std::int64_t a, std::int64_t b, const char* what) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() / 16;
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

// An array of that many entries: empty where there are none, whatever the pointer.
template <class Value>
std::span<const Value> array(const Value* values, std::size_t size, const char* what) {
  if (size == 0) return {};
  return {required(values, what), size};
}

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

// Doubles where they lie, or texts; doubles of texts that are all of them doubles.
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

void take_faces(const std::int64_t* indices, std::int64_t count, std::int64_t vertices,
                const char* what, std::vector<Simplex>& faces) {
  require_count(count, what);
  const auto all = array(indices, product(count, vertices, what), what);
  for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(vertices)) {
    const auto row = all.subspan(i, static_cast<std::size_t>(vertices));
    faces.emplace_back(row.begin(), row.end());
  }
}

// The entries [starts[i], starts[i + 1]) of a list that has `count` parts.
std::span<const std::int64_t> starts_of(const std::int64_t* starts, std::int64_t count,
                                        const char* what) {
  const auto all = array(starts, static_cast<std::size_t>(count) + 1, what);
  if (all.front() != 0 || !std::is_sorted(all.begin(), all.end())) {
    refuse_call(fmt::format("expected {} that ascend from 0, found others", what));
  }
  return all;
}

std::vector<PolygonLines> polygons_of(const circumspect_domain& domain) {
  require_count(domain.polygon_count, "polygons");
  std::vector<PolygonLines> polygons;
  if (domain.polygon_count == 0) return polygons;
  if (domain.dimension == 2) refuse_call("expected no polygons in the plane, found some");
  const auto lines = starts_of(domain.polygon_starts, domain.polygon_count, "polygon_starts");
  const auto corners = starts_of(domain.line_starts, lines.back(), "line_starts");
  const auto all = array(domain.corners, static_cast<std::size_t>(corners.back()), "corners");
  for (std::size_t p = 0; p + 1 < lines.size(); ++p) {
    PolygonLines& polygon = polygons.emplace_back();
    for (auto l = static_cast<std::size_t>(lines[p]); l < static_cast<std::size_t>(lines[p + 1]);
         ++l) {
      const auto first = static_cast<std::size_t>(corners[l]);
      const auto line = all.subspan(first, static_cast<std::size_t>(corners[l + 1]) - first);
      if (line.empty()) refuse_call("expected lines with corners, found one without");
      polygon.lines.emplace_back(line.begin(), line.end());
    }
  }
  return polygons;
}

void take_polygon_holes(const circumspect_domain& domain, std::vector<PolygonLines>& polygons) {
  require_count(domain.polygon_hole_count, "holes of polygons");
  const auto size = static_cast<std::size_t>(domain.polygon_hole_count);
  const auto owners = array(domain.polygons_of_holes, size, "polygons_of_holes");
  const std::vector<Point> seeds =
      exact_points(domain.polygon_hole_count, domain.dimension, domain.polygon_hole_seeds,
                   domain.exact_polygon_hole_seeds);
  for (std::size_t i = 0; i < owners.size(); ++i) {
    if (owners[i] < 0 || owners[i] >= domain.polygon_count) {
      refuse_call(fmt::format("expected hole {} in one of {} polygons, found it in polygon {}", i,
                              domain.polygon_count, owners[i]));
    }
    polygons[static_cast<std::size_t>(owners[i])].hole_seeds.push_back(seeds[i]);
  }
}

std::string breach_text(const std::vector<Breach>& breaches) {
  const Breach& first = breaches.front();
  std::string text = fmt::format("expected a piecewise linear complex, found {}: {}",
                                 identifier(first.kind), meaning(first.kind));
  for (const std::size_t polygon : first.polygons) text += fmt::format(", polygon {}", polygon);
  for (const Simplex& segment : first.segments) {
    text += fmt::format(", segment {}", fmt::join(segment, " "));
  }
  if (!first.vertices.empty()) text += fmt::format(", vertices {}", fmt::join(first.vertices, " "));
  if (first.point) {
    std::string separator = ", point (";
    for (const Rational& x : *first.point) {
      text += separator + to_text_of_double_or_fraction(x);
      separator = ", ";
    }
    text += ")";
  }
  if (breaches.size() > 1) text += fmt::format(" (and {} more)", breaches.size() - 1);
  return text;
}

DomainKind kind_of(const PiecewiseLinearComplex& complex, std::int32_t asked) {
  if (asked == CIRCUMSPECT_ENCLOSED) return DomainKind::kEnclosed;
  const bool is_flat = complex.points.dimension() < static_cast<int>(complex.ambient_dimension());
  if (asked == CIRCUMSPECT_HULL) {
    if (is_flat) refuse_input("expected points that do not all lie in one hyperplane for a hull");
    return DomainKind::kHull;
  }
  if (Regions(complex).size() > 1 || is_flat) return DomainKind::kEnclosed;
  if (walls(complex).empty()) return DomainKind::kHull;
  refuse_input(
      "expected walls that enclose something, found some that enclose nothing: close the gap, or "
      "say "
      "of which kind the domain is, enclosed or hull");
}

}  // namespace

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

Domain domain_of(const circumspect_domain& given) {
  const circumspect_domain domain = of_any_version<circumspect_domain>(
      given, CIRCUMSPECT_DOMAIN, {offsetof(circumspect_domain, polygon_hole_count)},
      "CIRCUMSPECT_DOMAIN");
  require_dimension(domain.dimension, 2, 3);
  require_count(domain.point_count, "points");
  require_count(domain.segment_count, "segments");
  require_count(domain.hole_count, "hole seeds");
  if (domain.kind < CIRCUMSPECT_KIND_BY_WALLS || domain.kind > CIRCUMSPECT_HULL) {
    refuse_call(fmt::format("expected the kind of a domain, found {}", domain.kind));
  }
  PiecewiseLinearInput input;
  input.points = exact_points(domain.point_count, domain.dimension, domain.coordinates,
                              domain.exact_coordinates);
  if (input.points.empty()) refuse_input("expected a domain with points, found none");
  take_faces(domain.segments, domain.segment_count, 2, "segments", input.segments);
  input.polygons = polygons_of(domain);
  take_polygon_holes(domain, input.polygons);
  input.hole_seeds =
      exact_points(domain.hole_count, domain.dimension, domain.hole_seeds, domain.exact_hole_seeds);
  auto complex = check::validated_domain(input);
  if (!complex) refuse_input(breach_text(complex.error()));
  complex->kind = kind_of(*complex, domain.kind);
  return {std::move(*complex)};
}

}  // namespace circumspect::c
