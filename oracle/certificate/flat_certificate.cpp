#include "oracle/certificate/flat_certificate.hpp"

#include <utility>

#include "kernel/predicates/configuration.hpp"

namespace circumspect::certificate {
namespace {

Triple<Integer> place(const ScaledPoints& points, std::size_t v) {
  const auto at = static_cast<Vertex>(v);
  return {points.coordinate(at, 0), points.coordinate(at, 1), points.coordinate(at, 2)};
}

}  // namespace

FlatCertificate flat_certificate_of(const ExactMesh& mesh, Claim claim, ScaledPoints points) {
  const std::vector<std::size_t>& basis = mesh.points.configuration().hull().basis;
  const Triple<Integer> origin = place(points, basis[0]);
  const Triple<Integer> normal = cross_product(difference(place(points, basis[1]), origin),
                                               difference(place(points, basis[2]), origin));
  std::size_t axis = 2;
  while (normal[axis] == 0) --axis;
  const bool is_delaunay = claim == Claim::kDelaunay;
  ScaledPoints seen{2, points.scale_numerator, points.scale_denominator};
  std::vector<Integer> unseen;
  for (std::size_t v = 0; v < points.size(); ++v) {
    Triple<Integer> point = place(points, v);
    for (std::size_t i = 0; i < 3; ++i) {
      if (i != axis) seen.coordinates.push_back(std::move(point[i]));
    }
    if (is_delaunay) seen.weights.push_back(-(point[axis] * point[axis]));
    unseen.push_back(std::move(point[axis]));
  }
  return {certificate_of(mesh, is_delaunay ? Claim::kWeightedDelaunay : claim, std::move(seen)),
          axis, std::move(unseen), normal, inner_product(normal, origin)};
}

void write(std::ostream& out, const ExactMesh& mesh, const FlatCertificate& certificate) {
  const bool is_delaunay = certificate.seen.claim == Claim::kWeightedDelaunay;
  Lines lines(out);
  write_first_line(lines, "circumspect-certificate 1",
                   is_delaunay ? Claim::kDelaunay : certificate.seen.claim, 3, "flat");
  write_mesh(lines, mesh, certificate.seen);
  lines << "flat" << certificate.axis;
  for (const Integer& x : certificate.normal) lines << x;
  lines << certificate.offset;
  lines.end_line();
  begin_section(lines, "unseen", certificate.unseen.size());
  for (const Vertex v : certificate.seen.order) {
    lines << certificate.unseen[static_cast<std::size_t>(v)];
    lines.end_line();
  }
  lines << "end";
  lines.end_line();
}

}  // namespace circumspect::certificate
