// Formulas as files.
#include "reference/existence/dimacs.hpp"

#include <doctest/doctest.h>

#include "reference/existence/formula.hpp"

namespace circumspect::existence {
namespace {

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

}  // namespace
}  // namespace circumspect::existence
