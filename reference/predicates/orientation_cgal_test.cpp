// Law O5 of reference/predicates/orientation.hpp: CGAL's exact kernel as the second opinion.
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <doctest/doctest.h>

#include "properties/generators/laws.hpp"
#include "properties/generators/plain_algebra.hpp"
#include "reference/predicates/orientation.hpp"

namespace circumspect {
namespace {

using generators::PointsCase;
using generators::Scaling;

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;

CGAL::Gmpq number(const Rational& x) { return CGAL::Gmpq(x.get_mpq_t()); }

// Calls visit(tuple) for all increasing tuples of `size` of the points.
template <typename Visit>
void for_all_tuples(std::size_t points, std::size_t size, const Visit& visit) {
  if (points < size) return;
  for (const auto& places : generators::subsets(points, size)) {
    visit(std::vector<Vertex>(places.begin(), places.end()));
  }
}

TEST_CASE("O5 the orientation in the plane is CGAL's") {
  const std::vector<std::size_t> axes = {0, 1};
  CHECK(generators::holds_for_sets(2, 2, [&](const PointsCase& set, Scaling scaling) {
    const Configuration points = generators::configuration(set, scaling);
    std::vector<Kernel::Point_2> theirs;
    for (const Point& p : set.points) theirs.emplace_back(number(p[0]), number(p[1]));
    for_all_tuples(set.points.size(), 3, [&](const std::vector<Vertex>& s) {
      const auto at = [&](std::size_t i) { return theirs[static_cast<std::size_t>(s[i])]; };
      RC_ASSERT(orientation(points, axes, s) ==
                static_cast<int>(CGAL::orientation(at(0), at(1), at(2))));
    });
  }));
}

TEST_CASE("O5 the orientation in space is the negative of CGAL's") {
  const std::vector<std::size_t> axes = {0, 1, 2};
  CHECK(generators::holds_for_sets(3, 3, [&](const PointsCase& set, Scaling scaling) {
    const Configuration points = generators::configuration(set, scaling);
    std::vector<Kernel::Point_3> theirs;
    for (const Point& p : set.points) {
      theirs.emplace_back(number(p[0]), number(p[1]), number(p[2]));
    }
    for_all_tuples(set.points.size(), 4, [&](const std::vector<Vertex>& s) {
      const auto at = [&](std::size_t i) { return theirs[static_cast<std::size_t>(s[i])]; };
      RC_ASSERT(orientation(points, axes, s) ==
                -static_cast<int>(CGAL::orientation(at(0), at(1), at(2), at(3))));
    });
  }));
}

}  // namespace
}  // namespace circumspect
