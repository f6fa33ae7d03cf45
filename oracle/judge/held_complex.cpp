#include "oracle/judge/held_complex.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "oracle/judge/complex/by_boundary.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/predicates/lattice.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast/simplex_facts.hpp"
#include "oracle/judge/fast/triangle_complex.hpp"

namespace circumspect::check {
namespace {

// For each class of the boundary all simplices are looked at: more of them are left to others.
constexpr std::size_t kMostClasses = 16;

// The boundary of a mesh, whose vertices have numbers of their own.
template <std::size_t kDimension, typename Index>
class BoundaryOf {
 public:
  using View = fast::MeshView<kDimension, Index>;

  BoundaryOf(const View& mesh, const std::vector<fast::FacetId>& facets)
      : mesh_(mesh), ids_(facets) {
    std::vector<Index> corners;
    for (const fast::FacetId id : facets) {
      const auto facet = fast::facet_of<kDimension + 1, Index>(mesh.row(id.simplex()), id.place());
      corners.insert(corners.end(), facet.begin(), facet.end());
    }
    vertices_ = corners;
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (i % kDimension == 0) facets_.emplace_back();
      const auto place = std::lower_bound(vertices_.begin(), vertices_.end(), corners[i]);
      facets_.back().push_back(place - vertices_.begin());
    }
    for (const Index v : vertices_) {
      const auto at = coordinates(v);
      coordinates_.insert(coordinates_.end(), at.begin(), at.end());
    }
  }

  // Inside of a complex no two vertices are equal.
  bool has_equal_points() const {
    std::vector<std::array<double, kDimension>> all;
    for (const Index v : vertices_) {
      auto& point = all.emplace_back();
      const auto at = coordinates(v);
      std::copy(at.begin(), at.end(), point.begin());
    }
    std::sort(all.begin(), all.end());  // −0 and 0 are equal
    return std::adjacent_find(all.begin(), all.end()) != all.end();
  }

  bool is_complex() const {
    if constexpr (kDimension == 3) {
      std::vector<std::array<std::int32_t, 3>> triangles;
      for (const Simplex& facet : facets_) {
        auto& triangle = triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) triangle[i] = static_cast<std::int32_t>(facet[i]);
      }
      if (fast::are_surely_a_complex(coordinates_, triangles)) return true;
    }
    std::vector<Point> points;
    for (const Index v : vertices_) points.push_back(exact(v));
    return improper_facets(Configuration(points), points, facets_).empty();
  }

  std::vector<std::size_t> classes() const { return one_of_each_class(facets_); }

  bool has_nothing_outside(const std::vector<std::size_t>& classes) const {
    return classes.size() <= kMostClasses &&
           std::all_of(classes.begin(), classes.end(),
                       [this](std::size_t facet) { return has_nothing_outside(facet); });
  }

 private:
  bool has_nothing_outside(std::size_t facet) const {
    std::vector<Index> corners;
    for (const Vertex v : facets_[facet]) corners.push_back(vertices_[static_cast<std::size_t>(v)]);
    const std::vector<Point> exact_corners = exact(corners);
    const Point apex = exact(mesh_.row(ids_[facet].simplex())[ids_[facet].place()]);
    for (std::size_t s = 0; s < mesh_.size(); ++s) {
      const auto row = mesh_.row(s);
      if (may_meet(row, std::span<const Index>(corners)) &&
          has_just_outside(exact(row), exact_corners, apex)) {
        return false;
      }
    }
    return true;
  }

  std::span<const double> coordinates(Index v) const {
    return mesh_.coordinates.subspan(static_cast<std::size_t>(v) * kDimension, kDimension);
  }
  Point exact(Index v) const {
    Point point;
    for (const double x : coordinates(v)) point.push_back(exact_value(x));
    return point;
  }
  std::vector<Point> exact(std::span<const Index> vertices) const {
    std::vector<Point> points;
    for (const Index v : vertices) points.push_back(exact(v));
    return points;
  }

  // Have their boxes a point in common?
  bool may_meet(std::span<const Index> a, std::span<const Index> b) const {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      const auto extent = [&](std::span<const Index> vertices) {
        double low = coordinates(vertices[0])[axis], high = low;
        for (const Index v : vertices) {
          low = std::min(low, coordinates(v)[axis]);
          high = std::max(high, coordinates(v)[axis]);
        }
        return std::pair(low, high);
      };
      const auto [low_a, high_a] = extent(a);
      const auto [low_b, high_b] = extent(b);
      if (high_a < low_b || high_b < low_a) return false;
    }
    return true;
  }

  const View& mesh_;
  const std::vector<fast::FacetId>& ids_;
  std::vector<Index> vertices_;  // ascending
  std::vector<Simplex> facets_;  // by places among these
  std::vector<double> coordinates_;
};

