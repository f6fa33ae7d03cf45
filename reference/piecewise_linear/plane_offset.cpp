#include "reference/piecewise_linear/plane_offset.hpp"

#include <cassert>

namespace circumspect {

Rational offset_from_plane(const std::vector<Point>& plane, const Point& q) {
  const Point u = plane[1] - plane[0];
  const Point v = plane[2] - plane[0];
  const Point normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                        u[0] * v[1] - u[1] * v[0]};
  std::size_t greatest = 0;
  for (const std::size_t axis : {1u, 2u}) {
    if (abs(normal[axis]) > abs(normal[greatest])) greatest = axis;
  }
  assert(sign(normal[greatest]) != 0);
  return inner_product(normal, q - plane[0]) / normal[greatest];
}

}  // namespace circumspect
