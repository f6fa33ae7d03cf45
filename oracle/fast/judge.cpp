#include "oracle/fast/judge.hpp"

#include <atomic>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "oracle/fast/boundary.hpp"
#include "oracle/fast/facet_matching.hpp"
#include "oracle/fast/in_chunks.hpp"
#include "oracle/fast/submerged_points.hpp"
#include "oracle/fast/sweep.hpp"

namespace circumspect::fast {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 15;

bool all_finite(std::span<const double> numbers, unsigned threads) {
  std::atomic<bool> finite = true;
  in_chunks(numbers.size(), kChunk, threads, [&](std::size_t, std::size_t first, std::size_t last) {
    // The sum of the products with 0 is 0, unless one of them is NaN: no branch.
    double sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += numbers[i] * 0;
    if (sum != 0) finite.store(false, std::memory_order_relaxed);
  });
  return finite.load(std::memory_order_relaxed);
}

template <std::size_t kDimension, typename Index, typename Link>
class Judge {
 public:
  Judge(const MeshView<kDimension, Index>& mesh, Links<Link> links, Question question,
        unsigned threads)
      : mesh_(mesh),
        links_(links),
        balls_(question != Question::kTriangulation),
        weighted_(question == Question::kWeightedDelaunay && !mesh.weights.empty()),
        threads_(threads),
        used_(mesh.points()) {}

  tl::expected<Facts, Undecided> run() {
    Stages stages;
    const auto sample = sample_point(mesh_, stages);
    if (!sample) return tl::unexpected(Undecided::kNoSamplePoint);
    Orientations orientations(orientation_of(sample->simplex, stages));
    Swept swept = swept_by_all(orientations, *sample);
    if (swept.mixed) {
      auto each = orientation_of_each();
      if (!each) return tl::unexpected(each.error());
      orientations = Orientations(std::move(*each));
      swept = swept_by_all(orientations, *sample);
    }
    if (!swept.undecided && swept.up != swept.down) {
      swept.undecided = Undecided::kUnmatchedNeighbor;
    }
    if (!swept.undecided) judge_boundary(orientations, sample->site, swept);
    if (!swept.undecided) judge_unused_points(orientations, swept);
    if (swept.undecided) return tl::unexpected(*swept.undecided);
    return Facts{swept.unique, swept.canonical, orientations.are_equal(),
                 sum(stages, swept.stages)};
  }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  // Requires: the simplex names points.
  int orientation_of(std::size_t s, Stages& stages) const {
    SiteRow<kDimension> row;
    for (std::size_t i = 0; i < kVertices; ++i) {
      row[i] = mesh_.template site<false>(mesh_.row(s)[i]);
    }
    return orientation<kDimension>(row, stages);
  }

  tl::expected<std::vector<std::uint64_t>, Undecided> orientation_of_each() const {
    constexpr std::size_t kBits = 64;
    std::vector<std::uint64_t> negative(chunks_of(mesh_.size(), kBits), 0);
    std::vector<std::optional<Undecided>> found(chunks_of(negative.size(), kChunk / kBits));
    in_chunks(negative.size(), kChunk / kBits, threads_,
              [&](std::size_t chunk, std::size_t first, std::size_t last) {
                Stages stages;  // every sign is asked for again
                for (std::size_t s = first * kBits; s < std::min(last * kBits, mesh_.size()); ++s) {
                  for (const Index v : mesh_.row(s)) {
                    if (!mesh_.names_point(v)) found[chunk] = Undecided::kUnknownVertex;
                  }
                  if (found[chunk]) return;
                  const bool is_negative = orientation_of(s, stages) < 0;
                  negative[s / kBits] |= std::uint64_t{is_negative} << (s % kBits);
                }
              });
    for (const std::optional<Undecided>& reason : found) {
      if (reason) return tl::unexpected(*reason);
    }
    return negative;
  }

  Swept swept_by_all(const Orientations& orientations, const SamplePoint<kDimension>& sample) {
    const SweepTask<kDimension, Index, Link> task{mesh_,  links_,    orientations, sample,
                                                  balls_, weighted_, used_};
    std::vector<Swept> parts(chunks_of(mesh_.size(), kChunk));
    in_chunks(mesh_.size(), kChunk, threads_,
              [&](std::size_t chunk, std::size_t first, std::size_t last) {
                parts[chunk] = sweep(task, first, last);
              });
    Swept all;
    boundary_.clear();
    for (Swept& part : parts) {
      all.append(part);
      boundary_.push_back(std::move(part.boundary));
    }
    return all;
  }

  void judge_boundary(const Orientations& orientations, const Site<kDimension>& sample,
                      Swept& swept) const {
    const Boundary<kDimension, Index, Link> boundary(mesh_, links_, orientations, sample);
    std::vector<Swept> parts(boundary_.size());
    in_chunks(parts.size(), 1, threads_, [&](std::size_t chunk, std::size_t, std::size_t) {
      Swept& part = parts[chunk];
      for (const std::uint64_t facet : boundary_[chunk]) {
        part.undecided = boundary.judge(facet / kVertices, facet % kVertices, part.stages);
        if (part.undecided) return;
      }
    });
    for (const Swept& part : parts) swept.append(part);
  }

  void judge_unused_points(const Orientations& orientations, Swept& swept) const {
    const std::vector<std::size_t> unused = used_.missing();
    if (unused.empty()) return;
    swept.undecided = Undecided::kUnusedPoint;
    if (!weighted_) return;
    const SubmergedPoints<kDimension, Index, Link> points(mesh_, links_, orientations);
    swept.undecided = points.judge(unused, swept);
  }

  const MeshView<kDimension, Index>& mesh_;
  Links<Link> links_;
  bool balls_;
  bool weighted_;
  unsigned threads_;
  UsedPoints used_;
  // Of each chunk of simplices, as the sweep lists them.
  std::vector<std::vector<std::uint64_t>> boundary_ = {};
};

}  // namespace

template <std::size_t kDimension, typename Index>
tl::expected<Facts, Undecided> judge(const MeshView<kDimension, Index>& mesh, Question question,
                                     unsigned threads) {
  if (mesh.size() == 0) return tl::unexpected(Undecided::kEmpty);
  if (!all_finite(mesh.coordinates, threads) || !all_finite(mesh.weights, threads)) {
    return tl::unexpected(Undecided::kNotFinite);
  }
  if (!mesh.neighbors.empty()) {
    return Judge<kDimension, Index, Index>(mesh, mesh.neighbors, question, threads).run();
  }
  const auto links = matched_facets(mesh, threads);
  if (!links) return tl::unexpected(links.error());
  return Judge<kDimension, Index, std::int32_t>(mesh, links->view(), question, threads).run();
}

template tl::expected<Facts, Undecided> judge(const MeshView<2, std::int32_t>&, Question, unsigned);
template tl::expected<Facts, Undecided> judge(const MeshView<2, std::int64_t>&, Question, unsigned);
template tl::expected<Facts, Undecided> judge(const MeshView<3, std::int32_t>&, Question, unsigned);
template tl::expected<Facts, Undecided> judge(const MeshView<3, std::int64_t>&, Question, unsigned);

}  // namespace circumspect::fast
