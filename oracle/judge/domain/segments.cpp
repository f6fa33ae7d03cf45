#include <algorithm>
#include <numeric>
#include <set>

#include "oracle/judge/domain/meshed_domain.hpp"
#include "oracle/judge/domain/plc_triangulation.hpp"

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

// ---- Segments ----

namespace {

// What is known of a link of a chain. An edge that skips vertices of the chain is a fault of its own,
// and the reason why there is no simplex at the links that it covers.
enum class Link { kAbsent, kListed, kEdgeOfSimplex, kSkipped };

class Links {
 public:
  Links(const MeshedDomain& in, Verdict& verdict) : in_(in), verdict_(verdict) {
    for (std::size_t s = 0; s < in.chains.size(); ++s) {
      states_.emplace_back(in.chains.chain(s).size() - 1, Link::kAbsent);
    }
  }

  void see(const Simplex& simplex, Link state) {
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if (!in_.chains.touches(simplex[i])) continue;
      for (std::size_t j = i + 1; j < simplex.size(); ++j) {
        if (!in_.chains.touches(simplex[j])) continue;
        see_edge(simplex, simplex[i], simplex[j], state);
      }
    }
  }

  bool nothing_skipped() const { return nothing_skipped_; }
  Link state(std::size_t segment, std::size_t place) const { return states_[segment][place]; }

 private:
  void see_edge(const Simplex& simplex, Vertex a, Vertex b, Link state) {
    const auto stretch = in_.chains.stretch(a, b);
    if (!stretch) return;
    std::vector<Link>& states = states_[stretch->segment];
    for (std::size_t i = stretch->first; i < stretch->last; ++i) {
      states[i] = std::max(states[i], stretch->is_link() ? state : Link::kSkipped);
    }
    if (stretch->is_link() || !skipping_.insert({std::min(a, b), std::max(a, b)}).second) return;
    nothing_skipped_ = false;
    const std::vector<Vertex>& chain = in_.chains.chain(stretch->segment);
    verdict_.add(Rule::kVertexInEdge, {.simplices = {simplex},
                                       .face = Simplex{std::min(a, b), std::max(a, b)},
                                       .vertices = {chain[stretch->first + 1]},
                                       .domain_cell = in_.complex.segments[stretch->segment]});
  }

  const MeshedDomain& in_;
  Verdict& verdict_;
  std::vector<std::vector<Link>> states_;
  std::set<std::pair<Vertex, Vertex>> skipping_;
  bool nothing_skipped_ = true;
};

// A link that no simplex has must not run through the inside of a polyhedron. On a wall the tiling
// of the wall decides.
bool is_missing(const MeshedDomain& in, Link state, Vertex a, Vertex b) {
  if (state == Link::kAbsent) return true;
  if (state != Link::kListed) return false;
  return in.regions.locate(barycentre({in.mesh.points[a], in.mesh.points[b]})) == Where::kInside;
}

}  // namespace

bool judge_segments(const MeshedDomain& in, Verdict& verdict) {
  Links links(in, verdict);
  for (const Simplex& simplex : in.mesh.simplices) links.see(simplex, Link::kEdgeOfSimplex);
  for (const Simplex& face : in.mesh.faces) links.see(face, Link::kListed);
  bool complete = links.nothing_skipped();
  for (std::size_t s = 0; s < in.chains.size(); ++s) {
    const std::vector<Vertex>& chain = in.chains.chain(s);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      if (!is_missing(in, links.state(s, i), chain[i], chain[i + 1])) continue;
      complete = false;
      Witness witness{.face = Simplex{chain[i], chain[i + 1]},
                      .domain_cell = in.complex.segments[s]};
      if (verdict.keeps_more()) {
        witness.nearest =
            in.search.to_segment(in.mesh.points[chain[i]], in.mesh.points[chain[i + 1]]);
      }
      verdict.add(Rule::kSegmentMissing, witness);
    }
  }
  return complete;
}

bool judge_inner_vertices(const MeshedDomain& in, Verdict& verdict) {
  std::vector<bool> has_simplex(in.mesh.points.size(), false);
  for (const Simplex& simplex : in.mesh.simplices) {
    for (const Vertex v : simplex) has_simplex[VertexPlaces::place(v)] = true;
  }
  bool complete = true;
  for (Vertex v = 0; in.complex.points.names(v); ++v) {
    if (has_simplex[VertexPlaces::place(in.in_mesh(v))]) continue;
    if (in.regions.locate(in.complex.points[v]) != Where::kInside) continue;
    complete = false;
    Witness witness{.vertices = {in.in_mesh(v)}, .domain_cell = Simplex{v}};
    if (verdict.keeps_more()) witness.nearest = in.search.to_point(in.complex.points[v]);
    verdict.add(Rule::kDomainVertexMissing, witness);
  }
  return complete;
}

}  // namespace circumspect::check
