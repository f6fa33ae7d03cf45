#include "oracle/judge/fast/block.hpp"

#include <span>

#include "oracle/judge/fast/facet_records.hpp"
#include "oracle/judge/fast/predicates/filter.hpp"

// Each loop is written once, as a function that is always inlined, and compiled for several widths
// by functions that only call it.
namespace circumspect::fast {
namespace {

[[gnu::always_inline]] inline void store(SimplexBlock<2>& block, std::size_t lane,
                                         const SimplexFilter<2>& filter) {
  block.cofactors[0][lane] = filter.cofactors.xy;
  block.cofactors[1][lane] = filter.cofactors.xw;
  block.cofactors[2][lane] = filter.cofactors.yw;
  block.scales[0][lane] = filter.scale.x;
  block.scales[1][lane] = filter.scale.y;
  block.scales[2][lane] = filter.scale.weight;
}
[[gnu::always_inline]] inline void store(SimplexBlock<3>& block, std::size_t lane,
                                         const SimplexFilter<3>& filter) {
  block.cofactors[0][lane] = filter.cofactors.xyz;
  block.cofactors[1][lane] = filter.cofactors.xyw;
  block.cofactors[2][lane] = filter.cofactors.xzw;
  block.cofactors[3][lane] = filter.cofactors.yzw;
  block.scales[0][lane] = filter.scale.x;
  block.scales[1][lane] = filter.scale.y;
  block.scales[2][lane] = filter.scale.z;
  block.scales[3][lane] = filter.scale.weight;
}

[[gnu::always_inline]] inline SimplexFilter<2> loaded(const SimplexBlock<2>& block,
                                                      std::size_t lane) {
  return {{block.scales[0][lane], block.scales[1][lane], block.scales[2][lane]},
          {block.cofactors[0][lane], block.cofactors[1][lane], block.cofactors[2][lane]}};
}
[[gnu::always_inline]] inline SimplexFilter<3> loaded(const SimplexBlock<3>& block,
                                                      std::size_t lane) {
  return {
      {block.scales[0][lane], block.scales[1][lane], block.scales[2][lane], block.scales[3][lane]},
      {block.cofactors[0][lane], block.cofactors[1][lane], block.cofactors[2][lane],
       block.cofactors[3][lane]}};
}

template <bool kWeighted>
[[gnu::always_inline]] inline SimplexFilter<2> filter_of(const SimplexBlock<2>& block,
                                                         std::size_t lane) {
  const auto& v = block.vertices;
  return simplex_filter<kWeighted>(v[0].site(lane), v[1].site(lane), v[2].site(lane));
}
template <bool kWeighted>
[[gnu::always_inline]] inline SimplexFilter<3> filter_of(const SimplexBlock<3>& block,
                                                         std::size_t lane) {
  const auto& v = block.vertices;
  return simplex_filter<kWeighted>(v[0].site(lane), v[1].site(lane), v[2].site(lane),
                                   v[3].site(lane));
}

template <std::size_t kDimension>
[[gnu::always_inline]] inline bool is_apart(const SimplexBlock<kDimension>& block,
                                            std::size_t lane) {
  bool apart = false;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    double least = block.vertices[0].at[axis][lane], greatest = least;
    for (std::size_t i = 1; i <= kDimension; ++i) {
      const double x = block.vertices[i].at[axis][lane];
      least = x < least ? x : least;
      greatest = x > greatest ? x : greatest;
    }
    const double low = block.low[axis], high = block.high[axis];
    const bool below = high < least;
    const bool above = low > greatest;
    apart |= below | above;
  }
  return apart;
}

template <bool kWeighted, std::size_t kDimension>
[[gnu::always_inline]] inline void simplices_of(SimplexBlock<kDimension>& block, Lattice lattice) {
  std::int64_t other = 0;
  for (std::size_t lane = 0; lane < kBlock; ++lane) {
    const SimplexFilter<kDimension> filter = filter_of<kWeighted>(block, lane);
    store(block, lane, filter);
    const auto sign = filtered_orientation<std::int64_t>(filter, lattice);
    const auto apart = static_cast<std::int64_t>(is_apart(block, lane));
    block.orientation[lane] = sign;
    block.apart[lane] = apart;
    other |= (sign ^ block.own[lane]) | (apart ^ 1);
  }
  block.as_expected = other == 0;
}

template <bool kWeighted, std::size_t kDimension>
[[gnu::always_inline]] inline void balls_of(SimplexBlock<kDimension>& block, Lattice lattice) {
  for (std::size_t place = 0; place <= kDimension; ++place) {
    for (std::size_t lane = 0; lane < kBlock; ++lane) {
      block.inside[place][lane] = filtered_ball<kWeighted, std::int64_t>(
          loaded(block, lane), block.vertices[kDimension].site(lane),
          block.apexes[place].site(lane), lattice);
    }
  }
}

template <std::size_t kPlace, std::size_t kVertices, typename Index>
[[gnu::always_inline]] inline void fit_rows_opposite(RowBlock<kVertices, Index>& block) {
  for (std::size_t lane = 0; lane < kBlock; ++lane) {
    std::array<Index, kVertices> first, second;
    first[0] = block.rows[kPlace][lane];
    for (std::size_t i = 0; i + 1 < kVertices; ++i) {
      first[i + 1] = block.rows[kFacetPlaces<kVertices>[kPlace][i]][lane];
    }
    for (std::size_t i = 0; i < kVertices; ++i) second[i] = block.beyond[kPlace][i][lane];
    const Fit<Index> fit = fit_of(first, second);
    block.apex[kPlace][lane] = fit.apex;
    const Index odd = fit.odd & RowBlock<kVertices, Index>::kOdd;
    block.fits[kPlace][lane] = (fit.place + odd) | ~fit.matches;
  }
}

template <std::size_t kVertices, typename Index>
[[gnu::always_inline]] inline void fit_rows(RowBlock<kVertices, Index>& block) {
  fit_rows_opposite<0>(block);
  fit_rows_opposite<1>(block);
  fit_rows_opposite<2>(block);
  if constexpr (kVertices == 4) fit_rows_opposite<3>(block);
}

#define CIRCUMSPECT_KERNELS(NAMESPACE, ATTRIBUTE)                                              \
  namespace NAMESPACE {                                                                        \
  template <std::size_t kDimension>                                                            \
  ATTRIBUTE void simplices(SimplexBlock<kDimension>& block, bool weighted, Lattice lattice) {  \
    if (weighted) return simplices_of<true>(block, lattice);                                   \
    simplices_of<false>(block, lattice);                                                       \
  }                                                                                            \
  template <std::size_t kDimension>                                                            \
  ATTRIBUTE void balls(SimplexBlock<kDimension>& block, bool weighted, Lattice lattice) {      \
    if (weighted) return balls_of<true>(block, lattice);                                       \
    balls_of<false>(block, lattice);                                                           \
  }                                                                                            \
  template <std::size_t kVertices, typename Index>                                             \
  ATTRIBUTE void fit(RowBlock<kVertices, Index>& block) {                                      \
    fit_rows(block);                                                                           \
  }                                                                                            \
  template <std::size_t kDimension>                                                            \
  constexpr BlockKernels<kDimension> kKernels = {                                              \
      #NAMESPACE, simplices<kDimension>, balls<kDimension>, fit<kDimension + 1, std::int32_t>, \
      fit<kDimension + 1, std::int64_t>};                                                      \
  }

CIRCUMSPECT_KERNELS(any_machine, )
#ifdef __x86_64__
CIRCUMSPECT_KERNELS(avx2, __attribute__((target("avx2"))))
CIRCUMSPECT_KERNELS(avx512, __attribute__((target("avx512f,avx512dq,avx512bw,avx512vl"))))
#endif
#undef CIRCUMSPECT_KERNELS

// The widest comes first.
template <std::size_t kDimension>
constexpr std::array kAllKernels = {
#ifdef __x86_64__
    avx512::kKernels<kDimension>,
    avx2::kKernels<kDimension>,
#endif
    any_machine::kKernels<kDimension>,
};

std::size_t too_wide() {
#ifdef __x86_64__
  if (!__builtin_cpu_supports("avx2")) return 2;
  const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
  return wide ? 0 : 1;
#else
  return 0;
#endif
}

}  // namespace

template <std::size_t kDimension>
std::span<const BlockKernels<kDimension>> block_kernels() {
  static const std::size_t first = too_wide();
  return std::span(kAllKernels<kDimension>).subspan(first);
}

template std::span<const BlockKernels<2>> block_kernels();
template std::span<const BlockKernels<3>> block_kernels();

}  // namespace circumspect::fast
