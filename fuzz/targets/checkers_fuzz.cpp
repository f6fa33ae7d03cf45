// The checkers by lemma and by definition agree, on right meshes and on broken ones. Book:
// Definitions 2.1 and 4.1, Lemma 4.1. Input: a byte with dimension and weights, nine that break the
// mesh in up to three ways, then points.
#include "fuzz/targets/fuzz_bytes.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "oracle/judge/points/delaunay.hpp"
#include "reference/delaunay/bowyer_watson.hpp"

namespace circumspect::fuzz {
namespace {

constexpr std::size_t kHead = 10;
constexpr std::size_t kMostPoints = 12;

void hold_checkers_equal(Bytes bytes) {
  const Input<kHead> input(bytes, kMostPoints);
  if (input.points.size() == 0) return;
  ExactMesh mesh = arrays::exact_mesh_of(input.points, {}, input.is_weighted());
  mesh.simplices = delaunay::bowyer_watson(mesh.points).simplices();
  const Claim delaunay = input.is_weighted() ? Claim::kWeightedDelaunay : Claim::kDelaunay;
  if (!check::judge_points(delaunay, mesh).holds()) {
    fail("a right mesh is rejected", input.points, mesh.simplices);
  }
  for (std::size_t i = 1; i < kHead; i += 3) {
    alter(mesh.simplices, mesh.points.size(), Bytes(input.head).subspan(i, 3));
  }
  for (const Claim claim : {Claim::kTriangulation, delaunay}) {
    const Verdict lemma = check::judge_points(claim, mesh);
    const Verdict definition =
        check::judge_exactly(claim, mesh, nullptr, {.by = check::By::kDefinition});
    if (lemma.holds() != definition.holds()) {
      fail(std::string(name(claim)) + ": lemma and definition differ", input.points,
           mesh.simplices);
    }
    if (lemma.unique != definition.unique || lemma.canonical != definition.canonical) {
      fail(std::string(name(claim)) + ": lemma and definition know other facts", input.points,
           mesh.simplices);
    }
  }
}

}  // namespace
}  // namespace circumspect::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  circumspect::fuzz::hold_checkers_equal({data, size});
  return 0;
}
CIRCUMSPECT_MUTATOR(circumspect::fuzz::kHead);
