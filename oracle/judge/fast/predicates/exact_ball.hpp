// The exact stages of ball tests, for several queries of one simplex.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "oracle/judge/fast/predicates/fixed_width.hpp"
#include "oracle/judge/fast/predicates/lattice.hpp"
#include "oracle/judge/fast/predicates/polynomials.hpp"
#include "oracle/judge/fast/predicates/site.hpp"

namespace circumspect::fast {

// Gives the answers of exact_sign, by the same stages: the integers of the simplex are computed
// once, its cofactors when a query first needs them. It does not support weights.
template <std::size_t kDimension>
class ExactBall {
 public:
  // Requires: finite coordinates.
  explicit ExactBall(const SiteRow<kDimension>& vertices);

  int contains(const Site<kDimension>& query, Stages& stages);

 private:
  using Whole = std::array<std::int64_t, kDimension>;

  using FixedCofactors = std::conditional_t<kDimension == 2, TriangleCofactors<Fixed<2>, Fixed<3>>,
                                            TetrahedronCofactors<Fixed<3>, Fixed<4>, Fixed<4>>>;
  using NarrowCofactors =
      std::conditional_t<kDimension == 2, TriangleCofactors<Narrow<2>, Narrow<3>>,
                         TetrahedronCofactors<Narrow<3>, Narrow<4>, Narrow<4>>>;

  SiteRow<kDimension> vertices_;
  std::optional<GridUnit> unit_;        // none: not for these sites
  Whole last_;                          // the last vertex in this unit
  std::array<Whole, kDimension> rows_;  // the others, as seen from there
  std::uint64_t any_ = 0,
                widest_ = 0;  // all bits of the rows, and of their absolute values
  std::optional<FixedCofactors> fixed_ = {};
  std::optional<NarrowCofactors> narrow_ =
      {};  // without the factors of two that the rows have in common
};

extern template class ExactBall<2>;
extern template class ExactBall<3>;

}  // namespace circumspect::fast
