#include "inputs/complex_families.hpp"

#include "inputs/complexes.hpp"
#include "inputs/named_complexes.hpp"
#include "inputs/point_sets.hpp"
#include "inputs/scalars.hpp"

namespace circumspect::generators {
namespace {

PointSets grid_vertices(std::size_t dimension, std::size_t max_points) {
  return rather_large(grid_points(dimension, max_points), dimension);
}

// Not all of them are tetrahedralizable, or edge-protected.
Complexes named_complexes() {
  return shrinking(rc::gen::map(below(9), [](long code) -> ComplexCase {
    switch (code) {
      case 0:
        return {"Schönhardt's polyhedron", schonhardt()};
      case 1:
        return {"prism on a sphere", prism_on_a_sphere(false)};
      case 2:
        return {"prism on a sphere, with a floor", prism_on_a_sphere(true)};
      case 3:
        return {"cube with three segments", cube_with_three_segments()};
      case 4:
        return {"cube with two segments", cube_with_three_segments(0)};
      case 5:
        return {"encircled segment", encircled_segment()};
      case 6:
        return {"Chazelle's polyhedron, one notch", chazelle(1)};
      case 7:
        return {"Chazelle's polyhedron, two notches", chazelle(2)};
      default:
        return {"cavity", both(box(0, 6), box(2, 4))};
    }
  }));
}

std::vector<ComplexFamily> table() {
  return {
      {"scattered-cells",
       "triangles, quadrilaterals, segments: dangling, open, mostly not edge-protected (Book: "
       "Section 4.5.3)",
       3, [](std::size_t max_points) { return scattered_cells(integer_vertices(3, max_points)); }},
      {"coplanar-cells", "the same on a grid: many polygons share a plane (Book: Definition 4.3)",
       3, [](std::size_t max_points) { return scattered_cells(grid_vertices(3, max_points)); }},
      {"glued-tetrahedra",
       "polyhedra that have a triangulation, but perhaps no CDT (Book: Section 4.5.2)", 3,
       [](std::size_t max_points) { return glued_tetrahedra(integer_vertices(3, max_points)); }},
      {"furnished-boxes",
       "cubes with holes, slits, cavities and dangling polygons (Book: Definition 4.3)", 3,
       [](std::size_t) { return furnished_boxes(); }},
      {"twisted-prisms", "Schoenhardt's polyhedron and its kin (Book: Figure 4.10)", 3,
       [](std::size_t) { return twisted_prisms(); }},
      {"named-complexes",
       "Schoenhardt's, Chazelle's and other counterexamples (Book: Figures 4.10 to 4.15)", 3,
       [](std::size_t) { return named_complexes(); }},
      {"planar-segments",
       "segments in the plane that do not cross, holes (Book: Sections 2.10 and 3.10)", 2,
       [](std::size_t max_points) { return planar_complexes(integer_vertices(2, max_points)); }},
      {"planar-grid", "the same on a grid: collinear segments (Book: Sections 2.10 and 3.10)", 2,
       [](std::size_t max_points) { return planar_complexes(grid_vertices(2, max_points)); }},
  };
}

}  // namespace

PointSets integer_vertices(std::size_t dimension, std::size_t max_points) {
  return rather_large(
      rc::gen::oneOf(integer_points(dimension, max_points), grid_points(dimension, max_points),
                     integer_sphere_points(dimension, max_points)),
      dimension);
}

const std::vector<ComplexFamily>& complex_families() {
  static const std::vector<ComplexFamily> all = table();
  return all;
}

ComplexCase drawn(const Complexes& complexes, std::uint64_t seed) {
  return complexes(rc::Random(seed), rc::kNominalSize).value();
}

}  // namespace circumspect::generators
