// Meshes of domains that are wrong. Book: Definitions 4.3 to 4.7.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "inputs/cases.hpp"
#include "inputs/in_doubles.hpp"
#include "kernel/complex/simplex.hpp"
#include "kernel/piecewise_linear/regions.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "kernel/predicates/orientation.hpp"
#include "kernel/predicates/place.hpp"
#include "properties/faulty/fault.hpp"
#include "reference/constrained/conforming_delaunay.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/constrained/steiner_cdt.hpp"
#include "reference/delaunay/flip.hpp"

namespace circumspect::faulty {
namespace {

using Input = PiecewiseLinearInput;
using Result = std::optional<ExactMesh>;

Result without_dangling_faces(const Input& input) {
  Result mesh = cdt_of(input);
  if (mesh) mesh->faces.clear();
  return mesh;
}

Result with_steiner_points(const Input& input) { return steiner_mesh(assemble(input)).mesh; }

bool are_collinear(const Point& a, const Point& b, const Point& c) {
  return affine_hull({a, b, c}).dimension < 2;
}

// The first Steiner point as near as doubles allow, but not on its segment.
Result with_a_steiner_point_off(const Input& input) {
  const PiecewiseLinearComplex complex = assemble(input);
  SteinerMesh steiner = steiner_mesh(complex);
  if (steiner.steiner_points.empty()) return std::nullopt;
  std::vector<Point> points = steiner.mesh.points.points();
  const auto& [vertex, segment, parameter] = steiner.steiner_points.front();
  Point& moved = points[static_cast<std::size_t>(vertex)];
  for (Rational& x : moved) x = exact_value(generators::nearest_double(x));
  const Simplex& ends = complex.segments[segment];
  const Point& a = complex.points[ends[0]];
  const Point& b = complex.points[ends[1]];
  for (Rational& x : moved) {
    if (!are_collinear(a, b, moved)) break;
    x = exact_value(
        std::nextafter(generators::nearest_double(x), std::numeric_limits<double>::infinity()));
  }
  if (!duplicates(points).empty()) return std::nullopt;
  steiner.mesh.points = PointSet(points);
  return steiner.mesh;
}

// A midpoint of a segment that only one of the simplices around it has for a vertex.
Result with_a_hanging_node(const Input& input) {
  const PiecewiseLinearComplex complex = assemble(input);
  Result mesh = cdt_mesh(complex);
  if (!mesh) return std::nullopt;
  for (Simplex& simplex : mesh->simplices) {
    for (const Simplex& ends : complex.segments) {
      if (!contains(simplex, ends[0]) || !contains(simplex, ends[1])) continue;
      std::vector<Point> points = complex.points.points();
      const auto middle = static_cast<Vertex>(points.size());
      points.push_back(barycentre(complex.points, ends));
      Simplex other = simplex;
      std::replace(simplex.begin(), simplex.end(), ends[0], middle);
      std::replace(other.begin(), other.end(), ends[1], middle);
      mesh->simplices.push_back(other);
      mesh->points = PointSet(points);
      return mesh;
    }
  }
  return std::nullopt;
}

// Two triangles of a polygon and the apex of a tetrahedron on each: the other diagonal on that side
// alone.
Result with_a_polygon_tiled_twice(const Input& input) {
  const PiecewiseLinearComplex complex = assemble(input);
  Result mesh = cdt_mesh(complex);
  if (!mesh) return std::nullopt;
  const PointSet& points = complex.points;
  const Regions regions(complex);
  const StarIndex star(mesh->simplices);
  const auto is_inner_wall = [&](const Simplex& facet) {
    return star.star(facet).size() == 2 &&
           regions.locate(barycentre(points, facet)) == Where::kOnWall;
  };
  for (Simplex& one : mesh->simplices) {
    for (Simplex& two : mesh->simplices) {
      std::vector<Vertex> shared, rest;
      for (const Vertex v : one) (contains(two, v) ? shared : rest).push_back(v);
      if (shared.size() != 3) continue;
      rest.push_back(
          *std::find_if(two.begin(), two.end(), [&](Vertex v) { return !contains(shared, v); }));
      for (std::size_t apex = 0; apex < 3; ++apex) {
        const Simplex edge = facet_opposite(shared, apex);
        const Simplex flat = {edge[0], edge[1], rest[0], rest[1]};
        if (axes_of(points.configuration(), flat).size() != 2 ||
            !is_inner_wall({edge[0], edge[1], rest[0]}) ||
            !is_inner_wall({edge[0], edge[1], rest[1]})) {
          continue;
        }
        const Simplex here = {shared[apex], rest[0], rest[1], edge[0]};
        const Simplex there = {shared[apex], rest[0], rest[1], edge[1]};
        if (orientation(points.configuration(), here) *
                orientation(points.configuration(), there) >=
            0) {
          continue;  // the four corners are not convex
        }
        one = here;
        two = there;
        return mesh;
      }
    }
  }
  return std::nullopt;
}

// The first facet off the walls that two simplices can be flipped across.
Result with_a_flip_too_many(const Input& input) {
  const PiecewiseLinearComplex complex = assemble(input);
  Result mesh = cdt_mesh(complex);
  if (!mesh) return std::nullopt;
  const Regions regions(complex);
  StarIndex star(mesh->simplices);
  for (const Simplex& facet : facets_of(mesh->simplices)) {
    if (star.star(facet).size() < 2 ||
        regions.locate(barycentre(complex.points, facet)) == Where::kOnWall) {
      continue;
    }
    const auto flip =
        delaunay::extended_flip(star, delaunay::flip_of_facet(complex.points, star, facet));
    if (!flip || (flip->name() != "2-2" && flip->name() != "2-3")) continue;
    if (flip->name() == "2-2" && complex.ambient_dimension() == 3) continue;
    star.replace(flip->deleted, flip->created);
    mesh->simplices.assign(star.simplices().begin(), star.simplices().end());
    return mesh;
  }
  return std::nullopt;
}

// Each seed of a hole takes away the simplex around it, and the search goes no further.
Result with_holes_of_one_simplex(const Input& input) {
  if (input.hole_seeds.empty() || input.kind == DomainKind::kHull) return std::nullopt;
  Input filled = input;
  filled.hole_seeds.clear();
  Result mesh = cdt_of(filled);
  if (!mesh) return std::nullopt;
  for (const Point& seed : input.hole_seeds) {
    std::vector<Point> points = mesh->points.points();
    points.push_back(seed);
    if (!duplicates(points).empty()) continue;
    const PointSet with_seed(points);
    std::erase_if(mesh->simplices, [&](const Simplex& simplex) {
      return lies_inside(with_seed.configuration(), simplex,
                         static_cast<Vertex>(points.size()) - 1);
    });
  }
  return mesh;
}

// The first vertex of no cell is inserted last, into the simplex around it, and nothing is flipped.
Result with_a_vertex_split_in(const Input& input) {
  const std::vector<bool> used = generators::is_used(input);
  const auto lone = std::find(used.begin(), used.end(), false);
  if (lone == used.end()) return std::nullopt;
  const Vertex vertex = lone - used.begin();
  std::vector<bool> dropped(used.size());
  dropped[static_cast<std::size_t>(vertex)] = true;
  Input rest = input;
  generators::drop_points(rest, dropped);
  if (rest.points.empty()) return std::nullopt;
  Result mesh = cdt_of(rest);
  if (!mesh) return std::nullopt;
  mesh->points = PointSet(input.points);
  for (auto* simplices : {&mesh->simplices, &mesh->faces}) {
    for (Simplex& simplex : *simplices) {
      for (Vertex& v : simplex) v += v >= vertex ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < mesh->simplices.size(); ++i) {
    const Simplex around = mesh->simplices[i];
    if (!lies_inside(mesh->points.configuration(), around, vertex)) continue;
    mesh->simplices.erase(mesh->simplices.begin() + static_cast<std::ptrdiff_t>(i));
    for (std::size_t place = 0; place < around.size(); ++place) {
      mesh->simplices.push_back(with_vertex_replaced(around, place, vertex));
    }
    return mesh;
  }
  return std::nullopt;
}

// The walls of the mesh as faces of their own, with some of the regions between them left empty.
using Keeps = bool (*)(std::optional<std::size_t> region, std::optional<std::size_t> first);
Result of_some_regions(const Input& input, Keeps keeps) {
  const PiecewiseLinearComplex complex = assemble(input);
  Result mesh = cdt_mesh(complex);
  if (!mesh || mesh->simplices.empty()) return std::nullopt;
  const Regions regions(complex);
  const auto region = [&](const Simplex& simplex) {
    return regions.region_at(barycentre(complex.points, simplex));
  };
  for (const Simplex& facet : facets_of(mesh->simplices)) {
    if (!region(facet)) mesh->faces.push_back(facet);
  }
  const auto first = region(mesh->simplices.front());
  std::erase_if(mesh->simplices, [&](const Simplex& one) { return !keeps(region(one), first); });
  return mesh;
}

Result of_the_first_region(const Input& input) {
  return of_some_regions(input, [](auto region, auto first) { return region == first; });
}

Result through_a_leak(const Input& input) {
  if (input.kind == DomainKind::kHull) return std::nullopt;
  return of_some_regions(input, [](auto region, auto first) { return region != first; });
}

}  // namespace

std::vector<Fault> domain_faults() {
  return {
      domain_fault(
          "dangling-faces-not-written",
          "Segments and triangles that are faces of no simplex of the mesh are not written.",
          Claim::kCdt, without_dangling_faces),
      domain_fault("first-region-only",
                   "Only the region around the first simplex is kept, though there are "
                   "more beyond inner walls.",
                   Claim::kCdt, of_the_first_region),
      domain_fault("leak",
                   "The carving of the outside floods through a wall that it does not recognise, "
                   "and empties the region behind it.",
                   Claim::kCdt, through_a_leak),
      domain_fault(
          "steiner-points-in-a-cdt",
          "Segments are split, though the claim is a triangulation without further vertices.",
          Claim::kCdt, with_steiner_points),
      domain_fault(
          "conforming-claimed",
          "A constrained Delaunay triangulation, said to be conforming Delaunay: the two are often "
          "confused in manuals.",
          Claim::kConformingDelaunay, cdt_of),
      domain_fault(
          "steiner-point-one-ulp-off",
          "A Steiner point is rounded, and then off its segment by a unit in the last place.",
          Claim::kSteinerCdt, with_a_steiner_point_off),
      domain_fault(
          "hanging-node",
          "A segment is split in one of the simplices around it and not in the others: subdomains "
          "refined apart.",
          Claim::kSteinerCdt, with_a_hanging_node),
      domain_fault("hole-of-one-simplex",
                   "A seed of a hole takes away the simplex around it, and no neighbours of that.",
                   Claim::kCdt, with_holes_of_one_simplex),
      domain_fault("polygon-tiled-twice",
                   "The triangles of a polygon are not the same on both of its sides.", Claim::kCdt,
                   with_a_polygon_tiled_twice, {3}),
      domain_fault("not-locally-delaunay",
                   "All constraints are there, but a facet off the walls is not locally Delaunay: "
                   "flips that "
                   "recovered a segment were not followed by flips that restore.",
                   Claim::kCdt, with_a_flip_too_many),
      domain_fault(
          "vertex-only-split-in",
          "A vertex is inserted into the simplex around it, and nothing around is flipped: visible "
          "vertices are in balls.",
          Claim::kCdt, with_a_vertex_split_in),
  };
}

namespace {

ExactMesh mesh_of(const PointSet& points, const constrained::PlcTriangulation& triangulation) {
  ExactMesh mesh{points, triangulation.simplices};
  for (const Simplex& simplex : triangulation.dangling) {
    if (simplex.size() > 1) mesh.faces.push_back(simplex);
  }
  return mesh;
}

}  // namespace

std::optional<ExactMesh> cdt_mesh(const PiecewiseLinearComplex& complex) {
  if (complex.ambient_dimension() == 2) {
    return mesh_of(complex.points, constrained::planar_cdt(complex));
  }
  const auto cdt = constrained::gift_wrapping_cdt(complex);
  if (!cdt) return std::nullopt;
  return mesh_of(complex.points, *cdt);
}

std::optional<ExactMesh> cdt_of(const PiecewiseLinearInput& input) {
  const auto complex = validated(input, 1);
  return complex ? cdt_mesh(*complex) : std::nullopt;
}

SteinerMesh steiner_mesh(const PiecewiseLinearComplex& complex) {
  constrained::RecoveredSegments recovered = constrained::recover_segments(complex);
  const constrained::PlcTriangulation cdt = constrained::cdt_of_edge_protected(recovered.complex);
  return {mesh_of(recovered.complex.points, cdt), std::move(recovered.steiner_points)};
}

std::optional<ExactMesh> conforming_mesh(const PiecewiseLinearComplex& complex,
                                         std::size_t most_steiner_points) {
  const auto conforming = constrained::conforming_delaunay(complex, most_steiner_points);
  if (!conforming) return std::nullopt;
  return mesh_of(conforming->complex.points, conforming->triangulation);
}

}  // namespace circumspect::faulty
