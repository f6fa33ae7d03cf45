// Formulas, their refutations, and complexes that have a triangulation or none.
#include "reference/existence/existence.hpp"

#include <set>

#include <doctest/doctest.h>

#include "inputs/named_complexes.hpp"
#include "reference/existence/refutation.hpp"

namespace circumspect::existence {
namespace {

// ---- Formulas as files ----

TEST_CASE("DIMACS: what is written is read back") {
  const Formula formula{3, {{1, -2}, {}, {3}}};
  const std::string text = to_dimacs(formula, {"variable 1: tetrahedron 0 1 2 3"});
  CHECK(text == "c variable 1: tetrahedron 0 1 2 3\np cnf 3 3\n1 -2 0\n0\n3 0\n");
  const auto read = read_dimacs(text);
  REQUIRE(read.has_value());
  CHECK(read->variables == 3);
  CHECK(read->clauses == formula.clauses);
  // Clauses may share lines or span them.
  CHECK(read_dimacs("p cnf 2 2\n1 2\n0 -1\n0")->clauses == std::vector<Clause>{{1, 2}, {-1}});
}

TEST_CASE("DIMACS: malformed files are told where") {
  for (const char* text :
       {"", "c only", "1 2 0", "p cnf 1", "p cnf -1 0", "p dnf 1 0", "p cnf 1 1\n2 0",
        "p cnf 1 1\n1", "p cnf 1 1\n1 0 1 0", "p cnf 1 2\n1 0", "p cnf 1 1 1\n1 0",
        "p cnf 99999999 0", "p cnf 1 1\nx 0", "p cnf 1 1\n-2147483648 0"}) {
    CAPTURE(text);
    CHECK_FALSE(read_dimacs(text).has_value());
  }
  CHECK(read_dimacs("c\np cnf 1 1\n1 2 0").error().line == 3);
}

TEST_CASE("DIMACS: malformed files are told what was expected and what was found") {
  struct Case {
    std::string text, expected, found;
  };
  const std::string header = "a header 'p cnf VARIABLES CLAUSES'";
  for (const Case& one : std::vector<Case>{
           {"c only", header, "the end of the file"},
           {"p dnf 1 0", header, "'p dnf 1 0'"},
           {"p cnf 1 1\n2 0", "a literal between -1 and 1, or 0", "'2'"},
           {"p cnf 1 1\n1", "a 0 at the end of the clause", "the end of the file"},
           {"p cnf 1 1\n1 0 1 0", "no more than 1 clauses, as the header says", "another"},
           {"p cnf 1 2\n1 0", "2 clauses, as the header says", "1 and the end of the file"}}) {
    CAPTURE(one.text);
    const auto read = read_dimacs(one.text);
    REQUIRE_FALSE(read.has_value());
    CHECK(read.error().expected == one.expected);
    CHECK(read.error().found == one.found);
  }
}

// ---- The solver, and the checker of its proofs, on formulas whose answer is known ----

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
  CHECK(quoted("a\tb\x1b[2J\xff") == "'a?b?[2J?'");
  CHECK(quoted(std::string(41, '1')) == "'" + std::string(40, '1') + "…'");
}

// ---- Complexes that have a triangulation, or a CDT, and those that have none ----

Existence triangulation_of(const PiecewiseLinearInput& input) {
  const auto complex = assemble(input);
  return any_triangulation(complex, Regions(complex));
}

Existence cdt_of(const PiecewiseLinearInput& input) {
  const auto complex = assemble(input);
  return any_cdt(complex, Regions(complex));
}

bool is_impossible(const Existence& existence) {
  const auto* impossible = std::get_if<Impossible>(&existence);
  return impossible != nullptr && replay(impossible->formula, impossible->refutation).has_value();
}

std::size_t tetrahedra(const Existence& existence) {
  const auto* exists = std::get_if<Exists>(&existence);
  return exists == nullptr ? 0 : exists->tetrahedra.size();
}

// Book: Figure 4.10.
TEST_CASE("existence: Schönhardt's polyhedron has no triangulation; with a vertex inside it has") {
  CHECK(is_impossible(triangulation_of(generators::schonhardt())));
  auto with_centre = generators::schonhardt();
  with_centre.points.push_back({0, 0, 5});
  CHECK(tetrahedra(triangulation_of(with_centre)) == 8);
}

// Book: Figure 4.12. It is impossible because the segments pass each other closely: at twice the
// distance there is a triangulation.
TEST_CASE("existence: a cube with three segments has no triangulation, with two it has") {
  auto loose = generators::cube_with_three_segments();
  for (std::size_t v = 8; v < loose.points.size(); ++v) {
    for (Rational& x : loose.points[v]) x = x == 0 || x == 4 ? x : 2 * x - 2;
  }
  CHECK(tetrahedra(triangulation_of(loose)) > 0);
  CHECK(is_impossible(triangulation_of(generators::cube_with_three_segments())));
  for (const int without : {0, 1, 2}) {
    CAPTURE(without);
    CHECK(tetrahedra(triangulation_of(generators::cube_with_three_segments(without))) > 0);
  }
}

// Book: Figure 4.15.
TEST_CASE("existence: an encircled segment has one triangulation, which is no CDT") {
  const auto only = triangulation_of(generators::encircled_segment());
  REQUIRE(std::holds_alternative<Exists>(only));
  CHECK(std::get<Exists>(only).tetrahedra ==
        std::vector<Simplex>{{0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}});
  CHECK(is_impossible(cdt_of(generators::encircled_segment())));
  auto without = generators::encircled_segment();
  without.segments.clear();
  CHECK(tetrahedra(cdt_of(without)) == 2);
}

// Book: Exercise 5 of Chapter 5.
TEST_CASE("existence: a complex with a CDT, and none once a polygon has been inserted") {
  CHECK(tetrahedra(cdt_of(generators::prism_on_a_sphere(false))) == 7);
  CHECK(is_impossible(triangulation_of(generators::prism_on_a_sphere(true))));
}

TEST_CASE("existence: a cube, hollow or with a cube inside, and as a hull") {
  CHECK(tetrahedra(cdt_of(generators::box(0, 1))) >= 5);
  auto boxes = generators::both(generators::box(0, 9), generators::box(3, 6));
  const std::size_t solid = tetrahedra(triangulation_of(boxes));
  boxes.hole_seeds = {{4, 4, 4}};
  const std::size_t hollow = tetrahedra(triangulation_of(boxes));
  CHECK(hollow > 5);
  CHECK(solid >= hollow);
  PiecewiseLinearInput hull = generators::schonhardt();
  hull.kind = DomainKind::kHull;
  CHECK(is_impossible(triangulation_of(hull)));
  hull.polygons.clear();
  CHECK(tetrahedra(triangulation_of(hull)) > 0);
}

// Book: Figure 4.13. One notch above and one below still leave room.
TEST_CASE("existence: Chazelle's polyhedron") {
  CHECK(tetrahedra(cdt_of(generators::chazelle(1))) > 0);
  CHECK(is_impossible(triangulation_of(generators::chazelle(2))));
}

TEST_CASE("existence: a limit is an answer, not a guess") {
  const auto complex = assemble(generators::box(0, 1));
  CHECK(std::holds_alternative<Unknown>(any_triangulation(complex, Regions(complex), {7, 0})));
  CHECK(std::holds_alternative<Unknown>(any_cdt(complex, Regions(complex), {60, 0, 10})));
}

}  // namespace

}  // namespace circumspect::existence
