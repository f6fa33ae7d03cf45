// The fast judge on every mesh of the corpus: what it says is what the slow one says, and it speaks up
// where the claim holds.
#include "oracle/check/flat/judge_flat.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include <doctest/doctest.h>

#include "oracle/formats/mesh_files.hpp"

namespace circumspect::check {
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

// As the command makes one; none if there are equal points.
std::optional<Mesh> mesh_of(const formats::RawMesh& raw, Claim claim) {
  if (!duplicates(raw.points.points).empty()) return std::nullopt;
  std::vector<Rational> weights;
  for (const std::vector<Rational>& row : raw.points.attributes) {
    if (claim == Claim::kWeightedDelaunay) weights.push_back(row.front());
  }
  Mesh mesh{PointSet(raw.points.points, weights), raw.simplices.simplices};
  if (raw.neighbors)
    mesh.neighbors = Neighbors{raw.neighbors->neighbors, raw.neighbors->first_index};
  return mesh;
}

// In no simplex of these, which have few or lie far away, is there a double for an interior point.
const std::set<std::string> kWithoutInteriorPoint = {"far-from-origin.ele",
                                                     "hunted-tetgen-covered-twice-3d.ele"};

// Judges a mesh fast and slowly; true if there is a fast verdict.
bool compare(const formats::MeshRequest& request, Claim claim, const Options& options) {
  const auto flat = formats::read_flat_mesh(request);
  if (!flat) return false;
  const std::optional<Verdict> fast = judge_flat(claim, *flat, options, 2);
  if (claim == Claim::kWeightedDelaunay && flat->points.weights.rows() == 0) {
    CHECK(!fast);
    return false;
  }
  const auto raw = formats::read_mesh(request);
  REQUIRE(raw.has_value());
  const std::optional<Mesh> mesh = mesh_of(*raw, claim);
  if (!mesh) {
    CHECK(!fast);
    return false;
  }
  const Verdict slow = judge(claim, *mesh, options);
  if (!fast) {
    const auto ambient = static_cast<int>(mesh->points.ambient_dimension());
    const bool in_scope = ambient == slow.dimension && (ambient == 2 || ambient == 3);
    const bool is_known = kWithoutInteriorPoint.contains(fs::path(request.mesh).filename());
    CHECK(!(slow.holds() && in_scope && !is_known));
    return false;
  }
  CHECK(fast->holds());
  CHECK(slow.holds());
  CHECK(fast->claim() == slow.claim());
  CHECK(fast->points == slow.points);
  CHECK(fast->simplices == slow.simplices);
  CHECK(fast->dimension == slow.dimension);
  CHECK(fast->unique == slow.unique);
  CHECK(fast->canonical == slow.canonical);
  return true;
}

}  // namespace

TEST_CASE("the corpus: a fast verdict is the slow one, and there is one where the claim holds") {
  std::size_t verdicts = 0;
  for (const std::string folder : {"/accept", "/reject", "/peers", "/regressions", "/findings"}) {
    for (const std::string& path : meshes_below(folder)) {
      CAPTURE(path);
      for (const Claim claim :
           {Claim::kTriangulation, Claim::kDelaunay, Claim::kWeightedDelaunay}) {
        verdicts += compare({path}, claim, {}) ? 1 : 0;
        verdicts += compare({path}, claim, {.oriented = true}) ? 1 : 0;
      }
      formats::MeshRequest request{path};
      request.with_neighbors = true;
      verdicts += compare(request, Claim::kDelaunay, {}) ? 1 : 0;
    }
  }
  CHECK(verdicts > 100);
}

TEST_CASE("no fast verdict by definition, about a domain, or beyond space") {
  const std::string path = meshes_below("/accept").front();
  const auto flat = formats::read_flat_mesh({path});
  REQUIRE(flat);
  CHECK(!judge_flat(Claim::kDelaunay, *flat, {.by = By::kDefinition}));
  CHECK(!judge_flat(Claim::kCdt, *flat));
  CHECK(!judge_flat(Claim::kDelaunay, formats::FlatMesh{}));
}

}  // namespace circumspect::check
