#include "oracle/judge/complex/orientation_signs.hpp"

#include "kernel/exact/number.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"

namespace circumspect::check {
namespace {

// The points as doubles; none if one coordinate is not a double, or the processor does not round
// as the bounds of the fast predicates assume.
template <std::size_t kDimension>
std::vector<fast::Site<kDimension>> sites_of(const Configuration& points) {
  if (points.ambient_dimension() != kDimension || !fast::arithmetic_is_as_proved()) return {};
  std::vector<fast::Site<kDimension>> sites(points.size());
  for (std::size_t v = 0; v < sites.size(); ++v) {
    const auto vertex = static_cast<Vertex>(v);
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      Rational exact(points.numerator(vertex, axis), points.denominator(vertex));
      exact.canonicalize();
      const auto same = as_double(exact);
      if (!same) return {};
      sites[v].at[axis] = *same;
    }
  }
  return sites;
}

template <std::size_t kDimension>
int fast_orientation(const std::vector<fast::Site<kDimension>>& sites,
                     std::span<const Vertex> simplex) {
  fast::SiteRow<kDimension> row;
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] = sites[static_cast<std::size_t>(simplex[i])];
  }
  fast::Stages stages;
  return fast::orientation<kDimension>(row, stages);
}

}  // namespace

OrientationSigns::OrientationSigns(const Configuration& points)
    : points_(points), in_plane_(sites_of<2>(points)), in_space_(sites_of<3>(points)) {}

int OrientationSigns::operator()(std::span<const std::size_t> axes,
                                 std::span<const Vertex> simplex) const {
  if (axes.size() == 2 && !in_plane_.empty()) return fast_orientation(in_plane_, simplex);
  if (axes.size() == 3 && !in_space_.empty()) return fast_orientation(in_space_, simplex);
  return orientation(points_, axes, simplex);
}

}  // namespace circumspect::check
