// The solver, and the checker of its proofs, on formulas whose answer is known.
#include "reference/existence/solver.hpp"

#include <set>

#include <doctest/doctest.h>

#include "reference/existence/formula.hpp"
#include "reference/existence/refutation.hpp"

namespace circumspect::existence {
namespace {

// Can `pigeons` sit in `holes`, no two in one? Variable p·holes + h + 1: pigeon p sits in hole h.
Formula pigeons_in_holes(int pigeons, int holes) {
  Formula formula{pigeons * holes, {}};
  for (int p = 0; p < pigeons; ++p) {
    Clause somewhere;
    for (int h = 0; h < holes; ++h) {
      somewhere.push_back(p * holes + h + 1);
      for (int q = 0; q < p; ++q) {
        formula.clauses.push_back({-(p * holes + h + 1), -(q * holes + h + 1)});
      }
    }
    formula.clauses.push_back(somewhere);
  }
  return formula;
}

TEST_CASE("solver: pigeons in holes, with a proof that the replay accepts") {
  const auto fits = solve(pigeons_in_holes(5, 5));
  REQUIRE(std::holds_alternative<Satisfied>(fits));
  CHECK(is_satisfied(pigeons_in_holes(5, 5), std::get<Satisfied>(fits).assignment));
  const Formula crowd = pigeons_in_holes(6, 5);
  const auto refuted = solve(crowd);
  REQUIRE(std::holds_alternative<Refuted>(refuted));
  const Refutation& proof = std::get<Refuted>(refuted).refutation;
  CHECK(replay(crowd, proof).has_value());
  // The same proof proves nothing of a formula that can be satisfied.
  CHECK_FALSE(replay(pigeons_in_holes(5, 5), proof).has_value());
  const auto read = read_refutation(to_text(proof));
  REQUIRE(read.has_value());
  CHECK(replay(crowd, *read).has_value());
}

TEST_CASE("proofs with hints: each clause becomes unit in its turn, and the last one false") {
  const Formula crowd = pigeons_in_holes(6, 5);
  const auto refuted = solve(crowd);
  const Refutation& proof = std::get<Refuted>(refuted).refutation;
  const auto steps = with_hints(crowd, proof);
  REQUIRE(steps.has_value());
  REQUIRE(steps->back().clause.empty());
  std::vector<Clause> clauses = crowd.clauses;
  for (const HintedStep& step : *steps) {
    std::set<Literal> is_false(step.clause.begin(), step.clause.end());
    for (std::size_t i = 0; i < step.hints.size(); ++i) {
      REQUIRE(step.hints[i] < clauses.size());
      Clause open = clauses[step.hints[i]];
      std::erase_if(open, [&](Literal literal) { return is_false.contains(literal); });
      REQUIRE(open.size() == (i + 1 < step.hints.size() ? 1 : 0));
      if (!open.empty()) is_false.insert(-open.front());
    }
    clauses.push_back(step.clause);
  }
  CHECK_FALSE(with_hints(pigeons_in_holes(5, 5), proof).has_value());
  CHECK_FALSE(with_hints({1, {{1}}}, {}).has_value());
  CHECK(with_hints({1, {{1}, {}}}, {})->back().hints == std::vector<std::size_t>{1});
}

TEST_CASE("solver: a limit on conflicts leaves it undecided") {
  CHECK(std::holds_alternative<Undecided>(solve(pigeons_in_holes(9, 8), 10)));
}

TEST_CASE("replay: a step that does not follow is found, and so is a proof without an end") {
  const Formula formula{3, {{1, 2}, {-1, 2}, {1, -2}, {-1, -2}}};
  CHECK(replay(formula, {{false, {2}}, {false, {}}}).has_value());
  CHECK(replay(formula, {{false, {3}}, {false, {}}}).error().step == 0);
  CHECK(replay(formula, {{false, {2}}}).has_value());
  CHECK(replay({3, {{1, 2}, {-1, 2}}}, {{false, {2}}}).error().step == 1);
  CHECK(replay(formula, {{false, {}}}).error().step == 0);
  // After deleting a clause, what follows only from it no longer follows.
  CHECK(replay(formula, {{true, {2, -1}}, {false, {2}}, {false, {}}}).error().step == 1);
  CHECK(replay(formula, {{true, {7, 8}}, {false, {2}}, {false, {}}}).has_value());
  CHECK(replay({1, {{1}, {-1}}}, {{false, {}}}).has_value());
  CHECK(replay({1, {{}}}, {{false, {}}}).has_value());
}

TEST_CASE("proof files: malformed lines are named") {
  CHECK(read_refutation("1 -2 0\nd 3 0\n0\n")->size() == 3);
  CHECK(read_refutation("").has_value());
  for (const char* text :
       {"1 2", "1 x 0", "1 0 2", "d", "99999999999 0", "90000000 0", "1 0\n\n"}) {
    CAPTURE(text);
    CHECK_FALSE(read_refutation(text).has_value());
  }
  CHECK(read_refutation("1 0\n2 0\n+ 0").error().line == 3);
  CHECK(read_refutation("1 0\n2 0\n+ 0").error().found == "'+ 0'");
  CHECK(read_refutation("1 0\n\n").error().found == "''");
  // Quoted text is short and printable.
  CHECK(in_quotes("a\tb\x1b[2J\xff") == "'a?b?[2J?'");
  CHECK(in_quotes(std::string(41, '1')) == "'" + std::string(40, '1') + "…'");
}

}  // namespace
}  // namespace circumspect::existence
