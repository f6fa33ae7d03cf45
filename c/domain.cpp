// Makes a valid domain of the struct of <circumspect/circumspect.h>, and determines which part of
// it is filled.
#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
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
#include "oracle/domain/resolved.hpp"
#include "oracle/domain/uncovered.hpp"
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
  if (domain.dimension == 2 && domain.polygon_hole_count > 0) {
    refuse_call(
        "expected no hole seeds in polygons of the plane, whose rings bound the holes, found some");
  }
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

// In the plane polygons are not cells of the complex: their edges are.
std::vector<PolygonLines> taken_for_rings(PiecewiseLinearInput& input) {
  for (const PolygonLines& polygon : input.polygons) {
    for (const std::vector<Vertex>& ring : polygon.lines) {
      if (ring.size() < 3) {
        refuse_call(fmt::format(
            "expected rings of at least 3 corners in the plane, found one of {}", ring.size()));
      }
      for (std::size_t i = 0; i < ring.size(); ++i) {
        input.segments.push_back({ring[i], ring[(i + 1) % ring.size()]});
      }
    }
  }
  return std::exchange(input.polygons, {});
}

// Each vertex, by its own index.
std::vector<Vertex> own_indices(const PiecewiseLinearInput& input) {
  std::vector<Vertex> indices(input.points.size());
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

void require_known_corners(const PiecewiseLinearInput& input) {
  const auto require = [&](const std::vector<Vertex>& line) {
    for (const Vertex v : line) {
      if (v >= 0 && static_cast<std::size_t>(v) < input.points.size()) continue;
      refuse_input(
          fmt::format("expected corners among {} points, found {}", input.points.size(), v));
    }
  };
  std::for_each(input.segments.begin(), input.segments.end(), require);
  for (const PolygonLines& polygon : input.polygons) {
    std::for_each(polygon.lines.begin(), polygon.lines.end(), require);
  }
}

// Equal points become the first of them, and cells that vanish are left out.
std::vector<Vertex> merge_equal_points(PiecewiseLinearInput& input) {
  std::map<Point, Vertex> place_of;
  std::vector<Vertex> place;
  std::vector<Vertex> labels;
  for (const Point& point : input.points) {
    const auto next = static_cast<Vertex>(place_of.size());
    const auto [known, is_new] = place_of.try_emplace(point, next);
    if (is_new) labels.push_back(static_cast<Vertex>(place.size()));
    place.push_back(known->second);
  }
  std::vector<Point> points(place_of.size());
  for (const auto& [point, at] : place_of) points[static_cast<std::size_t>(at)] = point;
  input.points = std::move(points);
  const auto renumber = [&place](std::vector<Vertex>& line) {
    for (Vertex& v : line) v = place[static_cast<std::size_t>(v)];
    line.erase(std::unique(line.begin(), line.end()), line.end());
    while (line.size() > 1 && line.front() == line.back()) line.pop_back();
  };
  std::for_each(input.segments.begin(), input.segments.end(), renumber);
  std::erase_if(input.segments, [](const Simplex& segment) { return segment.size() < 2; });
  for (PolygonLines& polygon : input.polygons) {
    std::for_each(polygon.lines.begin(), polygon.lines.end(), renumber);
  }
  return labels;
}

std::string breach_text(const std::vector<Breach>& breaches, const std::vector<Vertex>& labels) {
  const auto named = [&labels](std::vector<Vertex> vertices) {
    for (Vertex& v : vertices) v = labels.empty() ? v : labels[static_cast<std::size_t>(v)];
    return vertices;
  };
  const Breach& first = breaches.front();
  std::string text = fmt::format("expected a piecewise linear complex, found {}: {}",
                                 identifier(first.kind), meaning(first.kind));
  for (const std::size_t polygon : first.polygons) text += fmt::format(", polygon {}", polygon);
  for (const Simplex& segment : first.segments) {
    text += fmt::format(", segment {}", fmt::join(named(segment), " "));
  }
  if (!first.vertices.empty())
    text += fmt::format(", vertices {}", fmt::join(named(first.vertices), " "));
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
      "say which kind of domain it is, enclosed or hull");
}

