// Determinants: two methods and the definition, held against each other.
#include "reference/kernel/exact/determinant.hpp"

#include <utility>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "inputs/plain_algebra.hpp"
#include "properties/arguments/numbers.hpp"

namespace circumspect {
namespace {

using Rows = std::vector<std::vector<Integer>>;

SquareMatrix matrix_of(const Rows& rows) {
  SquareMatrix matrix(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows.size(); ++j) matrix(i, j) = rows[i][j];
  }
  return matrix;
}

Rational by_definition(const Rows& rows) {
  std::vector<Point> points;
  for (const auto& row : rows) points.emplace_back(row.begin(), row.end());
  return generators::leibniz_determinant(points);
}

// Products of three factors, so that long numbers and zeros both come up often.
rc::Gen<Integer> entries() {
  const auto factor = rc::gen::oneOf(generators::integer_within(2), generators::integer_within(2),
                                     generators::integer_within(1L << 60));
  return rc::gen::map(rc::gen::tuple(factor, factor, factor),
                      [](const std::tuple<long, long, long>& factors) {
                        Integer product = std::get<0>(factors);
                        product *= std::get<1>(factors);
                        product *= std::get<2>(factors);
                        return product;
                      });
}

Rows any_matrix(std::size_t order) {
  return *rc::gen::container<Rows>(order,
                                   rc::gen::container<std::vector<Integer>>(order, entries()));
}

template <typename Law>
bool holds_for_orders(std::size_t first, std::size_t last, const Law& law) {
  bool all = true;
  for (std::size_t n = first; n <= last; ++n) {
    all = rc::check("order " + std::to_string(n), [&] { law(any_matrix(n)); }) && all;
  }
  return all;
}

TEST_CASE("determinant: of the empty matrix, of a triangular and of a singular one") {
  CHECK(determinant(SquareMatrix(0)) == 1);
  CHECK(determinant_by_bareiss(SquareMatrix(0)) == 1);
  CHECK(determinant(matrix_of({{-7}})) == -7);
  CHECK(determinant(matrix_of({{2, 5, 1}, {0, 3, 4}, {0, 0, -1}})) == -6);
  CHECK(determinant(matrix_of({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}})) == 0);
}

TEST_CASE("determinant: Bareiss finds a pivot below zeros, and says 0 where there is none") {
  CHECK(determinant_by_bareiss(matrix_of({{0, 1}, {1, 0}})) == -1);
  CHECK(determinant_by_bareiss(matrix_of({{0, 0, 1}, {0, 1, 0}, {1, 0, 0}})) == -1);
  CHECK(determinant_by_bareiss(matrix_of({{0, 0, 1}, {1, 0, 0}, {0, 1, 0}})) == 1);
  CHECK(determinant_by_bareiss(matrix_of({{0, 5, 1}, {0, 3, 4}, {0, 2, -1}})) == 0);
}

TEST_CASE("determinant: Laplace and Bareiss agree with Leibniz's formula up to order 4") {
  CHECK(holds_for_orders(1, 4, [](const Rows& rows) {
    const Rational expected = by_definition(rows);
    RC_ASSERT(Rational(determinant_by_laplace(matrix_of(rows))) == expected);
    RC_ASSERT(Rational(determinant_by_bareiss(matrix_of(rows))) == expected);
    RC_ASSERT(Rational(determinant(matrix_of(rows))) == expected);
  }));
}

TEST_CASE("determinant: Bareiss agrees with Leibniz's formula for orders 5 and 6") {
  CHECK(holds_for_orders(5, 6, [](const Rows& rows) {
    RC_ASSERT(Rational(determinant(matrix_of(rows))) == by_definition(rows));
  }));
}

TEST_CASE("determinant: swapping two rows negates it, transposing keeps it") {
  CHECK(holds_for_orders(2, 8, [](Rows rows) {
    const Integer before = determinant(matrix_of(rows));
    Rows transposed = rows;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < rows.size(); ++j) transposed[i][j] = rows[j][i];
    }
    RC_ASSERT(determinant(matrix_of(transposed)) == before);
    const long n = static_cast<long>(rows.size());
    const auto i = static_cast<std::size_t>(*generators::below(n - 1));
    std::swap(rows[i], rows.back());
    RC_ASSERT(determinant(matrix_of(rows)) == -before);
  }));
}

TEST_CASE("determinant: it is multiplicative") {
  CHECK(holds_for_orders(1, 8, [](const Rows& a) {
    const std::size_t n = a.size();
    const Rows b = any_matrix(n);
    Rows product(n, std::vector<Integer>(n));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t l = 0; l < n; ++l) product[i][j] += a[i][l] * b[l][j];
      }
    }
    RC_ASSERT(determinant(matrix_of(product)) ==
              determinant(matrix_of(a)) * determinant(matrix_of(b)));
  }));
}

TEST_CASE("determinant: rows that depend on each other make it zero") {
  CHECK(holds_for_orders(2, 8, [](Rows rows) {
    const Integer factor = *entries();
    for (std::size_t j = 0; j < rows.size(); ++j) {
      rows.back()[j] = factor * rows[0][j] - rows[rows.size() / 2 - 1][j];
    }
    RC_ASSERT(sign(determinant(matrix_of(rows))) == 0);
  }));
}

}  // namespace
}  // namespace circumspect
