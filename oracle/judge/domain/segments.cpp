#include "oracle/judge/domain/segments.hpp"

#include <algorithm>
#include <set>

namespace circumspect::check {

namespace {

// What is known of a link of a chain. An edge that skips vertices of the chain is a fault of its
// own, and the reason why there is no simplex at the links that it covers.
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
