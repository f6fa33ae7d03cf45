#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "kernel/exact/each_once.hpp"
#include "oracle/certificate/complex_certificate.hpp"
#include "oracle/certificate/document.hpp"
#include "oracle/model/rule.hpp"

namespace circumspect::certificate {

tl::expected<EqualPoints, std::string> equal_points_of(const Mesh& mesh, const Verdict& verdict) {
  const auto named =
      std::find_if(verdict.violations().begin(), verdict.violations().end(),
                   [](const Violation& one) { return one.rule == Rule::kPointsEqual; });
  assert(named != verdict.violations().end());
  const std::vector<Point> all = mesh.exact_points();
  std::vector<Point> different = all;
  keep_each_once(different);
  const PointSet set(different);
  const std::size_t dimension = set.ambient_dimension();
  if ((dimension != 2 && dimension != 3) || set.dimension() != static_cast<int>(dimension)) {
    return tl::unexpected(
        std::string("there is no refutation of this mesh: its points do not span the plane or "
                    "space"));
  }
  auto scaled = scaled_to_integers(set);
  if (!scaled) return tl::unexpected(scaled.error());
  EqualPoints made{.points = {dimension, scaled->scale_numerator, scaled->scale_denominator},
                   .first = named->witness.vertices.front(),
                   .second = named->witness.vertices.back()};
  for (const Point& point : all) {
    const auto place = std::lower_bound(different.begin(), different.end(), point);
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      made.points.coordinates.push_back(
          scaled->coordinate(static_cast<Vertex>(place - different.begin()), axis));
    }
  }
  for (const std::size_t v : set.configuration().hull().basis) {
    made.basis.push_back(
        static_cast<std::size_t>(std::find(all.begin(), all.end(), different[v]) - all.begin()));
  }
  return made;
}

void write(std::ostream& out, const Mesh& mesh, const EqualPoints& equal) {
  Lines lines(out);
  write_first_line(lines, "circumspect-refutation 2", Claim::kComplex, equal.points.dimension,
                   identifier(Rule::kPointsEqual));
  write_scale(lines, equal.points);
  write_points(lines, mesh, equal.points, first_subset(equal.points.size()));
  write_simplices(lines, mesh.simplices.lists());
  write_basis(lines, equal.basis);
  write_because(lines, {to_integer(equal.first) + 1, to_integer(equal.second) + 1});
}

}  // namespace circumspect::certificate
