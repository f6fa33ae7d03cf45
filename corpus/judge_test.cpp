// Every mesh with its points beside it that the corpus has, by the one judge and by the exact checkers alone:
// the same word for word; and the fast engine decides where a claim holds, or only facets are not locally
// Delaunay.
#include "oracle/judge/judge.hpp"

#include <algorithm>
#include <filesystem>

#include <doctest/doctest.h>

#include "oracle/formats/mesh_files.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::corpus {
namespace {

namespace fs = std::filesystem;

// The files with simplices of a folder and those below, in order.
std::vector<std::string> meshes_below(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(CIRCUMSPECT_CORPUS_DIR + folder)) {
    if (entry.path().extension() == ".ele") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

// Is all that is wrong that some facets are not locally Delaunay?
bool is_about_facets(const Verdict& verdict) {
  return std::all_of(verdict.tallies().begin(), verdict.tallies().end(), [](const auto& tally) {
    return tally.first == Rule::kFacetNotLocal || tally.first == Rule::kVertexSubmerged;
  });
}

std::string text_of(const Verdict& verdict, const Mesh& mesh) {
  return report::verdict_line(verdict, mesh, "m") + report::explanation(verdict, mesh) +
         report::verdict(verdict, mesh, "m", check::By::kLemma).dump();
}

// Judges a mesh in both ways; true if the fast engine decided.
bool compare(formats::MeshRequest request, Claim claim, const check::Options& options) {
  if (claim == Claim::kWeightedDelaunay) request.weights = formats::Weights::kDemanded;
  const auto file = formats::read_mesh(request, 2);
  if (!file) return false;
  const Mesh& mesh = file->mesh;
  const auto verdict = check::judge(claim, mesh, nullptr, options);
  if (!verdict) return false;
  const Verdict slow = check::judge_points(claim, exact(mesh), options);
  CHECK(text_of(*verdict, mesh) == text_of(slow, mesh));
  if (verdict->course.fast) return true;
  const bool are_doubles = std::holds_alternative<Rows<double>>(mesh.coordinates) &&
                           std::holds_alternative<Rows<double>>(mesh.weights);
  const auto ambient = static_cast<int>(mesh.dimension());
  const bool in_scope = are_doubles && ambient == slow.dimension && (ambient == 2 || ambient == 3);
  const bool has_unused_points = claim == Claim::kWeightedDelaunay;
  CHECK(!(in_scope && is_about_facets(slow) && (slow.holds() || !has_unused_points)));
  return false;
}

constexpr std::size_t kOneMeshIn = properties::kOneInputIn > 1 ? 4 : 1;

}  // namespace

TEST_CASE(
    "the verdict of the judge is that of the exact checkers, and is found fast where it holds") {
  std::size_t verdicts = 0;
  std::size_t meshes = 0;
  for (const std::string folder : {"/accept", "/reject", "/peers", "/regressions", "/findings"}) {
    for (const std::string& path : meshes_below(folder)) {
      if (meshes++ % kOneMeshIn != 0) continue;
      CAPTURE(path);
      for (const Claim claim :
           {Claim::kTriangulation, Claim::kDelaunay, Claim::kWeightedDelaunay}) {
        verdicts += compare({.mesh = path}, claim, {}) ? 1 : 0;
        verdicts += compare({.mesh = path}, claim, {.oriented = true}) ? 1 : 0;
      }
      const formats::MeshRequest request{.mesh = path, .with_neighbors = true};
      verdicts += compare(request, Claim::kDelaunay, {}) ? 1 : 0;
    }
  }
  CHECK(verdicts > 100 / kOneMeshIn);
}

}  // namespace circumspect::corpus
