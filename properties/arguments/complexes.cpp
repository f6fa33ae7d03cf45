#include "properties/arguments/complexes.hpp"

#include <utility>

#include "inputs/triangulated/protected_complexes.hpp"

namespace circumspect::generators {

Complexes any_complex(std::size_t max_points) {
  return generated([max_points](Dice& dice) {
    std::vector<Point> points = rather_large(3, [&] {
      return one_of(
          {integer_points, grid_points, integer_points, any_points, integer_sphere_points}, dice, 3,
          {max_points});
    });
    switch (dice.below(4)) {
      case 0:
        return scattered_cells(dice, std::move(points));
      case 1:
        return glued_tetrahedra(dice, std::move(points));
      case 2:
        return furnished_box(dice);
      default:
        return twisted_prism(dice);
    }
  });
}

Complexes planar_complexes(std::size_t max_points) {
  return generated([max_points](Dice& dice) {
    std::vector<Point> points = rather_large(2, [&] {
      return one_of({integer_points, grid_points, any_points}, dice, 2, {max_points});
    });
    return planar_complex(dice, std::move(points));
  });
}

Complexes flat_cells(std::size_t max_points) {
  return generated([max_points](Dice& dice) {
    return scattered_cells(
        dice, rather_large(3, [&] {
          return one_of({plane_points, grid_points, cube_points}, dice, 3, {max_points});
        }));
  });
}

}  // namespace circumspect::generators

namespace circumspect::properties {

generators::Complexes any_protected_complex(std::size_t max_points) {
  using namespace generators;
  return generated([max_points](Dice& dice) {
    std::vector<Point> points = rather_large(3, [&] {
      return one_of({integer_points, grid_points, cube_points, moment_curve_points,
                     integer_sphere_points, skew_line_points, any_points},
                    dice, 3, {max_points});
    });
    switch (dice.below(4)) {
      case 0:
        return protected_polygons(dice, std::move(points));
      case 1:
        return protected_solid(dice, std::move(points));
      case 2:
        return protected_polygons(dice, std::move(points), Protection::kStrong);
      default:
        return delaunay_polyhedron(dice, std::move(points));
    }
  });
}

}  // namespace circumspect::properties
