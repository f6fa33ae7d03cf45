// Refutations of claims about domains.
#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "kernel/exact/point.hpp"
#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/document.hpp"
#include "oracle/certificate/domain_certificate.hpp"
#include "oracle/certificate/domain_evidence.hpp"
#include "oracle/certificate/domain_part.hpp"

namespace circumspect::certificate {
namespace {

// Points that make the face a simplex of full dimension, which does not contain `without` if the
// face does not: steps along the axes from its first vertex, in one direction or the other. Nothing
// if the face is degenerate.
std::optional<std::vector<std::vector<Integer>>> pads_of(
    const Simplex& face, const ScaledPoints& points,
    const std::optional<HomogeneousPoint>& without) {
  const std::size_t dimension = points.dimension;
  const std::size_t missing = dimension + 1 - face.size();
  ScaledPoints own{dimension};
  for (const Vertex v : face) {
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      own.coordinates.push_back(points.coordinate(v, axis));
    }
  }
  Simplex simplex(dimension + 1);
  std::iota(simplex.begin(), simplex.end(), Vertex{0});
  for (unsigned axes = 0; axes < 1U << dimension; ++axes) {
    if (static_cast<std::size_t>(std::popcount(axes)) != missing) continue;
    for (unsigned signs = 0; signs < 1U << missing; ++signs) {
      ScaledPoints full = own;
      std::vector<std::vector<Integer>> pads;
      for (std::size_t axis = 0; axis < dimension; ++axis) {
        if ((axes >> axis & 1U) == 0) continue;
        std::vector<Integer> pad(own.coordinates.begin(),
                                 own.coordinates.begin() + static_cast<std::ptrdiff_t>(dimension));
        pad[axis] += (signs >> pads.size() & 1U) == 0 ? 1 : -1;
        full.coordinates.insert(full.coordinates.end(), pad.begin(), pad.end());
        pads.push_back(std::move(pad));
      }
      Sidedness sidedness(full);
      const int orientation = sidedness.orientation(simplex);
      if (orientation == 0) break;
      bool is_beyond = !without;
      bool is_in_hull = true;
      for (std::size_t i = face.size(); i < simplex.size() && without; ++i) {
        const int sign = orientation * sidedness.orientation_with(simplex, i, *without);
        is_beyond = is_beyond || sign < 0;
        is_in_hull = is_in_hull && sign == 0;
      }
      if (is_beyond || is_in_hull) return pads;
    }
  }
  return std::nullopt;
}

// What the polygons of the domain are, over the same scale as the points of the mesh.
tl::expected<WholeDomain, std::string> whole_domain(
    const PiecewiseLinearComplex& complex, const ListedSegments& listed, const ScaledPoints& points,
    const std::vector<Vertex>& vertices, WholeEvidence evidence, const HullFillers& fillers) {
  WholeDomain made{.kind = complex.kind, .evidence = std::move(evidence)};
  ScaledPoints own{points.dimension, points.scale_numerator, points.scale_denominator};
  for (const Vertex v : vertices) {
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      own.coordinates.push_back(points.coordinate(v, axis));
    }
  }
  for (const Point& seed : complex.hole_seeds) made.holes.push_back(scaled(own, seed));
  auto polygons = polygon_certificates(complex, own, listed, fillers);
  if (!polygons) return tl::unexpected(polygons.error());
  made.polygons = std::move(*polygons);
  return made;
}

tl::unexpected<std::string> none_because(std::string_view reason) {
  return tl::unexpected(fmt::format("there is no refutation of this mesh: {}", reason));
}

// The points of the mesh, and the vertices of the domain that are not among them, over one scale;
// `vertices` says which point each vertex is.
struct PointsOfBoth {
  ScaledPoints points;
  std::vector<Vertex> vertices;
};

