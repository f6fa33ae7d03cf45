#include "inputs/complex_families.hpp"

#include "inputs/complexes.hpp"
#include "inputs/modifiers.hpp"
#include "inputs/named_complexes.hpp"
#include "inputs/set_parts.hpp"

namespace circumspect::generators {
namespace {

std::vector<Point> grid_vertices(Dice& dice, std::size_t dimension, std::size_t max_points) {
  return rather_large(dimension, [&] { return grid_points(dice, dimension, {max_points}); });
}

// Not all of them are tetrahedralizable, or edge-protected.
ComplexCase named_complex(Dice& dice) {
  switch (dice.below(9)) {
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
}

std::vector<ComplexFamily> table() {
  return {
      {"scattered-cells",
       "triangles, quadrilaterals, segments: dangling, open, mostly not edge-protected (Book: "
       "Section 4.5.3)",
       3,
       [](Dice& dice, std::size_t max_points) {
         return scattered_cells(dice, integer_vertices(dice, 3, max_points));
       }},
      {"coplanar-cells", "the same on a grid: many polygons share a plane (Book: Definition 4.3)",
       3,
       [](Dice& dice, std::size_t max_points) {
         return scattered_cells(dice, grid_vertices(dice, 3, max_points));
       }},
      {"glued-tetrahedra",
       "polyhedra that have a triangulation, but perhaps no CDT (Book: Section 4.5.2)", 3,
       [](Dice& dice, std::size_t max_points) {
         return glued_tetrahedra(dice, integer_vertices(dice, 3, max_points));
       }},
      {"furnished-boxes",
       "cubes with holes, slits, cavities and dangling polygons (Book: Definition 4.3)", 3,
       [](Dice& dice, std::size_t) { return furnished_box(dice); }},
      {"twisted-prisms", "Schoenhardt's polyhedron and its kin (Book: Figure 4.10)", 3,
       [](Dice& dice, std::size_t) { return twisted_prism(dice); }},
      {"named-complexes",
       "Schoenhardt's, Chazelle's and other counterexamples (Book: Figures 4.10 to 4.15)", 3,
       [](Dice& dice, std::size_t) { return named_complex(dice); }},
      {"planar-segments",
       "segments in the plane that do not cross, holes (Book: Sections 2.10 and 3.10)", 2,
       [](Dice& dice, std::size_t max_points) {
         return planar_complex(dice, integer_vertices(dice, 2, max_points));
       }},
      {"planar-grid", "the same on a grid: collinear segments (Book: Sections 2.10 and 3.10)", 2,
       [](Dice& dice, std::size_t max_points) {
         return planar_complex(dice, grid_vertices(dice, 2, max_points));
       }},
  };
}

}  // namespace

std::vector<Point> integer_vertices(Dice& dice, std::size_t dimension, std::size_t max_points) {
  return rather_large(dimension, [&] {
    return one_of({integer_points, grid_points, integer_sphere_points}, dice, dimension,
                  {max_points});
  });
}

const std::vector<ComplexFamily>& complex_families() {
  static const std::vector<ComplexFamily> all = table();
  return all;
}

const std::vector<ComplexModifier>& complex_modifiers() {
  static const std::vector<ComplexModifier> all = {
      {"ulp", "about half of the vertices moved by one ulp, where the domain remains one",
       complex_one_ulp_away},
      {"moved", "moved by 2^20 to 2^50 times its size, then rounded to doubles",
       complex_far_from_origin},
      {"rotated", "turned, and rounded to doubles or made larger by an integer", complex_rotated},
  };
  return all;
}

ComplexFamily modified(ComplexFamily family, const ComplexModifier& modifier) {
  family.name += "+" + modifier.name;
  family.about += "; " + modifier.about;
  family.draw = [draw = family.draw, name = family.name, modified = modifier.modified](
                    Dice& dice, std::size_t max_points) {
    ComplexCase whole = modified(dice, draw(dice, max_points));
    whole.family = name;
    return whole;
  };
  return family;
}

ComplexCase drawn(const ComplexFamily& family, std::size_t max_points, std::uint64_t seed) {
  Dice dice(mixed(seed));
  return family.draw(dice, max_points);
}

}  // namespace circumspect::generators
