#include "oracle/certificate/hull_certificate.hpp"

#include <algorithm>
#include <utility>

#include "kernel/predicates/configuration.hpp"
#include "oracle/certificate/scaled_points.hpp"

namespace circumspect::certificate {
namespace {

// d+1 affinely independent points, and their centre, which is none of the points. A centre that is
// a point takes the place of one of them, in turns: each time the centre is another.
struct Summit {
  std::vector<Vertex> around;
  Point place;
};

Summit summit_of(const PointSet& points) {
  const std::vector<std::size_t>& basis = points.configuration().hull().basis;
  Summit summit{{basis.begin(), basis.end()}, {}};
  for (std::size_t turn = 0;; ++turn) {
    summit.place = circumspect::barycentre(
        coordinates(points, Simplex(summit.around.begin(), summit.around.end())));
    const auto& all = points.points();
    const auto there = std::find(all.begin(), all.end(), summit.place);
    if (there == all.end()) return summit;
    summit.around[turn % summit.around.size()] = there - all.begin();
  }
}

// In the plane, vertices one a row are the ends of edges, each with the next.
std::vector<Simplex> facets_of(const std::vector<Simplex>& rows) {
  if (rows.front().size() != 1) return rows;
  std::vector<Simplex> edges;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    edges.push_back({rows[i].front(), rows[(i + 1) % rows.size()].front()});
  }
  return edges;
}

bool are_all_vertices(const ExactMesh& mesh) {
  std::vector<bool> is_vertex(mesh.points.size());
  for (const Simplex& facet : mesh.simplices) {
    for (const Vertex v : facet) is_vertex[static_cast<std::size_t>(v)] = true;
  }
  return std::find(is_vertex.begin(), is_vertex.end(), false) == is_vertex.end();
}

// With these weights the summit has the height 0, and every other point the height 1.
std::vector<Integer> weights_of_cones(const ScaledPoints& points) {
  std::vector<Integer> weights;
  for (std::size_t v = 0; v < points.size(); ++v) {
    Integer weight = v + 1 == points.size() ? 0 : -1;
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      const Integer& x = points.coordinate(static_cast<Vertex>(v), axis);
      add_product(weight, x, x);
    }
    weights.push_back(std::move(weight));
  }
  return weights;
}

}  // namespace

tl::expected<HullCertificate, std::string> hull_certificate_of(const ExactMesh& mesh) {
  Summit summit = summit_of(mesh.points);
  std::vector<Point> all = mesh.points.points();
  all.push_back(std::move(summit.place));
  ExactMesh cones{PointSet(std::move(all)), facets_of(mesh.simplices)};
  for (Simplex& facet : cones.simplices) facet.push_back(static_cast<Vertex>(mesh.points.size()));
  auto points = scaled_to_integers(cones.points);
  if (!points) return tl::unexpected(points.error());
  const Claim claim = are_all_vertices(mesh) ? Claim::kTriangulation : Claim::kWeightedDelaunay;
  if (claim == Claim::kWeightedDelaunay) points->weights = weights_of_cones(*points);
  if (Sidedness(*points).orientation(summit.around) < 0) {
    std::swap(summit.around.front(), summit.around.back());
  }
  return HullCertificate{certificate_of(cones, claim, std::move(*points)),
                         std::move(summit.around)};
}

void write(std::ostream& out, const ExactMesh& mesh, const HullCertificate& certificate) {
  const std::vector<Vertex>& order = certificate.cones.order;
  const auto number = [&](Vertex v) {
    return std::find(order.begin(), order.end(), v) - order.begin() + 1;
  };
  Lines lines(out);
  write_first_line(lines, "circumspect-certificate 1", Claim::kConvexHull,
                   certificate.cones.points.dimension, name(certificate.cones.claim));
  write_mesh(lines, mesh, certificate.cones, 1);
  lines << "summit" << number(static_cast<Vertex>(mesh.points.size()));
  lines.gap();
  for (const Vertex v : certificate.around) lines << number(v);
  lines.end_line();
  lines << "end";
  lines.end_line();
}

}  // namespace circumspect::certificate
