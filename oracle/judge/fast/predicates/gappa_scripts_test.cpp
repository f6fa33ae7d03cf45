// Writes the operations of a polynomial as a Gappa script that bounds their rounding errors.
#include <cctype>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string>

#include <doctest/doctest.h>

#include "oracle/judge/fast/predicates/filter.hpp"
#include "oracle/judge/fast/predicates/polynomials.hpp"

namespace circumspect::fast {

// The record of an expression: a number type for polynomials.hpp.
struct Operation;
using Term = std::shared_ptr<const Operation>;
struct Operation {
  char sign = 0;     // 0: a difference, by its name
  std::string name;  // lower case
  Term left, right;
};

// A difference of two doubles, rounded once, at most 1 in absolute value after scaling.
inline Term difference(const std::string& name) {
  return std::make_shared<Operation>(Operation{0, name, nullptr, nullptr});
}
inline Term operator+(const Term& a, const Term& b) {
  return std::make_shared<Operation>(Operation{'+', "", a, b});
}
inline Term operator-(const Term& a, const Term& b) {
  return std::make_shared<Operation>(Operation{'-', "", a, b});
}
inline Term operator*(const Term& a, const Term& b) {
  return std::make_shared<Operation>(Operation{'*', "", a, b});
}

// Operations are numbered from the leaves, left before right, each once.
class GappaScript {
 public:
  // A script that is proved if the computed value of `result` is always within `bound` of the exact one.
  static std::string of(const Term& result, const std::string& head, const std::string& bound) {
    GappaScript script;
    const std::string number = script.visit(result).substr(1);
    return head + script.definitions_ + "\n{\n" +
           script.hypotheses_.substr(0, script.hypotheses_.rfind(" /\\")) + "\n->\n  |t" + number +
           " - T" + number + "| <= " + bound + "\n}\n\n" + script.rewritings_;
  }

 private:
  // The name of the rounded value; that of the exact one is the same in capitals.
  std::string visit(const Term& term) {
    std::string& name = names_[term];
    if (!name.empty()) return name;
    if (term->sign == 0) {
      suppose(term->name + " in [-1, 1]");
      suppose(term->name + " -/ " + capitals(term->name) + " in [-1b-53, 1b-53]");
      return name = term->name;
    }
    const std::string left = visit(term->left), right = visit(term->right);
    const std::string number = std::to_string(++count_);
    define(*term, number, left, right);
    return names_[term] = "t" + number;
  }

  void define(const Operation& operation, const std::string& number, const std::string& left,
              const std::string& right) {
    const bool product = operation.sign == '*';
    const std::string op = std::string(" ") + operation.sign + " ";
    const std::string unrounded = "(" + left + op + right + ")";
    const std::string rounded = (product ? "r" : "t") + number;
    if (product) definitions_ += "t" + number + " = r" + number + " + u" + number + ";  ";
    definitions_ += "T" + number + " = " + capitals(left) + op + capitals(right) + ";\n";
    suppose(rounded + " -/ " + unrounded + " in [-1b-53, 1b-53]");
    if (!product) return;
    // Gappa finds by itself how errors add up, and needs to be told for a product with its underflow.
    suppose("u" + number + " in [-1b-125, 1b-125]");
    rewritings_ += "t" + number + " - T" + number + " -> (" + rounded + " - " + unrounded +
                   ") + (" + unrounded + " - T" + number + ") + u" + number + ";\n";
  }

  void suppose(const std::string& what) { hypotheses_ += "  " + what + " /\\\n"; }

  static std::string capitals(std::string name) {
    for (char& letter : name) {
      letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    }
    return name;
  }