// A point in each region that is enclosed and not filled.
std::vector<Point> seeds_of_empty(const circumspect_domain& domain,
                                  const PiecewiseLinearInput& input,
                                  const std::vector<PolygonLines>& rings,
                                  const PiecewiseLinearComplex& complex) {
  const std::vector<Point> named = exact_points(domain.region_count, domain.dimension,
                                                domain.region_seeds, domain.exact_region_seeds);
  const bool is_by_rule = domain.kind == CIRCUMSPECT_EVEN_ODD || domain.kind == CIRCUMSPECT_WINDING;
  const bool is_by_rings = domain.kind == CIRCUMSPECT_KIND_BY_WALLS && !rings.empty();
  if (named.empty() && !is_by_rule && !is_by_rings) return {};
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
  if (is_by_rings) return points_without_rings(rings, regions);
  const Fill fill = domain.kind == CIRCUMSPECT_WINDING ? Fill::kWinding : Fill::kEvenOdd;
  auto seeds = seeds_of_unfilled(fill, input, complex, regions);
  if (seeds) return *std::move(seeds);
  refuse_input(fmt::format(
      "expected walls that are listed all turned one way around what they enclose, found wall {} "
      "turned against others: winding needs to know which side of each is which; even-odd does not",
      report::joined(regions.walls().simplices()[seeds.error()])));
}

// Without the settings, which say what is filled.
PiecewiseLinearInput input_of(const circumspect_domain& domain) {
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
  return input;
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

Domain with_polygons_joined(const PiecewiseLinearInput& input, PiecewiseLinearComplex complex,
                            bool are_merged) {
  if (are_merged) {
    JoinedPolygons joined = coplanar_polygons_joined(input, complex);
    return with_names(std::move(joined.complex), joined.members);
  }
  std::vector<std::vector<std::size_t>> alone;
  for (std::size_t p = 0; p < complex.polygons.size(); ++p) alone.push_back({p});
  return with_names(std::move(complex), alone);
}

}  // namespace

Domain domain_of(const circumspect_domain& given, bool merges) {
  const circumspect_domain domain = of_any_version<circumspect_domain>(
      given, CIRCUMSPECT_DOMAIN,
      {offsetof(circumspect_domain, polygon_hole_count), offsetof(circumspect_domain, region_count),
       offsetof(circumspect_domain, resolve)},
      "CIRCUMSPECT_DOMAIN");
  PiecewiseLinearInput input = input_of(domain);
  std::vector<Vertex> labels;
  if (domain.resolve != 0 || merges) require_known_corners(input);
  const bool is_planar = domain.dimension == 2;
  if (merges && domain.resolve == 0) labels = merge_equal_points(input);
  std::vector<PolygonLines> rings;
  if (is_planar) rings = taken_for_rings(input);
  if (domain.resolve != 0) {
    if (is_planar) input.polygons = std::move(rings);
    ResolvedInput whole = resolved(input, own_indices(input));
    input = std::move(whole.input);
    labels = std::move(whole.labels);
    if (is_planar) rings = std::exchange(input.polygons, {});
  }
  auto complex = check::validated_domain(input);
  if (!complex) refuse_input(breach_text(complex.error(), labels));
  const std::vector<Point> empty = seeds_of_empty(domain, input, rings, *complex);
  complex->kind = input.kind =
      domain.region_count > 0 ? DomainKind::kEnclosed : kind_of(*complex, domain.kind);
  for (std::vector<Point>* const seeds : {&complex->hole_seeds, &input.hole_seeds}) {
    seeds->insert(seeds->end(), empty.begin(), empty.end());
  }
  Domain filled =
      with_polygons_joined(input, std::move(*complex), domain.merge_coplanar != 0 && !is_planar);
  filled.labels = std::move(labels);
  return filled;
}

}  // namespace circumspect::c
