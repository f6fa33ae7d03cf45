// Determinants, and linear programs compared with an enumeration of all bases.
#include "kernel/exact/linear_algebra.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "inputs/plain_algebra.hpp"
#include "properties/arguments/generated.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect {

// Determinants: two methods, compared with each other and with the definition.

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

// Products of three factors, so that long numbers and zeros are both common.
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
    all = properties::holds("order " + std::to_string(n), [&] { law(any_matrix(n)); }) && all;
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

// Systems of linear equations, and linear programs.

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
  CHECK(properties::holds([&] {
    const auto n = static_cast<std::size_t>(*generators::below(5));
    // Small entries, so that singular matrices occur.
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

using Status = LinearProgramStatus;

Point column(const LinearProgram& program, std::size_t j) {
  Point entries;
  for (const std::vector<Rational>& row : program.equations) entries.push_back(row[j]);
  return entries;
}

bool is_feasible(const LinearProgram& program, const std::vector<Rational>& x) {
  for (const Rational& entry : x) {
    if (sign(entry) < 0) return false;
  }
  for (std::size_t i = 0; i < program.equations.size(); ++i) {
    if (inner_product(program.equations[i], x) != program.right_sides[i]) return false;
  }
  return true;
}

// The solution of the equations that only some variables take part in, if their columns are
// linearly independent and there is one: by the normal equations.
std::optional<Point> basic_solution(const LinearProgram& program,
                                    const std::vector<std::size_t>& basis) {
  std::vector<Point> gram;
  Point right;
  for (const std::size_t i : basis) {
    Point row;
    for (const std::size_t j : basis) {
      row.push_back(inner_product(column(program, i), column(program, j)));
    }
    gram.push_back(row);
    right.push_back(inner_product(column(program, i), program.right_sides));
  }
  if (sign(generators::leibniz_determinant(gram)) == 0) return std::nullopt;
  const Point values = generators::cramer_solution(gram, right);
  Point x(program.objective.size(), Rational(0));
  for (std::size_t i = 0; i < basis.size(); ++i) x[basis[i]] = values[i];
  if (!is_feasible(program, x)) return std::nullopt;
  return x;
}

// The largest objective of a basic feasible solution; nothing if there is none.
std::optional<Rational> best_basic_value(const LinearProgram& program) {
  std::optional<Rational> best;
  const std::size_t n = program.objective.size();
  for (std::size_t size = 0; size <= std::min(n, program.equations.size()); ++size) {
    for (const std::vector<std::size_t>& basis : generators::subsets(n, size)) {
      const auto x = basic_solution(program, basis);
      if (!x) continue;
      const Rational value = inner_product(program.objective, *x);
      if (!best || *best < value) best = value;
    }
  }
  return best;
}

// A program with a feasible point is unbounded iff some direction r ≥ 0 with A r = 0 and Σ r = 1
// improves the objective; the directions are a polytope, so that its vertices decide.
bool has_improving_direction(const LinearProgram& program) {
  LinearProgram directions = program;
  directions.right_sides.assign(program.right_sides.size(), Rational(0));
  directions.equations.emplace_back(program.objective.size(), Rational(1));
  directions.right_sides.push_back(1);
  const auto best = best_basic_value(directions);
  return best && sign(*best) > 0;
}

void check_against_enumeration(const LinearProgram& program, std::map<Status, int>& seen) {
  const LinearProgramAnswer answer = maximize(program);
  const auto best = best_basic_value(program);
  ++seen[answer.status];
  if (!best) {
    RC_ASSERT(answer.status == Status::kInfeasible);
    return;
  }
  RC_ASSERT(is_feasible(program, answer.solution));
  RC_ASSERT(answer.value == inner_product(program.objective, answer.solution));
  if (has_improving_direction(program)) {
    RC_ASSERT(answer.status == Status::kUnbounded);
    return;
  }
  RC_ASSERT(answer.status == Status::kOptimal);
  RC_ASSERT(answer.value == *best);
}

TEST_CASE("linear program: one optimum, many optima, a fraction") {
  // max x + 2y, x + y + s = 4, y + t = 3.
  const LinearProgramAnswer corner = maximize({{{1, 1, 1, 0}, {0, 1, 0, 1}}, {4, 3}, {1, 2, 0, 0}});
  CHECK(corner.status == Status::kOptimal);
  CHECK(corner.value == 7);
  CHECK(corner.solution == std::vector<Rational>{1, 3, 0, 0});
  const LinearProgramAnswer edge = maximize({{{1, 1}}, {1}, {5, 5}});
  CHECK(edge.status == Status::kOptimal);
  CHECK(edge.value == 5);
  const LinearProgramAnswer fraction = maximize({{{3, 1}}, {1}, {1, 0}});
  CHECK(fraction.value == Rational(1, 3));
}

TEST_CASE("linear program: infeasible, by sign and by contradiction") {
  CHECK(maximize({{{1, 1}}, {-1}, {1, 0}}).status == Status::kInfeasible);
  CHECK(maximize({{{1, 1}, {2, 2}}, {1, 3}, {0, 0}}).status == Status::kInfeasible);
  CHECK(maximize({{{0, 0}}, {1}, {0, 0}}).status == Status::kInfeasible);
}

TEST_CASE("linear program: unbounded, with a feasible point; no equations") {
  const LinearProgram ray = {{{1, -1}}, {2}, {1, 0}};
  const LinearProgramAnswer answer = maximize(ray);
  CHECK(answer.status == Status::kUnbounded);
  CHECK(is_feasible(ray, answer.solution));
  CHECK(maximize({{}, {}, {1}}).status == Status::kUnbounded);
  const LinearProgramAnswer zero = maximize({{}, {}, {-1, 0}});
  CHECK(zero.status == Status::kOptimal);
  CHECK(zero.solution == std::vector<Rational>{0, 0});
}

TEST_CASE("linear program: redundant equations keep an artificial variable basic at zero") {
  const LinearProgramAnswer answer =
      maximize({{{1, 1, 0}, {2, 2, 0}, {1, 1, 0}}, {1, 2, 1}, {1, 0, -1}});
  CHECK(answer.status == Status::kOptimal);
  CHECK(answer.value == 1);
  CHECK(answer.solution == std::vector<Rational>{1, 0, 0});
}

// E. M. L. Beale, Naval Research Logistics Quarterly 2, 1955: the largest-coefficient rule cycles.
TEST_CASE("linear program: a degenerate program on which other pivot rules cycle") {
  const Rational quarter(1, 4);
  const Rational half(1, 2);
  const LinearProgram beale = {{{1, 0, 0, quarter, -60, Rational(-1, 25), 9},
                                {0, 1, 0, half, -90, Rational(-1, 50), 3},
                                {0, 0, 1, 0, 0, 1, 0}},
                               {0, 0, 1},
                               {0, 0, 0, Rational(3, 4), -150, Rational(1, 50), -6}};
  const LinearProgramAnswer answer = maximize(beale);
  CHECK(answer.status == Status::kOptimal);
  CHECK(answer.value == Rational(1, 20));
  CHECK(is_feasible(beale, answer.solution));
}

// Found by search: it cycles where Bland's rule is followed for the variable that enters, and of
// the rows that bind it first the one with the largest variable leaves.
TEST_CASE("linear program: a degenerate program on which half of Bland's rule cycles") {
  const LinearProgram program = {
      {{-4, 8, -5, 1, -1, 5, 0}, {3, -5, -5, 2, 0, -9, -9}, {-6, -9, -7, -1, 0, -9, 2}},
      {0, 0, 0},
      {-4, -9, 2, 2, 4, 5, 4}};
  const LinearProgramAnswer answer = maximize(program);
  CHECK(answer.status ==
        (has_improving_direction(program) ? Status::kUnbounded : Status::kOptimal));
  CHECK(is_feasible(program, answer.solution));
}

TEST_CASE("linear program: it agrees with the enumeration of all basic solutions") {
  std::map<Status, int> seen;
  CHECK(properties::holds([&] {
    const auto m = static_cast<std::size_t>(*generators::below(4));
    const auto n = static_cast<std::size_t>(1 + *generators::below(5));
    LinearProgram program;
    // Many zeros and small numbers: degenerate bases, redundant and contradictory equations.
    program.equations = *rc::gen::container<RationalMatrix>(
        m, rc::gen::container<std::vector<Rational>>(n, generators::integer_number(2)));
    program.right_sides =
        *rc::gen::container<std::vector<Rational>>(m, generators::integer_number(2));
    program.objective = *rc::gen::container<std::vector<Rational>>(n, generators::small_rational());
    check_against_enumeration(program, seen);
  }));
  CHECK(seen.size() == 3);  // every answer came up
}

TEST_CASE("is_solvable: by numbers that are not negative, or that have to be positive") {
  const RationalMatrix sum = {{1, 1}};
  CHECK(is_solvable(sum, {1}));
  CHECK(is_solvable(sum, {1}, 2));
  CHECK(is_solvable(sum, {0}));
  CHECK_FALSE(is_solvable(sum, {0}, 1));
  CHECK_FALSE(is_solvable(sum, {-1}));
  const RationalMatrix difference = {{1, -1}};
  CHECK(is_solvable(difference, {0}, 2));  // by numbers of any size
  CHECK(is_solvable(difference, {-1}, 1));
  // x = 1 and y = 0.
  const RationalMatrix both = {{1, 1}, {1, -1}};
  CHECK(is_solvable(both, {1, 1}, 1));
  CHECK_FALSE(is_solvable(both, {1, 1}, 2));
}

}  // namespace

}  // namespace circumspect
