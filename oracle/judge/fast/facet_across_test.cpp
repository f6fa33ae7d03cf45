// Rows of two simplices with a common facet, in every order.
#include "oracle/judge/fast/facet_across.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include <doctest/doctest.h>

namespace circumspect::fast {
namespace {

template <std::size_t kVertices>
using Row = std::array<std::int32_t, kVertices>;

template <std::size_t kVertices>
Fit<std::int32_t> fit_of_rows(const Row<kVertices>& first, std::size_t apex,
                              const Row<kVertices>& second) {
  Row<kVertices> ordered{first[apex]};
  for (std::size_t i = 0; i + 1 < kVertices; ++i) {
    ordered[i + 1] = first[kFacetPlaces<kVertices>[apex][i]];
  }
  return fit_of(ordered, second);
}

// Every order of the second row, for each apex of the first.
template <std::size_t kVertices>
void check_all_orders() {
  Row<kVertices> first;
  std::iota(first.begin(), first.end(), 10);
  for (std::size_t apex = 0; apex < kVertices; ++apex) {
    Row<kVertices> places;
    std::iota(places.begin(), places.end(), 0);
    do {
      Row<kVertices> second;
      bool odd = false;
      for (std::size_t i = 0; i < kVertices; ++i) {
        second[i] = first[static_cast<std::size_t>(places[i])];
        for (std::size_t k = i + 1; k < kVertices; ++k) odd ^= places[i] > places[k];
      }
      CHECK(fit_of_rows(first, apex, second).matches == 0);  // the same simplex
      const auto own = std::find(second.begin(), second.end(), first[apex]);
      *own = 99;
      const Fit<std::int32_t> found = fit_of_rows(first, apex, second);
      CHECK(found.matches == -1);
      CHECK(found.place == own - second.begin());
      CHECK(found.apex == 99);
      CHECK(found.odd == (odd ? -1 : 0));
      for (std::int32_t& v : second) {
        if (v == 99) continue;
        const std::int32_t right = v;
        for (const std::int32_t wrong : {98, 99, first[apex], first[(apex + 1) % kVertices]}) {
          v = wrong;
          if (wrong != right) CHECK(fit_of_rows(first, apex, second).matches == 0);
        }
        v = right;
      }
    } while (std::next_permutation(places.begin(), places.end()));
  }
}

TEST_CASE("a facet is recognized in any order, with the sign of the permutation") {
  check_all_orders<3>();
  check_all_orders<4>();
}

}  // namespace
}  // namespace circumspect::fast
