#include "oracle/judge/verdict_of_facts.hpp"

#include <algorithm>
#include <utility>

#include "oracle/judge/shared_facets.hpp"

namespace circumspect::check {
namespace {

// The part of a mesh that some facets are about: the simplices that come first of the two at each, and
// the vertices of these and the apexes, all in their order.
template <std::size_t kDimension, typename Index>
class Part {
 public:
  Part(const fast::MeshView<kDimension, Index>& whole, std::vector<SharedFacet> facets)
      : whole_(whole), facets_(std::move(facets)), place_of_(whole.points(), kNone) {
    for (const SharedFacet& shared : facets_) {
      simplices_.push_back(shared.simplex);
      for (const Index v : whole_.row(shared.simplex)) take(v);
      take(shared.apex);
    }
    std::sort(simplices_.begin(), simplices_.end());
    simplices_.erase(std::unique(simplices_.begin(), simplices_.end()), simplices_.end());
    for (std::size_t v = 0; v < place_of_.size(); ++v) {
      if (place_of_[v] == kNone) continue;
      place_of_[v] = static_cast<Vertex>(vertices_.size());
      vertices_.push_back(static_cast<Vertex>(v));
    }
  }

  ExactMesh mesh(bool weighted) const {
    std::vector<Point> points;
    std::vector<Rational> weights;
    for (const Vertex v : vertices_) {
      const auto place = static_cast<std::size_t>(v);
      Point& point = points.emplace_back();
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        point.push_back(exact_value(whole_.coordinates[place * kDimension + axis]));
      }
      if (weighted) weights.push_back(exact_value(whole_.weights[place]));
    }
    ExactMesh part{PointSet(std::move(points), std::move(weights)), {}};
    for (const std::size_t s : simplices_) {
      Simplex& simplex = part.simplices.emplace_back();
      for (const Index v : whole_.row(s)) simplex.push_back(place_of(v));
    }
    return part;
  }

  // Where in the whole they are, ascending.
  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<std::size_t>& simplices() const { return simplices_; }

  // As the part numbers simplices and points.
  std::vector<SharedFacet> facets() const {
    std::vector<SharedFacet> facets = facets_;
    for (SharedFacet& shared : facets) {
      for (Vertex& v : shared.facet) v = place_of(v);
      const auto found = std::lower_bound(simplices_.begin(), simplices_.end(), shared.simplex);
      shared.simplex = static_cast<std::size_t>(found - simplices_.begin());
      shared.apex = place_of(shared.apex);
    }
    return facets;
  }

 private:
  static constexpr Vertex kNone = -1;

  Vertex place_of(Vertex v) const { return place_of_[static_cast<std::size_t>(v)]; }
  void take(Vertex v) { place_of_[static_cast<std::size_t>(v)] = 0; }

  const fast::MeshView<kDimension, Index>& whole_;
  std::vector<SharedFacet> facets_;
  std::vector<std::size_t> simplices_;
  std::vector<Vertex> vertices_;
  std::vector<Vertex> place_of_;  // of each point of the whole, in the part
};

}  // namespace

template <std::size_t kDimension, typename Index>
Verdict verdict_of_facts(Claim claim, const fast::MeshView<kDimension, Index>& mesh,
                         const fast::Facts& facts, const Options& options) {
  Verdict verdict(claim, options.max_violations);
  if (facts.holds()) {
    if (claim != Claim::kTriangulation) {
      verdict.unique = facts.unique;
      verdict.canonical = facts.canonical;
    }
  } else {
    const Part<kDimension, Index> part(mesh, shared_facets(mesh, facts.not_local));
    const bool weighted = claim == Claim::kWeightedDelaunay && !mesh.weights.empty();
    verdict = not_locally_delaunay(claim, part.mesh(weighted), part.facets(), options);
    verdict.name_in_whole(part.vertices(), part.simplices());
  }
  verdict.points = mesh.points();
  verdict.simplices = mesh.size();
  verdict.dimension = static_cast<int>(kDimension);
  return verdict;
}

template Verdict verdict_of_facts(Claim, const fast::MeshView<2, std::int32_t>&, const fast::Facts&,
                                  const Options&);
template Verdict verdict_of_facts(Claim, const fast::MeshView<2, std::int64_t>&, const fast::Facts&,
                                  const Options&);
template Verdict verdict_of_facts(Claim, const fast::MeshView<3, std::int32_t>&, const fast::Facts&,
                                  const Options&);
template Verdict verdict_of_facts(Claim, const fast::MeshView<3, std::int64_t>&, const fast::Facts&,
                                  const Options&);

}  // namespace circumspect::check
