#include "inputs/any_case.hpp"

namespace circumspect::generators {
namespace {

PointSets half_degenerate(std::size_t dimension, std::size_t max_points) {
  return rc::gen::oneOf(any_point_set(dimension, max_points),
                        degenerate_point_set(dimension, max_points));
}

}  // namespace

rc::Gen<PointsCase> any_case(std::size_t dimension, std::size_t max_points) {
  const PointSets sets = half_degenerate(dimension, max_points);
  return rc::gen::oneOf(unweighted(sets), weighted(sets, max_points));
}

rc::Gen<PointsCase> any_unweighted_case(std::size_t dimension, std::size_t max_points) {
  return unweighted(half_degenerate(dimension, max_points));
}

}  // namespace circumspect::generators
