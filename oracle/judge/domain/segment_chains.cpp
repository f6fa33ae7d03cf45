#include "oracle/judge/domain/segment_chains.hpp"

#include <algorithm>
#include <numeric>

namespace circumspect::check {

SegmentChains::SegmentChains(const ExactMesh& mesh, const PiecewiseLinearComplex& complex,
                             const VertexPlaces& places)
    : complex_(complex),
      places_(places),
      chains_(complex.segments.size()),
      from_(complex.points.size() + 1, 0),
      place_in_chain_(mesh.points.size(), kNowhere),
      touches_(mesh.points.size(), false) {
  for (const Simplex& segment : complex.segments) ++from_[VertexPlaces::place(segment[0]) + 1];
  std::partial_sum(from_.begin(), from_.end(), from_.begin());
  for (Vertex v = 0; mesh.points.names(v); ++v) {
    const std::size_t segment = places.segment[VertexPlaces::place(v)];
    if (segment != kNowhere) chains_[segment].push_back(v);
  }
  for (std::size_t s = 0; s < chains_.size(); ++s) {
    std::vector<Vertex>& chain = chains_[s];
    const Vertex first = places.in_mesh[VertexPlaces::place(complex.segments[s][0])];
    const Vertex last = places.in_mesh[VertexPlaces::place(complex.segments[s][1])];
    // Along a line the lexicographic order is the order of the points, or its reverse.
    const auto before = [&](Vertex a, Vertex b) {
      return mesh.points.configuration().rank(a) < mesh.points.configuration().rank(b);
    };
    std::sort(chain.begin(), chain.end(), before);
    if (before(last, first)) std::reverse(chain.begin(), chain.end());
    chain.insert(chain.begin(), first);
    chain.push_back(last);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      place_in_chain_[VertexPlaces::place(chain[i])] = i;
      touches_[VertexPlaces::place(chain[i])] = true;
    }
  }
}

std::size_t SegmentChains::place_on(std::size_t segment, Vertex v) const {
  if (places_.segment[VertexPlaces::place(v)] == segment) {
    return place_in_chain_[VertexPlaces::place(v)];
  }
  if (chains_[segment].front() == v) return 0;
  if (chains_[segment].back() == v) return chains_[segment].size() - 1;
  return kNowhere;
}

std::size_t SegmentChains::segment_between(Vertex u, Vertex v) const {
  const auto begin = complex_.segments.begin();
  const auto last = begin + from_[VertexPlaces::place(u) + 1];
  const auto found =
      std::lower_bound(begin + from_[VertexPlaces::place(u)], last, v,
                       [](const Simplex& segment, Vertex end) { return segment[1] < end; });
  if (found == last || (*found)[1] != v) return kNowhere;
  return static_cast<std::size_t>(found - begin);
}

std::optional<SegmentChains::Stretch> SegmentChains::stretch(Vertex a, Vertex b) const {
  std::size_t segment = places_.segment[VertexPlaces::place(a)];
  if (segment == kNowhere) segment = places_.segment[VertexPlaces::place(b)];
  if (segment == kNowhere) {
    const Vertex u = places_.in_domain[VertexPlaces::place(a)];
    const Vertex v = places_.in_domain[VertexPlaces::place(b)];
    if (u == kNoVertex || v == kNoVertex) return std::nullopt;
    segment = segment_between(std::min(u, v), std::max(u, v));
    if (segment == kNowhere) return std::nullopt;
  }
  const std::size_t of_a = place_on(segment, a);
  const std::size_t of_b = place_on(segment, b);
  if (of_a == kNowhere || of_b == kNowhere) return std::nullopt;
  return Stretch{segment, std::min(of_a, of_b), std::max(of_a, of_b)};
}

bool SegmentChains::is_link(Vertex a, Vertex b) const {
  if (!touches(a) || !touches(b)) return false;
  const auto found = stretch(a, b);
  return found && found->is_link();
}

}  // namespace circumspect::check
