#include "oracle/judge/judge_domain_quickly.hpp"

#include <algorithm>
#include <cstdint>
#include <thread>
#include <utility>
#include <variant>

#include "oracle/judge/fast/judge.hpp"
#include "oracle/judge/fast/volume.hpp"
#include "oracle/judge/mesh_of_doubles.hpp"

namespace circumspect::check {
namespace {

template <std::size_t kDimension>
std::optional<KnownVolume> known_of(const formats::FlatMesh& mesh, bool balls, bool oriented,
                                    bool hull, unsigned threads) {
  const auto& rows = std::get<formats::FlatRows<std::int32_t>>(mesh.simplices);
  if (rows.columns() != kDimension + 1) return std::nullopt;
  fast::MeshView<kDimension, std::int32_t> view{
      mesh.points.coordinates.values(), {}, rows.values()};
  auto volume = fast::volume(view, balls, threads);
  if (!volume || (oriented && !volume->oriented)) return std::nullopt;
  KnownVolume known{.boundary = std::move(volume->boundary),
                    .not_local = std::move(volume->not_local),
                    .ties = std::move(volume->ties),
                    .not_canonical = std::move(volume->not_canonical)};
  if (hull) {
    view.neighbors = volume->links.view();
    known.fills_hull = fast::judge(view, fast::Question::kTriangulation, threads).has_value();
  }
  return known;
}

}  // namespace

std::optional<KnownVolume> known_volume(Claim claim, const Mesh& mesh, const Domain& domain,
                                        const Options& options, unsigned threads) {
  if (options.by != By::kLemma || mesh.simplices.empty()) return std::nullopt;
  const std::optional<formats::FlatMesh> doubles = mesh_of_doubles(mesh);
  if (!doubles) return std::nullopt;
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  const bool balls = is_about_balls(claim);
  const bool hull = domain.complex.kind == DomainKind::kHull;
  if (doubles->dimension() == 2) {
    return known_of<2>(*doubles, balls, options.oriented, hull, threads);
  }
  return known_of<3>(*doubles, balls, options.oriented, hull, threads);
}

Verdict judge_domain_quickly(Claim claim, const Mesh& mesh, const Domain& domain,
                             const Options& options, unsigned threads) {
  const auto known = known_volume(claim, mesh, domain, options, threads);
  return judge_domain(claim, mesh, domain, options, known ? &*known : nullptr);
}

}  // namespace circumspect::check
