// Square systems of linear equations.
#include "reference/kernel/exact/linear_system.hpp"

#include <doctest/doctest.h>

#include "inputs/plain_algebra.hpp"
#include "inputs/scalars.hpp"

namespace circumspect {
namespace {

std::vector<Rational> product(const RationalMatrix& a, const std::vector<Rational>& x) {
  std::vector<Rational> b;
  for (const std::vector<Rational>& row : a) b.push_back(inner_product(row, x));
  return b;
}

TEST_CASE("linear system: no equation, one equation, a system that needs an exchange of rows") {
  CHECK(solve({}, {}) == std::vector<Rational>{});
  CHECK(solve({{3}}, {2}) == std::vector<Rational>{Rational(2, 3)});
  CHECK(!solve({{0}}, {0}));
  CHECK(!solve({{0}}, {1}));
  CHECK(solve({{0, 2}, {5, 0}}, {1, 1}) == std::vector<Rational>{Rational(1, 5), Rational(1, 2)});
}

TEST_CASE("linear system: singular, with and without a solution") {
  CHECK(!solve({{1, 2}, {2, 4}}, {1, 2}));
  CHECK(!solve({{1, 2}, {2, 4}}, {1, 3}));
  CHECK(!solve({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, {1, 1, 1}));
}

TEST_CASE("linear system: there is an answer iff the determinant is not zero, and it is exact") {
  std::size_t singular = 0;
  CHECK(rc::check([&] {
    const auto n = static_cast<std::size_t>(*generators::below(5));
    // Small entries, so that singular matrices come up.
    const auto a = *rc::gen::container<RationalMatrix>(
        n, rc::gen::container<std::vector<Rational>>(n, generators::integer_number(2)));
    const auto b = *rc::gen::container<std::vector<Rational>>(n, generators::small_rational());
    const auto x = solve(a, b);
    RC_ASSERT(x.has_value() == (sign(generators::leibniz_determinant(a)) != 0));
    if (x) {
      RC_ASSERT(product(a, *x) == b);
    } else {
      ++singular;
    }
  }));
  CHECK(singular > 0);
}

}  // namespace
}  // namespace circumspect