  std::map<Term, std::string> names_;
  std::size_t count_ = 0;
  std::string definitions_;
  std::string hypotheses_;
  std::string rewritings_;
};

// ---- Gappa scripts ----
// The scripts in proofs/filters say of the code's own operations and constants what Gappa proves: each is
// written anew by running the polynomial on terms, and must be the file. After a deliberate change,
//     CIRCUMSPECT_WRITE_GAPPA=1 build/release/tests/fast_test
// writes the files; proofs/filters/check.sh then says whether they are proved.

namespace {

// As the code writes it: 0x1.001p-50.
std::string in_hexadecimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%a", value);
  return text;
}

// The differences of one row: of coordinates as they stand in the row, and of coordinates (and weight)
// as they stand in its height, which are scaled otherwise.
Row2<Term, Term> row_2(const std::string& name, bool weighted) {
  const Term x = difference(name + "x"), y = difference(name + "y");
  const Term w = height(difference(name + "xh"), difference(name + "yh"));
  return {x, y, weighted ? w - difference(name + "wh") : w};
}
Row3<Term, Term> row_3(const std::string& name, bool weighted) {
  const Term x = difference(name + "x"), y = difference(name + "y"), z = difference(name + "z");
  const Term w = height(difference(name + "xh"), difference(name + "yh"), difference(name + "zh"));
  return {x, y, z, weighted ? w - difference(name + "wh") : w};
}

void check_script(const std::string& name, const Term& result, double bound) {
  const std::string head =
      "# The error of `" + name +
      "` in oracle/judge/fast/predicates/polynomials.hpp, written by\n" +
      "# oracle/judge/fast/predicates/gappa_scripts_test.cpp; README.md says how to read it.\n\n";
  const std::string expected = GappaScript::of(result, head, in_hexadecimal(bound));
  const std::string path = CIRCUMSPECT_CORPUS_DIR "/../proofs/filters/" + name + ".gappa";
  if (std::getenv("CIRCUMSPECT_WRITE_GAPPA") != nullptr) std::ofstream(path) << expected;
  std::ifstream file(path);
  const std::string found{std::istreambuf_iterator<char>(file), {}};
  INFO(path);
  const bool script_is_that_of_the_code = found == expected;
  CHECK(script_is_that_of_the_code);
}

TEST_CASE("F5: the Gappa scripts are those of the operations and bounds of the code") {
  check_script("orientation_2",
               minor(difference("ax"), difference("ay"), difference("bx"), difference("by")),
               kOrientation2);
  const auto a = row_3("a", false), b = row_3("b", false), c = row_3("c", false);
  check_script("orientation_3", volume(a, b, c), kOrientation3);
  for (const bool weighted : {false, true}) {
    const std::string suffix = weighted ? "_weighted" : "";
    check_script(
        "in_circle" + suffix,
        in_circle(cofactors(row_2("a", weighted), row_2("b", weighted)), row_2("q", weighted)),
        weighted ? kInCircleWeighted : kInCircle);
    check_script(
        "in_sphere" + suffix,
        in_sphere(cofactors(row_3("a", weighted), row_3("b", weighted), row_3("c", weighted)),
                  row_3("q", weighted)),
        weighted ? kInSphereWeighted : kInSphere);
  }
}

TEST_CASE("F5: the orientation of a ball's simplex takes the operations of `orientation`") {
  const auto a = row_3("a", false), b = row_3("b", false), c = row_3("c", false);
  CHECK(GappaScript::of(cofactors(a, b, c).xyz, "", "1") ==
        GappaScript::of(volume(a, b, c), "", "1"));
  const auto p = row_2("p", true), q = row_2("q", true);
  CHECK(GappaScript::of(cofactors(p, q).xy, "", "1") ==
        GappaScript::of(minor(p.x, p.y, q.x, q.y), "", "1"));
}

TEST_CASE("F5: the rounding of the bound itself is no more than is added to it") {
  for (const double bound :
       {kOrientation2, kOrientation3, kInCircle, kInCircleWeighted, kInSphere, kInSphereWeighted}) {
    const double low = bound * kRoundedBound;
    CHECK(low - bound == bound * 0x1p-40);  // the product was exact
  }
}

}  // namespace

}  // namespace circumspect::fast
