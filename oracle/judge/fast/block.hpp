// Simplices side by side, so that vector instructions look at several of them at a time.
//
// The arithmetic is that of filter.hpp, inlined into loops over lanes that a compiler vectorizes:
// exactly the operations for which the bounds are proved, in the same order, each rounded by itself
// (law F5 of predicates.hpp; block_test.cpp compares every bit). Only the width of the instructions
// depends on the machine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "oracle/judge/fast/predicates/lattice.hpp"
#include "oracle/judge/fast/predicates/site.hpp"

namespace circumspect::fast {

// One phase of the sweep prefetches what the next one needs.
inline constexpr std::size_t kBlock = 32;

template <typename T>
using Lanes = std::array<T, kBlock>;

template <std::size_t kDimension>
struct SiteLanes {
  std::array<Lanes<double>, kDimension> at{};
  Lanes<double> weight{};

  [[gnu::always_inline]] Site<kDimension> site(std::size_t lane) const {
    Site<kDimension> site;
    for (std::size_t axis = 0; axis < kDimension; ++axis) site.at[axis] = at[axis][lane];
    site.weight = weight[lane];
    return site;
  }
};

template <std::size_t kDimension>
struct alignas(64) SimplexBlock {
  static constexpr std::size_t kVertices = kDimension + 1;

  std::array<SiteLanes<kDimension>, kVertices> vertices{};
  std::array<SiteLanes<kDimension>, kVertices> apexes{};  // across the facet opposite each vertex
  Lanes<std::int64_t> own{};                              // the orientation that is expected
  std::array<double, kDimension> low{}, high{};           // the box of the sample point

  // Set by `simplices`: the contents of SimplexFilter for each; …
  std::array<Lanes<double>, kDimension + 1> cofactors{};
  std::array<Lanes<double>, kDimension + 1> scales{};
  Lanes<std::int64_t> orientation{};  // a sign or kUncertain
  Lanes<std::int64_t> apart{};        // 1 if that box does not touch the simplex's
  bool as_expected = false;           // all have this orientation, and are apart
  // … set by `balls`: −1, 0, 1 or kUncertain, as Ball::contains; meaningless where there is no
  // apex.
  std::array<Lanes<std::int64_t>, kVertices> inside{};

  SiteRow<kDimension> row(std::size_t lane) const {
    SiteRow<kDimension> row;
    for (std::size_t i = 0; i < kVertices; ++i) row[i] = vertices[i].site(lane);
    return row;
  }
};

// Rows of simplices, and of those across their facets.
template <std::size_t kVertices, typename Index>
struct alignas(64) RowBlock {
  std::array<Lanes<Index>, kVertices> rows{};
  std::array<std::array<Lanes<Index>, kVertices>, kVertices> beyond{};  // opposite each vertex
  std::array<Lanes<Index>, kVertices> apex{};  // by `fit`: the vertex of that off the facet
  // Set by `fit`: −1 if the facet is not shared, else the place of that vertex, plus kOdd if the
  // permutation is odd (facet_across.hpp).
  std::array<Lanes<Index>, kVertices> fits{};

  static constexpr Index kOdd = 4;
};

// The loops, compiled for one width of vectors.
template <std::size_t kDimension>
struct BlockKernels {
  const char* name;
  // Cofactors and everything else that depends on the simplices alone; `weighted`: heights with
  // weights.
  void (*simplices)(SimplexBlock<kDimension>&, bool weighted, Lattice);
  void (*balls)(SimplexBlock<kDimension>&, bool weighted, Lattice);
  void (*fit_32)(RowBlock<kDimension + 1, std::int32_t>&);
  void (*fit_64)(RowBlock<kDimension + 1, std::int64_t>&);

  void fit(RowBlock<kDimension + 1, std::int32_t>& block) const { fit_32(block); }
  void fit(RowBlock<kDimension + 1, std::int64_t>& block) const { fit_64(block); }
};

// The versions that run on this machine, the widest first. All give the same results.
template <std::size_t kDimension>
std::span<const BlockKernels<kDimension>> block_kernels();

extern template std::span<const BlockKernels<2>> block_kernels();
extern template std::span<const BlockKernels<3>> block_kernels();

}  // namespace circumspect::fast
