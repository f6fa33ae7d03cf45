#include "construct/delaunay.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <stdexcept>
#include <thread>
#include <utility>
#include <variant>

#include "construct/bowyer_watson.hpp"
#include "construct/insertion_order.hpp"
#include "kernel/exact/interruption.hpp"
#include "oracle/judge/fast/judge.hpp"
#include "reference/constructions.hpp"

namespace circumspect::construct {
namespace {

// The points in their order of insertion, and which they are.
template <std::size_t kDimension>
struct Sequence {
  std::vector<fast::Site<kDimension>> sites;
  std::vector<std::int32_t> order;
};

template <std::size_t kDimension>
Sequence<kDimension> sequence_of(std::span<const double> coordinates,
                                 std::span<const double> weights) {
  Sequence<kDimension> sequence{{}, insertion_order(coordinates, kDimension)};
  sequence.sites.reserve(sequence.order.size());
  for (const std::int32_t v : sequence.order) {
    const auto place = static_cast<std::size_t>(v);
    fast::Site<kDimension> site;
    std::copy_n(coordinates.begin() + static_cast<std::ptrdiff_t>(place * kDimension), kDimension,
                site.at.begin());
    if (!weights.empty()) site.weight = weights[place];
    sequence.sites.push_back(site);
  }
  return sequence;
}

// Moves affinely independent points to the front; false if all points lie in a flat.
template <std::size_t kDimension>
bool begin_independent(Sequence<kDimension>& sequence) {
  const auto first = first_independent<kDimension>(sequence.sites);
  if (!first) return false;
  for (std::size_t i = 0; i <= kDimension; ++i) {
    std::swap(sequence.sites[i], sequence.sites[(*first)[i]]);
    std::swap(sequence.order[i], sequence.order[(*first)[i]]);
  }
  return true;
}

// Rows in the order of ProvedDelaunay. A row is ascending, with the parity of its permutation
// beside the last vertex while rows are sorted: first by their least vertex, which few
// have in common, then by the others.
template <std::size_t kVertices>
Rows<std::int32_t> in_order(const std::vector<Place>& cells,
                            const std::vector<std::int32_t>& names) {
  using Row = std::array<std::int32_t, kVertices>;
  const std::size_t count = cells.size() / kVertices;
  const auto row_of = [&](std::size_t i) {
    Row row;
    for (std::size_t k = 0; k < kVertices; ++k) {
      row[k] = names[static_cast<std::size_t>(cells[i * kVertices + k])];
    }
    bool is_odd = false;
    for (std::size_t a = 1; a < kVertices; ++a) {
      for (std::size_t b = a; b > 0 && row[b] < row[b - 1]; --b) {
        std::swap(row[b], row[b - 1]);
        is_odd = !is_odd;
      }
    }
    row.back() = row.back() << 1 | static_cast<std::int32_t>(is_odd);
    return row;
  };
  std::vector<std::size_t> begins(names.size() + 1);
  for (std::size_t i = 0; i < count; ++i) ++begins[static_cast<std::size_t>(row_of(i).front()) + 1];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<Row> rows(count);
  std::vector<std::size_t> next = begins;
  for (std::size_t i = 0; i < count; ++i) {
    const Row row = row_of(i);
    rows[next[static_cast<std::size_t>(row.front())]++] = row;
  }
  Rows<std::int32_t> sorted(count, kVertices);
  for (std::size_t v = 0; v < names.size(); ++v) {
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(begins[v]);
    std::sort(begin, rows.begin() + static_cast<std::ptrdiff_t>(begins[v + 1]));
  }
  for (std::size_t i = 0; i < count; ++i) {
    Row& row = rows[i];
    if ((row.back() & 1) != 0) std::swap(row[0], row[1]);
    row.back() >>= 1;
    std::copy(row.begin(), row.end(), sorted.row(i).begin());
  }
  return sorted;
}

template <std::size_t kDimension, bool kWeighted>
std::optional<Rows<std::int32_t>> constructed(std::span<const double> coordinates,
                                              std::span<const double> weights,
                                              const Progress& progress) {
  Sequence<kDimension> sequence = sequence_of<kDimension>(coordinates, weights);
  if (!begin_independent(sequence)) return std::nullopt;
  BowyerWatson<kDimension, kWeighted> algorithm(std::move(sequence.sites),
                                                fast::lattice_of_all(coordinates, weights));
  const std::size_t count = sequence.order.size();
  for (std::size_t u = kDimension + 1; u < count; ++u) {
    if (u % 256 == 0) {
      tell(progress, "points inserted", u, count);
      end_if_interrupted();
    }
    if (!algorithm.insert(static_cast<Place>(u))) return std::nullopt;
  }
  return in_order<kDimension + 1>(algorithm.solid_cells(), sequence.order);
}

template <std::size_t kDimension>
std::optional<ProvedDelaunay> proved(std::span<const double> coordinates,
                                     std::span<const double> weights, const Progress& progress) {
  const bool is_weighted = !weights.empty();
  auto simplices = is_weighted ? constructed<kDimension, true>(coordinates, weights, progress)
                               : constructed<kDimension, false>(coordinates, weights, progress);
  if (!simplices) return std::nullopt;
  // Without the neighbours that the construction knows: the judge takes nothing from it on trust.
  const fast::MeshView<kDimension, std::int32_t> mesh{coordinates, weights,
                                                      std::as_const(*simplices).values()};
  const auto facts =
      fast::judge(mesh, is_weighted ? fast::Question::kWeightedDelaunay : fast::Question::kDelaunay,
                  std::max(1U, std::thread::hardware_concurrency()));
  if (!facts && facts.error() == fast::Undecided::kTooLarge) return std::nullopt;
  if (!facts || !facts->holds() || !facts->canonical) {
    throw std::logic_error("the judge refutes a triangulation that construct/ made");
  }
  return ProvedDelaunay{std::move(*simplices), facts->unique};
}

}  // namespace

Triangulation ProvedDelaunay::triangulation() const {
  std::vector<Simplex> lists;
  lists.reserve(simplices.rows());
  for (std::size_t i = 0; i < simplices.rows(); ++i) {
    const auto row = simplices.row(i);
    lists.emplace_back(row.begin(), row.end());
  }
  return {static_cast<int>(simplices.columns()) - 1, std::move(lists)};
}

std::optional<ProvedDelaunay> canonical_delaunay(const Numbers& coordinates, const Numbers& weights,
                                                 const Progress& progress) {
  constexpr std::size_t kMostPoints = std::size_t{1} << 29;
  const auto* const points = std::get_if<Rows<double>>(&coordinates);
  const auto* const heights = std::get_if<Rows<double>>(&weights);
  if (points == nullptr || (heights == nullptr && rows_of(weights) > 0)) return std::nullopt;
  if (points->rows() > kMostPoints || !fast::arithmetic_is_as_proved()) return std::nullopt;
  const std::span<const double> counted =
      rows_of(weights) > 0 ? heights->values() : std::span<const double>();
  if (points->columns() == 2) return proved<2>(points->values(), counted, progress);
  if (points->columns() == 3) return proved<3>(points->values(), counted, progress);
  return std::nullopt;
}

std::optional<ProvedDelaunay> canonical_delaunay(const PointSet& points, const Progress& progress) {
  if (points.dimension() < 2 || points.dimension() > 3) return std::nullopt;
  std::vector<Rational> weights;
  for (Vertex v = 0; points.is_weighted() && points.names(v); ++v) {
    weights.push_back(points.weight(v));
  }
  return canonical_delaunay(numbers_of(points.points(), points.ambient_dimension()),
                            numbers_of(weights), progress);
}

CanonicalDelaunay any_canonical_delaunay(const PointSet& points, const Progress& progress) {
  const auto fast = canonical_delaunay(points, progress);
  if (fast) return {fast->triangulation(), fast->is_unique};
  return {reference::canonical_delaunay(points, progress)};
}

}  // namespace circumspect::construct
