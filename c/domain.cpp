// Makes a valid domain of the struct of <circumspect/circumspect.h>, and determines which part of
// it is filled.
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "c/guard.hpp"
#include "c/input.hpp"
#include "kernel/exact/number.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/domain/coplanar_polygons.hpp"
#include "oracle/domain/filling.hpp"
#include "oracle/judge/domain/triangle_walls.hpp"
#include "oracle/report/text.hpp"

namespace circumspect::c {
namespace {

// The entries [starts[i], starts[i + 1]) of a list that has `count` parts.
std::span<const std::int64_t> starts_of(const std::int64_t* starts, std::int64_t count,
                                        const char* what) {
  const auto all = array(starts, product(count, 1, what) + 1, what);
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
  const auto all = array(domain.corners, product(corners.back(), 1, "corners"), "corners");
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
  const bool is_flat = complex.points.dimension() < static_cast<int>(complex.ambient_dimension());
  if (asked == CIRCUMSPECT_HULL) {
    if (is_flat) refuse_input("expected points that do not all lie in one hyperplane for a hull");
    return DomainKind::kHull;
  }
  if (asked != CIRCUMSPECT_KIND_BY_WALLS || Regions(complex).size() > 1 || is_flat) {
    return DomainKind::kEnclosed;
  }
  if (walls(complex).empty()) return DomainKind::kHull;
  refuse_input(
      "expected walls that enclose something, found some that enclose nothing: close the gap, or "
      "say of which kind the domain is, enclosed or hull");
}

// A point in each region that is enclosed and not filled.
std::vector<Point> seeds_of_empty(const circumspect_domain& domain,
                                  const PiecewiseLinearInput& input,
                                  const PiecewiseLinearComplex& complex) {
  const std::vector<Point> named = exact_points(domain.region_count, domain.dimension,
                                                domain.region_seeds, domain.exact_region_seeds);
  const bool is_by_rule = domain.kind == CIRCUMSPECT_EVEN_ODD || domain.kind == CIRCUMSPECT_WINDING;
  if (named.empty() && !is_by_rule) return {};
  if (!named.empty() && (is_by_rule || domain.kind == CIRCUMSPECT_HULL)) {
    refuse_call("expected regions of what is enclosed, found them beside another kind");
  }
  const Regions regions(complex, complex.hole_seeds, DomainKind::kEnclosed);
  if (!named.empty()) {
    auto seeds = seeds_of_unnamed(named, regions);
    if (seeds) return *std::move(seeds);
    refuse_input(fmt::format(
        "expected the point of region {} in something enclosed, found it {}", seeds.error(),
        regions.region_at(named[seeds.error()]) ? "in nothing enclosed" : "on a wall"));
  }
  const Fill fill = domain.kind == CIRCUMSPECT_WINDING ? Fill::kWinding : Fill::kEvenOdd;
  auto seeds = seeds_of_unfilled(fill, input, complex, regions);
  if (seeds) return *std::move(seeds);
  refuse_input(fmt::format(
      "expected walls that are listed all turned one way around what they enclose, found wall {} "
      "turned against others: winding needs to know which side of each is which; even-odd does not",
      report::joined(regions.walls().simplices()[seeds.error()])));
}

// Polygons are named by their places, joined ones by the place of the first.
Domain with_names(PiecewiseLinearComplex complex,
                  const std::vector<std::vector<std::size_t>>& members) {
  Domain domain{std::move(complex)};
  for (const std::vector<std::size_t>& some : members) {
    domain.polygon_names.push_back(std::to_string(some.front()));
    if (some.size() > 1) domain.polygon_names.back() += fmt::format(", joined of {}", some.size());
  }
  return domain;
}

}  // namespace

Domain domain_of(const circumspect_domain& given) {
  const circumspect_domain domain =
      of_any_version<circumspect_domain>(given, CIRCUMSPECT_DOMAIN,
                                         {offsetof(circumspect_domain, polygon_hole_count),
                                          offsetof(circumspect_domain, region_count)},
                                         "CIRCUMSPECT_DOMAIN");
  require_dimension(domain.dimension, 2, 3);
  require_count(domain.point_count, "points");
  require_count(domain.segment_count, "segments");
  require_count(domain.hole_count, "hole seeds");
  require_count(domain.region_count, "regions");
  if (domain.kind < CIRCUMSPECT_KIND_BY_WALLS || domain.kind > CIRCUMSPECT_WINDING) {
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
  const std::vector<Point> empty = seeds_of_empty(domain, input, *complex);
  complex->kind = input.kind =
      domain.region_count > 0 ? DomainKind::kEnclosed : kind_of(*complex, domain.kind);
  for (std::vector<Point>* const seeds : {&complex->hole_seeds, &input.hole_seeds}) {
    seeds->insert(seeds->end(), empty.begin(), empty.end());
  }
  if (domain.merge_coplanar != 0 && domain.dimension == 3) {
    JoinedPolygons joined = coplanar_polygons_joined(input, *complex);
    return with_names(std::move(joined.complex), joined.members);
  }
  std::vector<std::vector<std::size_t>> alone;
  for (std::size_t p = 0; p < complex->polygons.size(); ++p) alone.push_back({p});
  return with_names(std::move(*complex), alone);
}

}  // namespace circumspect::c
