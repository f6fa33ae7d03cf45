// Programs that fill a domain other than the one that they were given: they do not read, or do not
// recover, some of it. Book: Section 4.5.1.
#include <algorithm>
#include <utility>

#include "inputs/cases.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/complex/star_index.hpp"
#include "kernel/predicates/orientation.hpp"
#include "properties/faulty/fault.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::faulty {
namespace {

using Input = PiecewiseLinearInput;
using Result = std::optional<ExactMesh>;

Result without_constraints(const Input& input) {
  const PointSet points(input.points);
  if (input.kind != DomainKind::kHull ||
      points.dimension() < static_cast<int>(points.ambient_dimension())) {
    return std::nullopt;
  }
  return ExactMesh{points, delaunay::bowyer_watson(points).simplices()};
}

Result without_polygons(Input input) {
  if (input.kind != DomainKind::kHull || input.polygons.empty()) return std::nullopt;
  for (const Simplex& segment : assemble(input).segments) input.segments.push_back(segment);
  input.polygons.clear();
  return cdt_of(input);
}

// What a program does that does not recover some of the segments.
template <typename Forgets>
Result without_segments(Input input, const Forgets& forgets) {
  if (input.kind != DomainKind::kHull || std::erase_if(input.segments, forgets) == 0) {
    return std::nullopt;
  }
  return cdt_of(input);
}

Result without_the_last_segment(const Input& input) {
  if (input.segments.empty()) return std::nullopt;
  return without_segments(
      input, [last = input.segments.back()](const Simplex& segment) { return segment == last; });
}

// The table has a segment from its lower index; the search comes along an edge from its lower end.
Result looked_up_one_way(const Input& input) {
  return without_segments(input, [&input](const Simplex& segment) {
    const auto [low, high] = std::minmax(segment[0], segment[1]);
    return input.points[static_cast<std::size_t>(low)] >
           input.points[static_cast<std::size_t>(high)];
  });
}

// How many edges of the triangulation cross the segment in their interiors.
std::size_t crossings(const PointSet& points, const std::vector<Simplex>& triangles,
                      const Simplex& segment) {
  const auto side = [&points](Vertex a, Vertex b, Vertex c) {
    return orientation(points.configuration(), Simplex{a, b, c});
  };
  std::size_t count = 0;
  for (const Simplex& edge : facets_of(triangles)) {
    if (contains(segment, edge[0]) || contains(segment, edge[1])) continue;
    if (side(segment[0], segment[1], edge[0]) * side(segment[0], segment[1], edge[1]) < 0 &&
        side(edge[0], edge[1], segment[0]) * side(edge[0], edge[1], segment[1]) < 0) {
      ++count;
    }
  }
  return count;
}

Result recovered_by_one_flip(const Input& input) {
  const PointSet points(input.points);
  if (points.dimension() < 2) return std::nullopt;
  const std::vector<Simplex> triangles = delaunay::bowyer_watson(points).simplices();
  return without_segments(
      input, [&](const Simplex& segment) { return crossings(points, triangles, segment) > 1; });
}

Result with_holes_filled(Input input) {
  if (input.hole_seeds.empty() || input.kind == DomainKind::kHull) return std::nullopt;
  input.hole_seeds.clear();
  return cdt_of(input);
}

Result with_the_outside(Input input) {
  if (input.kind == DomainKind::kHull) return std::nullopt;
  input.kind = DomainKind::kHull;
  return cdt_of(input);
}

Result without_lone_vertices(const Input& input) {
  const std::vector<bool> used = generators::is_used(input);
  std::vector<bool> dropped(used.size());
  std::transform(used.begin(), used.end(), dropped.begin(), [](bool is_used) { return !is_used; });
  Input rest = input;
  generators::drop_points(rest, dropped);
  if (rest.points.empty()) return std::nullopt;
  return cdt_of(rest);
}

}  // namespace

std::vector<Fault> constraint_faults() {
  return {
      domain_fault(
          "constraints-ignored",
          "The Delaunay triangulation of the vertices, as if there were no segments and polygons.",
          Claim::kCdt, without_constraints),
      domain_fault("polygons-ignored",
                   "Segments are recovered, the polygons between them are taken for granted.",
                   Claim::kCdt, without_polygons, {3}),
      domain_fault("hole-filled", "Hole seeds are not read.", Claim::kCdt, with_holes_filled),
      domain_fault("last-segment-forgotten", "A loop over the segments ends one too early.",
                   Claim::kCdt, without_the_last_segment),
      domain_fault(
          "segment-looked-up-one-way",
          "Segments are in a table from their lower index to the higher; edges are looked up from "
          "left to right, so that half of the segments are flipped away.",
          Claim::kCdt, looked_up_one_way, {2}),
      domain_fault(
          "recovered-by-one-flip",
          "A segment that crosses more than one edge is given up: the flip that recovers it is not "
          "repeated.",
          Claim::kCdt, recovered_by_one_flip, {2}),
      domain_fault(
          "outside-kept",
          "The convex hull is filled where the domain is what the walls enclose: no carving.",
          Claim::kCdt, with_the_outside),
      domain_fault("lone-vertices-forgotten",
                   "Vertices that are in no segment and polygon are not inserted.", Claim::kCdt,
                   without_lone_vertices),
  };
}

}  // namespace circumspect::faulty
