// Proofs that a domain has no triangulation, as files.
#pragma once

#include <string>
#include <vector>

#include "command/inspect/domain_facts.hpp"
#include "oracle/model/domain.hpp"

namespace circumspect::cli {

// The files that write_refutations may write.
std::vector<std::string> refutation_files(const std::string& prefix);

// Writes PREFIX-cdt.cnf and .drat if it is proved that there is no CDT, and
// PREFIX-triangulation.cnf and .drat if there is no triangulation at all. A formula says in
// comments which tetrahedron each variable is. Returns an error message, or an empty string.
std::string write_refutations(const std::string& prefix, const Domain& domain,
                              const DomainFacts& facts);

}  // namespace circumspect::cli
