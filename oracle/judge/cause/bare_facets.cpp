#include "oracle/judge/cause/bare_facets.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "kernel/predicates/orientation.hpp"
#include "oracle/judge/fast/facet_matching.hpp"
#include "oracle/judge/fast/predicates/predicates.hpp"
#include "oracle/judge/fast_view.hpp"

namespace circumspect::check {
namespace {

template <std::size_t kDimension>
int orientation_of_doubles(std::span<const double> coordinates, std::span<const Vertex> points) {
  fast::SiteRow<kDimension> row;
  for (std::size_t i = 0; i <= kDimension; ++i) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      row[i].at[axis] = coordinates[static_cast<std::size_t>(points[i]) * kDimension + axis];
    }
  }
  fast::Stages stages;
  return fast::orientation<kDimension>(row, stages);
}

template <std::size_t kDimension, class Index>
BareFacet bare_facet(const fast::MeshView<kDimension, Index>& view, fast::FacetId facet) {
  const auto row = view.row(facet.simplex());
  const auto vertices = fast::facet_of<kDimension + 1, Index>(row, facet.place());
  return {Simplex(vertices.begin(), vertices.end()), Vertex{row[facet.place()]}};
}

std::vector<BareFacet> in_order(std::vector<BareFacet> facets) {
  std::sort(facets.begin(), facets.end(),
            [](const BareFacet& a, const BareFacet& b) { return a.facet < b.facet; });
  return facets;
}

}  // namespace

std::vector<BareFacet> bare_facets(const Mesh& mesh) {
  std::vector<BareFacet> found;
  look_at_simplices(mesh, [&]<std::size_t kDimension, class Index>(
                              const fast::MeshView<kDimension, Index>& view) {
    constexpr std::size_t kVertices = kDimension + 1;
    const auto links = fast::matched_facets(view, 1, fast::Proposal::kLikely);
    if (!links) return;
    std::vector<bool> is_overused(links->count, false);
    for (const auto& group : links->overused) {
      for (const std::uint64_t facet : group) is_overused[facet] = true;
    }
    for (std::size_t i = 0; i < links->count; ++i) {
      if (links->view()[i] >= 0 || is_overused[i]) continue;
      if (!name_points(mesh, view.row(i / kVertices))) continue;
      found.push_back(bare_facet(view, fast::FacetId(i / kVertices, i % kVertices)));
    }
  });
  return in_order(std::move(found));
}

std::vector<BareFacet> bare_facets(const Mesh& mesh, const std::vector<fast::FacetId>& boundary) {
  std::vector<BareFacet> found;
  found.reserve(boundary.size());
  look_at_simplices(mesh, [&](const auto& view) {
    for (const fast::FacetId facet : boundary) found.push_back(bare_facet(view, facet));
  });
  return in_order(std::move(found));
}

int orientation_in(const Mesh& mesh, std::span<const Vertex> points) {
  if (!name_points(mesh, points)) return 0;
  const auto* const doubles = std::get_if<Rows<double>>(&mesh.coordinates);
  if (doubles != nullptr && mesh.dimension() == 2) {
    return orientation_of_doubles<2>(doubles->values(), points);
  }
  if (doubles != nullptr && mesh.dimension() == 3) {
    return orientation_of_doubles<3>(doubles->values(), points);
  }
  std::vector<Point> corners;
  for (const Vertex v : points) corners.push_back(mesh.point(v));
  const Configuration exact(corners);
  std::vector<std::size_t> axes(mesh.dimension());
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  return orientation(exact, axes, first_subset(points.size()));
}

int side_of(const Mesh& mesh, const BareFacet& facet, Vertex point) {
  std::array<Vertex, 4> joined = {};
  const auto end = std::copy(facet.facet.begin(), facet.facet.end(), joined.begin());
  *end = point;
  return orientation_in(mesh, std::span(joined).first(facet.facet.size() + 1));
}

}  // namespace circumspect::check
