// Formulas as files: DIMACS, the format of SAT solvers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "reference/existence/formula.hpp"
#include "reference/existence/refutation.hpp"

namespace circumspect::existence {

// The formula, after comments of one line each.
std::string to_dimacs(const Formula& formula, const std::vector<std::string>& comments = {});

// Reads comments (c …), one header (p cnf variables clauses) and as many clauses as it announces,
// each of literals and a 0, on lines as they like. The header's counts are not trusted: they must
// agree with what follows, and no memory is reserved for them.
tl::expected<Formula, MalformedProof> read_dimacs(std::string_view text);

}  // namespace circumspect::existence