tl::expected<PointsOfBoth, std::string> points_of_both(const PointSet& of_mesh,
                                                       const PointSet& of_domain) {
  std::vector<Point> all = of_mesh.points();
  std::map<Point, Vertex> place_of;
  for (std::size_t i = 0; i < all.size(); ++i) place_of.emplace(all[i], static_cast<Vertex>(i));
  std::vector<Vertex> vertices;
  for (const Point& vertex : of_domain.points()) {
    const auto [place, is_new] = place_of.emplace(vertex, static_cast<Vertex>(all.size()));
    if (is_new) all.push_back(vertex);
    vertices.push_back(place->second);
  }
  auto points = scaled_to_integers(PointSet(std::move(all)));
  if (!points) return tl::unexpected(points.error());
  return PointsOfBoth{std::move(*points), std::move(vertices)};
}

// Finds evidence, and puts it into `made`. What comes back is the point that must be in no simplex,
// if there is one. `all` are the simplices of the mesh, then what dangles.
tl::expected<std::optional<HomogeneousPoint>, std::string> add_evidence(
    const ExactMesh& mesh, const ExactMesh& all, const Domain& domain, const ListedSegments& listed,
    const Verdict& verdict, const HullFillers& fillers, DomainRefutation& made) {
  if (auto evidence = domain_evidence(mesh, all, domain, verdict, made.points, made.vertices)) {
    made.refutation.rule = evidence->rule;
    made.refutation.because = std::move(evidence->because);
    if (evidence->rule != Rule::kSegmentMissing) return std::nullopt;
    const std::vector<Integer>& because = made.refutation.because;
    return HomogeneousPoint{{because.begin() + 1, because.end() - 1}, because.back()};
  }
  auto of_whole = whole_evidence(all, domain, listed, verdict, made.points, made.vertices, fillers);
  if (!of_whole) {
    return none_because(
        fmt::format("{} is broken, and no evidence was found that circumspect-verified reads",
                    identifier(verdict.tallies().begin()->first)));
  }
  made.refutation.rule = of_whole->rule;
  std::optional<HomogeneousPoint> seen = of_whole->seen;
  if (of_whole->elsewhere) {
    made.whole = WholeDomain{.kind = domain.complex.kind, .evidence = std::move(*of_whole)};
    return seen;
  }
  auto whole = whole_domain(domain.complex, listed, made.points, made.vertices,
                            std::move(*of_whole), fillers);
  if (!whole) return tl::unexpected(whole.error());
  made.whole = std::move(*whole);
  return seen;
}

}  // namespace

tl::expected<DomainRefutation, std::string> domain_refutation_of(const ExactMesh& mesh,
                                                                 const Domain& domain,
                                                                 const ListedSegments& listed,
                                                                 const Verdict& verdict,
                                                                 const HullFillers& fillers) {
  ExactMesh all = mesh;  // and what dangles
  const std::vector<Simplex> dangling = dangling_faces(mesh);
  for (const Simplex& face : dangling) {
    if (!std::all_of(face.begin(), face.end(), [&](Vertex v) { return mesh.points.names(v); })) {
      return none_because("a dangling triangle or edge names no point");
    }
    all.simplices.push_back(face);
  }
  auto both = points_of_both(mesh.points, domain.complex.points);
  if (!both) return tl::unexpected(both.error());
  const std::vector<std::size_t>& basis = mesh.points.configuration().hull().basis;
  if (basis.size() != both->points.dimension + 1) {
    return none_because("its points do not span the plane or space");
  }
  DomainRefutation made{Refutation{verdict.claim(), {}, {}, basis}, std::move(both->points),
                        std::move(both->vertices), domain.complex.segments};
  const auto seen = add_evidence(mesh, all, domain, listed, verdict, fillers, made);
  if (!seen) return tl::unexpected(seen.error());
  for (const Simplex& face : dangling) {
    auto pads = pads_of(face, made.points, *seen);
    if (!pads) return none_because("a dangling triangle or edge is degenerate");
    made.dangling.push_back({face, std::move(*pads)});
  }
  return made;
}

}  // namespace circumspect::certificate
