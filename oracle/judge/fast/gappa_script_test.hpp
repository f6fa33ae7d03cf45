// Writes the operations of a polynomial as a Gappa script that bounds their rounding errors.
#pragma once

#include <cctype>
#include <cstddef>
#include <map>
#include <memory>
#include <string>

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

}  // namespace circumspect::fast
