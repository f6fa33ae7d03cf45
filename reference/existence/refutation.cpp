#include "reference/existence/refutation.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/exact/each_once.hpp"
#include "reference/existence/formula.hpp"

namespace circumspect::existence {
namespace {

// Clauses under a growing assignment, with two literals of each clause watched: as long as neither
// is false, the clause cannot have become unit. M. Moskewicz et al., Chaff, DAC 2001.
class UnitPropagation {
 public:
  static constexpr std::size_t kAssumed = std::numeric_limits<std::size_t>::max();

  explicit UnitPropagation(int variables) {
    values_.resize(static_cast<std::size_t>(variables) + 1, 0);
    causes_.resize(values_.size(), kAssumed);
    watched_.resize(2 * values_.size());
  }

  // The clause must not be used after `remove`.
  void add(Clause clause) {
    keep_each_once(clause);
    for (const Literal literal : clause) cover(literal);
    const std::size_t number = clauses_.size();
    numbers_[clause].push_back(number);
    if (clause.empty() && !empty_) empty_ = number;
    if (clause.size() == 1) units_.push_back(number);
    for (std::size_t i = 0; clause.size() > 1 && i < 2; ++i) watches(clause[i]).push_back(number);
    clauses_.push_back(std::move(clause));
  }

  void remove(Clause clause) {
    std::sort(clause.begin(), clause.end());
    const auto found = numbers_.find(clause);
    // A unit clause stays: it costs nothing, and its consequences stay valid.
    if (clause.size() < 2 || found == numbers_.end()) return;
    clauses_[found->second.back()].clear();
    found->second.pop_back();
    if (found->second.empty()) numbers_.erase(found);
  }

  // Does assuming the literals false make some clause false, by unit propagation alone?
  bool refutes(const Clause& literals) {
    conflict_ = empty_;
    bool conflict = empty_.has_value();
    for (const Literal literal : literals) conflict = conflict || !assign(-literal, kAssumed);
    for (const std::size_t unit : units_) conflict = conflict || !assign(clauses_[unit][0], unit);
    for (std::size_t next = 0; !conflict && next < trail_.size(); ++next) {
      conflict = !propagate(-trail_[next]);
    }
    antecedents_.clear();
    if (conflict && conflict_) find_antecedents();
    for (const Literal literal : trail_) values_[index(literal)] = 0;
    trail_.clear();
    return conflict;
  }

  // After `refutes`: the clauses that become unit in turn, by their numbers, and the one that
  // becomes false.
  const std::vector<std::size_t>& antecedents() const { return antecedents_; }

 private:
  static std::size_t index(Literal literal) { return static_cast<std::size_t>(std::abs(literal)); }
  std::vector<std::size_t>& watches(Literal literal) {
    return watched_[2 * index(literal) + (literal < 0 ? 1 : 0)];
  }
  int value(Literal literal) const {
    return literal < 0 ? -values_[index(literal)] : values_[index(literal)];
  }
  void cover(Literal literal) {
    if (index(literal) < values_.size()) return;
    values_.resize(index(literal) + 1, 0);
    causes_.resize(values_.size(), kAssumed);
    watched_.resize(2 * values_.size());
  }

  // Makes a literal true, as required by a clause; returns false if it is already false.
  bool assign(Literal literal, std::size_t clause) {
    cover(literal);
    if (value(literal) < 0) {
      if (clause != kAssumed) conflict_ = clause;
      return false;
    }
    if (value(literal) == 0) {
      values_[index(literal)] = literal < 0 ? -1 : 1;
      causes_[index(literal)] = clause;
      trail_.push_back(literal);
    }
    return true;
  }

  // From the clause that became false backwards.
  void find_antecedents() {
    std::set<std::size_t> needed;  // variables
    for (const Literal literal : clauses_[*conflict_]) needed.insert(index(literal));
    antecedents_ = {*conflict_};
    for (auto literal = trail_.rbegin(); literal != trail_.rend(); ++literal) {
      const std::size_t cause = causes_[index(*literal)];
      if (cause == kAssumed || !needed.contains(index(*literal))) continue;
      antecedents_.push_back(cause);
      for (const Literal other : clauses_[cause]) needed.insert(index(other));
    }
    std::reverse(antecedents_.begin(), antecedents_.end());
  }

