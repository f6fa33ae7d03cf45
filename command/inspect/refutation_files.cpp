#include "command/inspect/refutation_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command/output/output.hpp"
#include "reference/existence/dimacs.hpp"
#include "reference/existence/refutation.hpp"

namespace circumspect::cli {
namespace {

constexpr const char* kNoCdt = "-cdt";
constexpr const char* kNoTriangulation = "-triangulation";
constexpr const char* kFormula = ".cnf";
constexpr const char* kRefutation = ".drat";

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
  const std::string error = write_file(path + kFormula, [&](std::ostream& out) {
    out << existence::to_dimacs(impossible.formula,
                                meaning_of_variables(domain, impossible.candidates));
  });
  if (!error.empty()) return error;
  return write_file(path + kRefutation,
                    [&](std::ostream& out) { out << existence::to_text(impossible.refutation); });
}

}  // namespace

std::vector<std::string> refutation_files(const std::string& prefix) {
  std::vector<std::string> paths;
  for (const char* const what : {kNoCdt, kNoTriangulation}) {
    for (const char* const extension : {kFormula, kRefutation}) {
      paths.push_back(prefix + what + extension);
    }
  }
  return paths;
}

std::string write_refutations(const std::string& prefix, const Domain& domain,
                              const DomainFacts& facts) {
  std::string error;
  if (facts.no_cdt) error = write(prefix + kNoCdt, domain, *facts.no_cdt);
  if (error.empty() && facts.no_triangulation) {
    error = write(prefix + kNoTriangulation, domain, *facts.no_triangulation);
  }
  return error;
}

}  // namespace circumspect::cli
