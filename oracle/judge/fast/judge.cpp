#include "oracle/judge/fast/judge.hpp"

#include <utility>
#include <vector>

#include "oracle/judge/fast/boundary.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/faults.hpp"
#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/fast/submerged_points.hpp"
#include "oracle/judge/fast/sweep.hpp"

namespace circumspect::fast {
namespace {

template <std::size_t kDimension, typename Index, typename Link>
class Judge {
 public:
  Judge(const MeshView<kDimension, Index>& mesh, Links<Link> links, Question question,
        unsigned threads)
      : mesh_(mesh),
        links_(links),
        balls_(question != Question::kTriangulation),
        weighted_(question == Question::kWeightedDelaunay && !mesh.weights.empty()),
        threads_(threads) {}

  // `kept`: where to store the results, except the links, if there is no answer. `overused` facets
  // have no links.
  tl::expected<Facts, Undecided> run(bool overused = false,
                                     std::optional<SweptMesh>* kept = nullptr) {
    Stages stages;
    const auto sample = sample_point(mesh_, stages);
    if (!sample) return tl::unexpected(sample.error());
    WholeSweep<kDimension, Index, Link> sweep(mesh_, links_, threads_);
    Swept swept = sweep.run({.sample = &*sample,
                             .balls = balls_,
                             .weighted = weighted_,
                             .past_doubts = kept != nullptr});
    if (overused && !swept.doubt) swept.doubt = Undecided::kFacetOverused;
    const Orientations& orientations = sweep.orientations();
    std::optional<Undecided> reason = swept.undecided ? swept.undecided : swept.doubt;
    if (!reason) reason = judge_boundary(sweep, *sample, swept.stages);
    const bool is_triangulation = !reason;
    if (is_triangulation) reason = judge_unused_points(sweep.unused(), orientations, swept);
    if (reason) {
      if (kept != nullptr) {
        kept->emplace(
            SweptMesh{{}, std::move(swept), orientations, sweep.unused(), is_triangulation});
      }
      return tl::unexpected(*reason);
    }
    return Facts{swept.unique, swept.canonical, orientations.are_equal(),
                 std::move(swept.not_local), sum(stages, swept.stages)};
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  std::optional<Undecided> judge_boundary(const WholeSweep<kDimension, Index, Link>& sweep,
                                          const SamplePoint<kDimension>& sample,
                                          Stages& stages) const {
    constexpr std::size_t kChunk = WholeSweep<kDimension, Index, Link>::kChunk;
    const Boundary<kDimension, Index, Link> boundary(mesh_, links_, sweep.orientations(), sample,
                                                     sweep.lattice());
    std::vector<Swept> parts(chunks_of(mesh_.size(), kChunk));
    in_chunks(mesh_.size(), kChunk, threads_,
              [&](std::size_t chunk, std::size_t first, std::size_t last) {
                const std::vector<FacetId> facets =
                    sweep.boundary().template facets<kVertices>(links_, first, last);
                parts[chunk].undecided = boundary.judge(facets, parts[chunk].stages);
              });
    Swept all;
    for (const Swept& part : parts) all.append(part);
    stages = sum(stages, all.stages);
    return all.undecided;
  }

  std::optional<Undecided> judge_unused_points(const std::vector<std::size_t>& unused,
                                               const Orientations& orientations,
                                               Swept& swept) const {
    if (unused.empty()) return std::nullopt;
    if (!weighted_) return Undecided::kUnusedPoint;
    // The walks end, and the witness planes are meaningful, if all facets are locally Delaunay.
    if (!swept.not_local.empty()) return Undecided::kFacetNotLocal;
    const SubmergedPoints<kDimension, Index, Link> points(mesh_, links_, orientations);
    return points.judge(unused, swept);
  }

  const MeshView<kDimension, Index>& mesh_;
  Links<Link> links_;
  bool balls_;
  bool weighted_;
  unsigned threads_;
};

}  // namespace

namespace {

template <std::size_t kDimension, typename Index>
bool has_finite_numbers(const MeshView<kDimension, Index>& mesh, unsigned threads) {
  return are_finite(mesh.coordinates, threads) && are_finite(mesh.weights, threads);
}

}  // namespace

template <std::size_t kDimension, typename Index, typename Link>
tl::expected<Facts, Undecided> judge(const MeshView<kDimension, Index>& mesh, Links<Link> neighbors,
                                     Question question, unsigned threads) {
  if (mesh.size() == 0) return tl::unexpected(Undecided::kEmpty);
  if (!has_finite_numbers(mesh, threads)) return tl::unexpected(Undecided::kNotFinite);
  return Judge<kDimension, Index, Link>(mesh, neighbors, question, threads).run();
}

template <std::size_t kDimension, typename Index>
tl::expected<Facts, Undecided> judge(const MeshView<kDimension, Index>& mesh, Question question,
                                     unsigned threads, std::optional<SweptMesh>* swept) {
  if (!mesh.neighbors.empty() || mesh.size() == 0) {
    return judge<kDimension, Index, Index>(mesh, mesh.neighbors, question, threads);
  }
  auto links = matched_facets(mesh, threads, Proposal::kLikely);
  if (!links) return tl::unexpected(links.error());
  const bool overused = !links->overused.empty();
  if (overused && swept == nullptr) return tl::unexpected(Undecided::kFacetOverused);
  if (!has_finite_numbers(mesh, threads)) return tl::unexpected(Undecided::kNotFinite);
  auto facts = Judge<kDimension, Index, std::int32_t>(mesh, links->view(), question, threads)
                   .run(overused, swept);
  if (swept != nullptr && *swept) (*swept)->links = std::move(*links);
  return facts;
}

template tl::expected<Facts, Undecided> judge(const MeshView<2, std::int32_t>&, Question, unsigned,
                                              std::optional<SweptMesh>*);
template tl::expected<Facts, Undecided> judge(const MeshView<2, std::int64_t>&, Question, unsigned,
                                              std::optional<SweptMesh>*);
template tl::expected<Facts, Undecided> judge(const MeshView<3, std::int32_t>&, Question, unsigned,
                                              std::optional<SweptMesh>*);
template tl::expected<Facts, Undecided> judge(const MeshView<3, std::int64_t>&, Question, unsigned,
                                              std::optional<SweptMesh>*);
template tl::expected<Facts, Undecided> judge(const MeshView<2, std::int32_t>&, Links<std::int32_t>,
                                              Question, unsigned);
template tl::expected<Facts, Undecided> judge(const MeshView<3, std::int32_t>&, Links<std::int32_t>,
                                              Question, unsigned);
template tl::expected<Facts, Undecided> judge(const MeshView<2, std::int64_t>&, Links<std::int32_t>,
                                              Question, unsigned);
template tl::expected<Facts, Undecided> judge(const MeshView<3, std::int64_t>&, Links<std::int32_t>,
                                              Question, unsigned);

}  // namespace circumspect::fast
