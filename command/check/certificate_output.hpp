// Writes the certificate or the refutation that proves a verdict.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/input/domain_input.hpp"
#include "command/options/domain_options.hpp"
#include "command/output/output.hpp"
#include "oracle/model/claim.hpp"
#include "oracle/model/exact_mesh.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/verdict.hpp"

namespace circumspect::cli {

// Writes the certificate or the refutation to `path`, "-" being stdout. If there is none, or it
// cannot be written, says so on stderr and in the exit code. True if it was written.
bool write_certificate(const std::string& path, const std::string& mesh_name, const Mesh& mesh,
                       const Verdict& verdict, Output& output);

// The same for a claim about a domain.
bool write_domain_certificate(const std::string& path, const std::string& mesh_name,
                              const ExactMesh& mesh, const LoadedDomain& loaded,
                              const Verdict& verdict, Output& output);

// What a certificate cannot be about; empty if there is nothing of it.
std::string certificate_fault(const std::optional<Claim>& claim, const DomainOptions& said);

// The files in which circumspect-verified reads that a domain has no CDT, and no triangulation.
std::vector<std::string> impossibility_files(const std::string& prefix);

// Writes that a domain in space has no CDT or, if the claim is plc-triangulation, no triangulation
// at all; and a note if there is nothing to write: what is proved of every triangulation may not
// suffice. Returns what is wrong with the file, or an empty string.
std::string write_impossibility(const std::string& prefix, Claim claim, const LoadedDomain& loaded,
                                Output& output);

}  // namespace circumspect::cli
