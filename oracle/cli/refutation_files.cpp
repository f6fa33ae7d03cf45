#include "oracle/cli/refutation_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "oracle/cli/output.hpp"
#include "reference/existence/dimacs.hpp"

namespace circumspect::cli {
namespace {

std::vector<std::string> meaning_of_variables(const Domain& domain,
                                              const std::vector<Simplex>& candidates) {
  std::vector<std::string> comments;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    std::vector<Vertex> labels;
    for (const Vertex v : candidates[i]) labels.push_back(domain.label(v));
    comments.push_back(fmt::format("{}: tetrahedron {}", i + 1, fmt::join(labels, " ")));
  }
  return comments;
}

std::string write(const std::string& path, const Domain& domain,
                  const existence::Impossible& impossible) {
  const std::string error = write_file(path + ".cnf", [&](std::ostream& out) {
    out << existence::to_dimacs(impossible.formula,
                                meaning_of_variables(domain, impossible.candidates));
  });
  if (!error.empty()) return error;
  return write_file(path + ".drat",
                    [&](std::ostream& out) { out << existence::to_text(impossible.refutation); });
}

}  // namespace

std::string write_refutations(const std::string& prefix, const Domain& domain,
                              const DomainFacts& facts) {
  std::string error;
  if (facts.no_cdt) error = write(prefix + "-cdt", domain, *facts.no_cdt);
  if (error.empty() && facts.no_triangulation) {
    error = write(prefix + "-triangulation", domain, *facts.no_triangulation);
  }
  return error;
}

}  // namespace circumspect::cli