  // A literal has become false: updates the clauses that watch it. Returns false on a conflict.
  bool propagate(Literal falsified) {
    std::vector<std::size_t>& list = watches(falsified);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      Clause& clause = clauses_[list[i]];
      if (clause.empty()) continue;  // deleted
      if (clause[0] == falsified) std::swap(clause[0], clause[1]);
      const auto other = std::find_if(clause.begin() + 2, clause.end(),
                                      [this](Literal literal) { return value(literal) >= 0; });
      if (value(clause[0]) <= 0 && other != clause.end()) {
        std::swap(clause[1], *other);
        watches(clause[1]).push_back(list[i]);
        continue;
      }
      list[kept++] = list[i];
      if (value(clause[0]) > 0 || assign(clause[0], list[i])) continue;
      for (++i; i < list.size(); ++i) list[kept++] = list[i];
      list.resize(kept);
      return false;
    }
    list.resize(kept);
    return true;
  }

  std::vector<int> values_;                             // by variable: 1 true, −1 false, 0 open
  std::vector<Literal> trail_;                          // true literals, in the order of assignment
  std::vector<Clause> clauses_;                         // the watched literals first
  std::map<Clause, std::vector<std::size_t>> numbers_;  // the place of each sorted clause
  std::vector<std::vector<std::size_t>> watched_;       // by literal
  std::vector<std::size_t> units_;                      // clauses of one literal
  std::optional<std::size_t> empty_;                    // a clause of none
  std::vector<std::size_t> causes_;      // by variable: the clause that made it true or false
  std::optional<std::size_t> conflict_;  // the clause that became false
  std::vector<std::size_t> antecedents_;
};

// The number that ends at a space or at the end, moved past; nothing if there is none.
bool read_literal(std::string_view& rest, Literal& literal) {
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), literal);
  if (error != std::errc() || literal == std::numeric_limits<Literal>::min()) return false;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return rest.empty() || rest.front() == ' ';
}

void skip_spaces(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(" \r"), rest.size()));
}

bool read_step(std::string_view line, ProofStep& step) {
  skip_spaces(line);
  if (line.starts_with("d ")) {
    step.deletes = true;
    line.remove_prefix(2);
  }
  for (;;) {
    skip_spaces(line);
    Literal literal = 0;
    if (!read_literal(line, literal)) return false;
    if (literal == 0) break;
    if (std::abs(literal) > kLargestVariable) return false;
    step.clause.push_back(literal);
  }
  skip_spaces(line);
  return line.empty();
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown;
  for (const char c : text.substr(0, kLongest)) shown += c < ' ' || c > '~' ? '?' : c;
  return "'" + shown + (text.size() > kLongest ? "…'" : "'");
}

tl::expected<Refutation, MalformedProof> read_refutation(std::string_view text) {
  Refutation refutation;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    ProofStep step;
    if (!read_step(text.substr(0, end), step)) {
      return tl::make_unexpected(MalformedProof{line, "literals and a 0, after d for a deletion",
                                                in_quotes(text.substr(0, end))});
    }
    refutation.push_back(std::move(step));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return refutation;
}

std::string to_text(const Refutation& refutation) {
  std::string text;
  for (const ProofStep& step : refutation) {
    if (step.deletes) text += "d ";
    for (const Literal literal : step.clause) text += std::to_string(literal) + " ";
    text += "0\n";
  }
  return text;
}

tl::expected<void, ProofFault> replay(const Formula& formula, const Refutation& refutation) {
  UnitPropagation propagation(formula.variables);
  for (const Clause& clause : formula.clauses) propagation.add(clause);
  for (std::size_t i = 0; i < refutation.size(); ++i) {
    const ProofStep& step = refutation[i];
    if (step.deletes) {
      propagation.remove(step.clause);
      continue;
    }
    if (!propagation.refutes(step.clause)) return tl::make_unexpected(ProofFault{i});
    if (step.clause.empty()) return {};
    propagation.add(step.clause);
  }
  if (propagation.refutes({})) return {};
  return tl::make_unexpected(ProofFault{refutation.size()});
}

std::optional<std::vector<HintedStep>> with_hints(const Formula& formula,
                                                  const Refutation& refutation) {
  UnitPropagation propagation(formula.variables);
  for (const Clause& clause : formula.clauses) propagation.add(clause);
  std::vector<HintedStep> steps;
  const auto follows = [&](const Clause& clause) {
    if (!propagation.refutes(clause) || propagation.antecedents().empty()) return false;
    steps.push_back({clause, propagation.antecedents()});
    return true;
  };
  for (const ProofStep& step : refutation) {
    if (step.deletes) {
      propagation.remove(step.clause);
      continue;
    }
    if (!follows(step.clause)) return std::nullopt;
    if (step.clause.empty()) return steps;
    propagation.add(step.clause);
  }
  if (!follows({})) return std::nullopt;
  return steps;
}

}  // namespace circumspect::existence
