#include "command/check/complex_options.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command/options/one_of.hpp"

namespace circumspect::cli {
namespace {

Orientations orientations(const std::string& word) {
  if (word.empty()) return Orientations::kAny;
  if (word == "positive") return Orientations::kPositive;
  return word == "negative" ? Orientations::kNegative : Orientations::kSame;
}

}  // namespace

std::string of_complexes_alone(const ComplexOptions& options) {
  const ComplexDemands& demands = options.demands;
  for (const auto& [is_given, word] : std::initializer_list<std::pair<bool, const char*>>{
           {demands.manifold, "--manifold"},
           {demands.connected, "--connected"},
           {demands.closed, "--closed"},
           {demands.faces, "--faces"},
           {demands.allow_unused, "--allow-unused"},
           {!options.allowed.empty(), "--allow"},
           {options.oriented == "positive", "--oriented=positive"},
           {options.oriented == "negative", "--oriented=negative"}}) {
    if (is_given) return word;
  }
  return "";
}

void add_allow_unused_option(CLI::App& command, bool& allow_unused) {
  command.add_flag("--allow-unused", allow_unused,
                   "With the claim complex: let points pass that no simplex uses");
}

void add_complex_options(CLI::App& command, ComplexOptions& options) {
  command
      .add_flag("--oriented{same}", options.oriented,
                "Also demand that all simplices list their vertices with the same orientation. For "
                "the claim complex, --oriented=positive and --oriented=negative demand a sign of "
                "det[p1-p0; ...; pd-p0]")
      ->check(one_of_words({"same", "positive", "negative"}))
      ->multi_option_policy(CLI::MultiOptionPolicy::Join)  // a line each
      ->option_text("[=same|positive|negative]");
  ComplexDemands& demands = options.demands;
  command.add_flag("--manifold", demands.manifold,
                   "With the claim complex: demand that the mesh is a manifold with boundary");
  command.add_flag("--connected", demands.connected,
                   "With the claim complex: demand that facets connect all simplices");
  command.add_flag("--closed", demands.closed,
                   "With the claim complex, of a surface or of edges: demand that no facet is in "
                   "one simplex only");
  command.add_flag(
      "--faces", demands.faces,
      "With the claim complex: demand that the triangles and edges that the file lists "
      "beside the simplices (of .ele the .face and the .edge file) are faces of them");
  command
      .add_option("--allow", options.allowed,
                  "With the claim complex: count hanging vertices, and let them pass")
      ->check(one_of_words({"hanging-vertex"}))
      ->option_text("hanging-vertex");
  add_allow_unused_option(command, demands.allow_unused);
}

std::string settle_complex_options(const ComplexOptions& options, std::optional<Claim> claim,
                                   check::Options& check) {
  check.complex = options.demands;
  if (options.oriented.find('\n') != std::string::npos) {
    return "expected --oriented once, found it several times: no simplex has two orientations";
  }
  check.complex.oriented = orientations(options.oriented);
  check.complex.allow_hanging = !options.allowed.empty();
  if (claim != Claim::kComplex) {
    check.oriented = !options.oriented.empty();
    const std::string word = of_complexes_alone(options);
    if (word.empty()) return "";
    return fmt::format("expected --claim complex beside {}, found {}", word,
                       claim ? name(*claim) : "none");
  }
  if (check.complex.allow_hanging && options.demands.closed) {
    return "expected one of --closed and --allow hanging-vertex, found both: around a hanging "
           "vertex facets are in one simplex only";
  }
  return "";
}

}  // namespace circumspect::cli
