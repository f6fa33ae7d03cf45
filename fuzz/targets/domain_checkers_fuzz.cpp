// The checkers of claims about a domain agree by lemma and by definition, on CDTs and on broken
// meshes. Book: Definitions 4.3 to 4.7, Lemma 4.10. Input: a byte with dimension and kind (bit 2:
// the hull), nine that break the mesh, twelve that make up to six segments in the plane or four
// triangles in space, then points.
#include "fuzz/targets/fuzz_bytes.hpp"
#include "kernel/piecewise_linear/validity.hpp"
#include "oracle/judge/domain/judge_domain.hpp"
#include "oracle/judge/domain/judge_exactly.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"

namespace circumspect::fuzz {
namespace {

constexpr std::size_t kMesh = 1, kCells = 10, kHead = 22;
constexpr std::size_t kMostPoints = 8;

using DomainInput = Input<kHead>;

// A cell of two equal vertices is left out; so a head of zeros has none.
PiecewiseLinearInput domain_of(const DomainInput& input, const PointSet& points) {
  PiecewiseLinearInput domain;
  domain.points = points.points();
  domain.kind = (input.head[0] & 4) != 0 ? DomainKind::kHull : DomainKind::kEnclosed;
  const std::size_t d = points.ambient_dimension();
  for (std::size_t at = kCells; at + d <= kHead; at += d) {
    std::vector<Vertex> cell;
    for (std::size_t i = 0; i < d; ++i) {
      cell.push_back(static_cast<Vertex>(input.head[at + i] % points.size()));
    }
    const Simplex unequal = sorted(cell);
    if (std::adjacent_find(unequal.begin(), unequal.end()) != unequal.end()) continue;
    if (d == 2) {
      domain.segments.push_back(cell);
    } else {
      domain.polygons.push_back({{cell}, {}});
    }
  }
  return domain;
}

std::optional<constrained::PlcTriangulation> cdt_of(const PiecewiseLinearComplex& complex) {
  if (complex.ambient_dimension() == 2) return constrained::planar_cdt(complex);
  auto cdt = constrained::gift_wrapping_cdt(complex);
  if (!cdt) return std::nullopt;
  return *std::move(cdt);
}

void hold_checkers_equal(Bytes bytes) {
  const DomainInput input(bytes, kMostPoints);
  if (input.points.size() < 3) return;
  const PointSet points = arrays::exact_mesh_of(input.points, {}).points;
  if (points.dimension() < static_cast<int>(points.ambient_dimension())) return;
  const auto complex = validated(domain_of(input, points), 1);
  if (!complex) return;
  const auto cdt = cdt_of(*complex);
  if (!cdt || cdt->simplices.empty()) return;
  ExactMesh mesh{points, cdt->simplices};
  for (const Simplex& simplex : cdt->dangling) {
    if (simplex.size() > 1) mesh.faces.push_back(simplex);
  }
  const Domain domain{*complex};
  if (!check::judge_domain(Claim::kCdt, mesh, domain).holds()) {
    fail("a right CDT is rejected", input.points, mesh.simplices);
  }
  for (std::size_t i = kMesh; i < kCells; i += 3) {
    alter(mesh.simplices, points.size(), Bytes(input.head).subspan(i, 3));
  }
  for (const Claim claim : {Claim::kPlcTriangulation, Claim::kSteinerTriangulation, Claim::kCdt,
                            Claim::kSteinerCdt, Claim::kConformingDelaunay}) {
    const auto holds_by = [&](check::By by) {
      return check::judge_exactly(claim, mesh, &domain, {.by = by}).holds();
    };
    if (holds_by(check::By::kLemma) != holds_by(check::By::kDefinition)) {
      fail(std::string(name(claim)) + ": lemma and definition differ", input.points,
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