template <std::size_t kDimension, typename Index>
bool uses_all_points(const fast::MeshView<kDimension, Index>& mesh) {
  std::vector<bool> is_used(mesh.points(), false);
  for (const Index v : mesh.simplices) is_used[static_cast<std::size_t>(v)] = true;
  return std::find(is_used.begin(), is_used.end(), false) == is_used.end();
}

// How many parts facets connect; none if that is not found out.
template <std::size_t kDimension, typename Index>
std::size_t parts_of(const fast::MeshView<kDimension, Index>& mesh, unsigned threads) {
  const auto links = fast::matched_facets(mesh, threads);
  if (!links) return 0;
  DisjointSets joined(mesh.size());
  for (std::size_t i = 0; i < links->count; ++i) {
    const std::int32_t across = links->view()[i];
    if (across >= 0) joined.unite(i / (kDimension + 1), static_cast<std::size_t>(across));
  }
  std::size_t parts = 0;
  for (std::size_t s = 0; s < mesh.size(); ++s) parts += joined.find(s) == s ? 1 : 0;
  return parts;
}

// How many simplices have the sign of det[p_1 − p_0; …; p_d − p_0] that is positive.
template <std::size_t kDimension, typename Index>
std::size_t positive_of(const fast::MeshView<kDimension, Index>& mesh, bool are_alike) {
  const fast::Lattice lattice = fast::lattice_of_all(mesh.coordinates, {});
  fast::Stages stages;
  std::size_t positive = 0;
  for (std::size_t s = 0; s < (are_alike ? 1 : mesh.size()); ++s) {
    fast::SiteRow<kDimension> row;
    for (std::size_t i = 0; i <= kDimension; ++i)
      row[i] = mesh.template site<false>(mesh.row(s)[i]);
    // The predicate takes the last vertex for the first, which changes the sign in space.
    const int sign = fast::orientation(row, stages, lattice);
    positive += (kDimension == 2 ? sign : -sign) > 0 ? 1 : 0;
  }
  return are_alike ? positive * mesh.size() : positive;
}

bool has_signs(const ComplexFacts& facts, Orientations demanded) {
  if (demanded == Orientations::kPositive) return facts.negative == 0;
  if (demanded == Orientations::kNegative) return facts.positive == 0;
  return demanded == Orientations::kAny || facts.negative == 0 || facts.positive == 0;
}

}  // namespace

template <std::size_t kDimension, typename Index>
std::optional<Verdict> held_complex(const fast::MeshView<kDimension, Index>& mesh,
                                    const ComplexDemands& demands, std::size_t max_violations,
                                    unsigned threads) {
  if (demands.manifold || demands.closed) return std::nullopt;
  const auto known = fast::simplex_facts(mesh, {}, threads);
  if (!known || !uses_all_points(mesh)) return std::nullopt;  // unused ones may equal others
  const BoundaryOf<kDimension, Index> boundary(mesh, known->boundary);
  if (boundary.has_equal_points() || !boundary.is_complex()) return std::nullopt;
  const std::vector<std::size_t> classes = boundary.classes();
  if (!boundary.has_nothing_outside(classes)) return std::nullopt;
  ComplexFacts facts;
  facts.dimension = kDimension;
  facts.is_complex = true;
  // Each part has a class of its own.
  facts.parts = classes.size() == 1 ? 1 : parts_of(mesh, threads);
  facts.boundary_facets = known->boundary.size();
  facts.positive = positive_of(mesh, known->oriented);
  facts.negative = mesh.size() - facts.positive;
  const bool is_demanded = has_signs(facts, demands.oriented) && facts.parts > 0 &&
                           (!demands.connected || facts.parts == 1);
  if (!is_demanded) return std::nullopt;
  Verdict verdict(Claim::kComplex, max_violations);
  verdict.points = mesh.points();
  verdict.simplices = mesh.size();
  verdict.dimension = kDimension;
  verdict.complex = facts;
  verdict.course = {true, "", known->stages.filtered, known->stages.exact()};
  return verdict;
}

template std::optional<Verdict> held_complex(const fast::MeshView<2, std::int32_t>&,
                                             const ComplexDemands&, std::size_t, unsigned);
template std::optional<Verdict> held_complex(const fast::MeshView<2, std::int64_t>&,
                                             const ComplexDemands&, std::size_t, unsigned);
template std::optional<Verdict> held_complex(const fast::MeshView<3, std::int32_t>&,
                                             const ComplexDemands&, std::size_t, unsigned);
template std::optional<Verdict> held_complex(const fast::MeshView<3, std::int64_t>&,
                                             const ComplexDemands&, std::size_t, unsigned);

}  // namespace circumspect::check
