// The sweep of all simplices of a mesh, by all threads; once more if not all of them are oriented
// alike.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "oracle/judge/fast/in_chunks.hpp"
#include "oracle/judge/fast/row_predicates.hpp"
#include "oracle/judge/fast/sweep.hpp"

namespace circumspect::fast {

// What a sweep is to look at (SweepTask says more of each).
template <std::size_t kDimension>
struct SweepQuestions {
  const SamplePoint<kDimension>* sample = nullptr;
  bool balls = false;
  bool weighted = false;
  bool ties = false;
};

template <std::size_t kDimension, typename Index, typename Link>
class WholeSweep {
 public:
  // How many simplices one thread looks at at a time.
  static constexpr std::size_t kChunk = std::size_t{1} << 12;
  static_assert(kChunk % kBlock == 0);

  WholeSweep(const MeshView<kDimension, Index>& mesh, Links<Link> links, unsigned threads)
      : mesh_(mesh),
        links_(links),
        threads_(threads),
        used_(mesh.points()),
        boundary_(mesh.size()) {}

  // Undecided, or all conditions hold that `sweep` looks at, and every link is verified. Requires:
  // at least one simplex; finite coordinates, and weights if they count.
  Swept run(const SweepQuestions<kDimension>& questions) {
    Stages stages;
    const auto first =
        orientation_of(questions.sample != nullptr ? questions.sample->simplex : 0, stages);
    if (!first) return {.undecided = first.error()};
    orientations_ = Orientations(*first);
    lattice_ = lattice_of_all(mesh_.coordinates,
                              questions.weighted ? mesh_.weights : std::span<const double>());
    Swept swept = swept_by_all(questions);
    if (swept.mixed) {
      auto each = orientation_of_each();
      if (!each) return {.undecided = each.error()};
      orientations_ = Orientations(std::move(*each));
      swept = swept_by_all(questions);
    }
    // Signs are exact, so that no second pass finds one other than expected.
    if (!swept.undecided && (swept.mixed || swept.up != swept.down)) {
      swept.undecided = Undecided::kUnmatchedNeighbor;
    }
    return swept;
  }

  // After run: …
  const Orientations& orientations() const { return orientations_; }
  // … which simplices have boundary facets …
  const BoundarySimplices& boundary() const { return boundary_; }
  // … a lattice that all points lie on, or none …
  Lattice lattice() const { return lattice_; }
  // … and points that are no vertices, ascending.
  std::vector<std::size_t> unused() const { return used_.missing(); }

 private:
  static constexpr std::size_t kVertices = kDimension + 1;

  tl::expected<int, Undecided> orientation_of(std::size_t s, Stages& stages) const {
    SiteRow<kDimension> row;
    for (std::size_t i = 0; i < kVertices; ++i) {
      const Index v = mesh_.row(s)[i];
      if (!mesh_.names_point(v)) return tl::unexpected(Undecided::kUnknownVertex);
      row[i] = mesh_.template site<false>(v);
    }
    const int sign = orientation<kDimension>(row, stages);
    if (sign == 0) return tl::unexpected(Undecided::kFlatSimplex);
    return sign;
  }

  tl::expected<std::vector<std::uint64_t>, Undecided> orientation_of_each() const {
    constexpr std::size_t kBits = 64;
    std::vector<std::uint64_t> negative(chunks_of(mesh_.size(), kBits), 0);
    std::vector<std::optional<Undecided>> found(chunks_of(negative.size(), kChunk / kBits));
    in_chunks(negative.size(), kChunk / kBits, threads_,
              [&](std::size_t chunk, std::size_t first, std::size_t last) {
                Stages stages;  // every sign is asked for again
                for (std::size_t s = first * kBits; s < std::min(last * kBits, mesh_.size()); ++s) {
                  const auto sign = orientation_of(s, stages);
                  if (!sign) {
                    found[chunk] = sign.error();
                    return;
                  }
                  negative[s / kBits] |= std::uint64_t{*sign < 0} << (s % kBits);
                }
              });
    for (const std::optional<Undecided>& reason : found) {
      if (reason) return tl::unexpected(*reason);
    }
    return negative;
  }

  Swept swept_by_all(const SweepQuestions<kDimension>& questions) {
    const SweepTask<kDimension, Index, Link> task{.mesh = mesh_,
                                                  .links = links_,
                                                  .orientations = orientations_,
                                                  .sample = questions.sample,
                                                  .balls = questions.balls,
                                                  .weighted = questions.weighted,
                                                  .ties = questions.ties,
                                                  .lattice = lattice_,
                                                  .used = used_,
                                                  .boundary = boundary_};
    std::vector<Swept> parts(chunks_of(mesh_.size(), kChunk));
    in_chunks(mesh_.size(), kChunk, threads_,
              [&](std::size_t chunk, std::size_t first, std::size_t last) {
                parts[chunk] = sweep(task, first, last);
              });
    Swept all;
    for (const Swept& part : parts) all.append(part);
    return all;
  }

  const MeshView<kDimension, Index>& mesh_;
  Links<Link> links_;
  unsigned threads_;
  Orientations orientations_{1};
  UsedPoints used_;
  BoundarySimplices boundary_;
  Lattice lattice_ = {};
};

}  // namespace circumspect::fast
