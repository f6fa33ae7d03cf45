#include "reference/existence/dimacs.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "reference/existence/formula.hpp"
#include "reference/existence/refutation.hpp"

namespace circumspect::existence {
namespace {

// The words of a line, one after the other; empty at its end.
std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
  const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

std::optional<int> number(std::string_view word) {
  int value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  if (value == std::numeric_limits<int>::min()) return std::nullopt;
  return value;
}

constexpr const char* kHeader = "a header 'p cnf VARIABLES CLAUSES'";

// What was expected, and what was found instead.
struct Fault {
  std::string expected;
  std::string found;
};

class Reader {
 public:
  // The fault of a line, or nothing if it is correct.
  std::optional<Fault> read(std::string_view line) {
    std::string_view rest = line;
    const std::string_view word = next_word(rest);
    if (word.empty() || word == "c") return std::nullopt;
    if (clauses_ < 0) return header(line, word, rest);
    return literals(line);
  }

  std::optional<Fault> end() const {
    if (clauses_ < 0) return Fault{kHeader, kEnd};
    if (!clause_.empty()) return Fault{"a 0 at the end of the clause", kEnd};
    if (std::ssize(formula_.clauses) != clauses_) {
      return Fault{std::to_string(clauses_) + " clauses, as the header says",
                   std::to_string(formula_.clauses.size()) + " and " + kEnd};
    }
    return std::nullopt;
  }

  Formula formula() { return std::move(formula_); }

 private:
  static constexpr const char* kEnd = "the end of the file";

  std::optional<Fault> header(std::string_view line, std::string_view word, std::string_view rest) {
    const bool is_header = word == "p" && next_word(rest) == "cnf";
    const auto variables = number(next_word(rest));
    const auto clauses = number(next_word(rest));
    if (!is_header || !variables || !clauses || *variables < 0 || *clauses < 0 ||
        *variables > kLargestVariable || !next_word(rest).empty()) {
      return Fault{kHeader, in_quotes(line)};
    }
    formula_.variables = *variables;
    clauses_ = *clauses;
    return std::nullopt;
  }

  std::optional<Fault> literals(std::string_view line) {
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      const auto literal = number(word);
      if (!literal || std::abs(*literal) > formula_.variables) {
        const std::string most = std::to_string(formula_.variables);
        return Fault{"a literal between -" + most + " and " + most + ", or 0", in_quotes(word)};
      }
      if (*literal != 0) {
        clause_.push_back(*literal);
      } else if (std::ssize(formula_.clauses) == clauses_) {
        return Fault{"no more than " + std::to_string(clauses_) + " clauses, as the header says",
                     "another"};
      } else {
        formula_.clauses.push_back(std::move(clause_));
        clause_.clear();
      }
    }
    return std::nullopt;
  }

  Formula formula_;
  std::ptrdiff_t clauses_ = -1;  // as announced; −1 before the header
  Clause clause_;                // that has not ended yet
};

}  // namespace

std::string to_dimacs(const Formula& formula, const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) text += "c " + comment + "\n";
  text += "p cnf " + std::to_string(formula.variables) + " " +
          std::to_string(formula.clauses.size()) + "\n";
  for (const Clause& clause : formula.clauses) {
    for (const Literal literal : clause) text += std::to_string(literal) + " ";
    text += "0\n";
  }
  return text;
}

tl::expected<Formula, MalformedProof> read_dimacs(std::string_view text) {
  Reader reader;
  std::size_t line = 1;
  for (; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (const auto fault = reader.read(text.substr(0, end))) {
      return tl::make_unexpected(MalformedProof{line, fault->expected, fault->found});
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (const auto fault = reader.end()) {
    return tl::make_unexpected(MalformedProof{line, fault->expected, fault->found});
  }
  return reader.formula();
}

}  // namespace circumspect::existence
