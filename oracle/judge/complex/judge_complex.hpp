// Judges a mesh alone: do its simplices form a complex? docs/theory/complex.md says what that is.
#pragma once

#include <string>

#include "oracle/judge/complex/findings.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::check {

// Why the demands make no sense of simplices of so many vertices (0: there are none) and points of
// this dimension, one line; empty if they do.
std::string fault_of_demands(const ComplexDemands& demands, std::size_t size,
                             std::size_t dimension);
// The same of the simplices and the points of a mesh.
std::string fault_of_demands(const Mesh& mesh, const ComplexDemands& demands);

// Adds what was found of simplices, which are to have `size` vertices: by themselves, in pairs, and
// how they are listed.
void add_findings(const definition::ListedComplex& listed, const Findings& found,
                  const ComplexDemands& demands, std::size_t size, Verdict& verdict);

// The answer is the same by definition and by lemma, but for the time that it takes.
Verdict judge_complex(const definition::ListedComplex& listed, const ComplexDemands& demands,
                      bool by_definition, std::size_t max_violations,
                      const ImproperAmong& among = {});

// The verdict that these findings are, of a list of simplices or of a part of one.
Verdict verdict_of_findings(const definition::ListedComplex& listed, const Findings& found,
                            const ComplexDemands& demands, std::size_t max_violations);

}  // namespace circumspect::check
