// The first stage for a simplex and what is asked of it: what depends on the simplex alone is
// computed once. One text for single simplices (predicates.hpp) and for many (block.cpp), which has
// to be inlined.
#pragma once

#include <cstddef>

#include "oracle/judge/fast/filter.hpp"

namespace circumspect::fast {

template <std::size_t kDimension>
struct SimplexFilter;
template <>
struct SimplexFilter<2> {
  Scale2 scale;
  TriangleCofactors<double, double> cofactors;
};
template <>
struct SimplexFilter<3> {
  Scale3 scale;
  TetrahedronCofactors<double, double, double> cofactors;
};

template <bool kWeighted>
[[gnu::always_inline]] inline SimplexFilter<2> simplex_filter(const Site<2>& a, const Site<2>& b,
                                                              const Site<2>& c) {
  const FilterRow2 from_a = row_from<kWeighted>(c, a), from_b = row_from<kWeighted>(c, b);
  return {larger(from_a.scale, from_b.scale), cofactors(from_a.row, from_b.row)};
}
template <bool kWeighted>
[[gnu::always_inline]] inline SimplexFilter<3> simplex_filter(const Site<3>& a, const Site<3>& b,
                                                              const Site<3>& c, const Site<3>& d) {
  const FilterRow3 from_a = row_from<kWeighted>(d, a), from_b = row_from<kWeighted>(d, b),
                   from_c = row_from<kWeighted>(d, c);
  return {larger(larger(from_a.scale, from_b.scale), from_c.scale),
          cofactors(from_a.row, from_b.row, from_c.row)};
}

// The orientation, or kUncertain.
template <typename Sign>
[[gnu::always_inline]] inline Sign filtered_orientation(const SimplexFilter<2>& simplex,
                                                        Lattice lattice) {
  return certain_sign<Sign>(simplex.cofactors.xy, kOrientation2, simplex.scale, lattice);
}
template <typename Sign>
[[gnu::always_inline]] inline Sign filtered_orientation(const SimplexFilter<3>& simplex,
                                                        Lattice lattice) {
  return certain_sign<Sign>(simplex.cofactors.xyz, kOrientation3, simplex.scale, lattice);
}

// Ball::contains (predicates.hpp), or kUncertain. `last` is the simplex's last vertex.
template <bool kWeighted, typename Sign>
[[gnu::always_inline]] inline Sign filtered_ball(const SimplexFilter<2>& simplex,
                                                 const Site<2>& last, const Site<2>& query,
                                                 Lattice lattice) {
  const FilterRow2 from = row_from<kWeighted>(last, query);
  return certain_lifted_sign<Sign>(in_circle(simplex.cofactors, from.row),
                                   kWeighted ? kInCircleWeighted : kInCircle,
                                   larger(simplex.scale, from.scale), lattice);
}
template <bool kWeighted, typename Sign>
[[gnu::always_inline]] inline Sign filtered_ball(const SimplexFilter<3>& simplex,
                                                 const Site<3>& last, const Site<3>& query,
                                                 Lattice lattice) {
  const FilterRow3 from = row_from<kWeighted>(last, query);
  return certain_lifted_sign<Sign>(in_sphere(simplex.cofactors, from.row),
                                   kWeighted ? kInSphereWeighted : kInSphere,
                                   larger(simplex.scale, from.scale), lattice);
}

}  // namespace circumspect::fast
