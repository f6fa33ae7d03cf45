#include "oracle/certificate/line_certificate.hpp"

#include <algorithm>
#include <utility>

#include "kernel/predicates/configuration.hpp"

namespace circumspect::certificate {

LineCertificate line_certificate_of(const ExactMesh& mesh, Claim claim, ScaledPoints points) {
  LineCertificate made{claim, std::move(points), {}};
  made.order = lexicographic_order(made.points);
  const std::vector<std::size_t> number = numbers_in(made.order);
  made.joining.resize(made.order.size() - 1);
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    const Simplex& edge = mesh.simplices[s];
    if (edge.size() != 2) continue;  // the simplex of one point
    const std::size_t first = std::min(number[static_cast<std::size_t>(edge[0])],
                                       number[static_cast<std::size_t>(edge[1])]);
    made.joining[first - 1] = s;
  }
  return made;
}

void write_pads(Lines& lines, const ExactMesh& mesh, const ScaledPoints& points) {
  const AffineHull& hull = mesh.points.configuration().hull();
  const std::size_t dimension = points.dimension;
  begin_section(lines, "pads", dimension - hull.axes.size());
  for (std::size_t along = 0; along < dimension; ++along) {
    if (std::find(hull.axes.begin(), hull.axes.end(), along) != hull.axes.end()) continue;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      const Integer& x = points.coordinate(static_cast<Vertex>(hull.basis.front()), axis);
      lines << Integer(axis == along ? x + 1 : x);
    }
    lines.end_line();
  }
}

void write(std::ostream& out, const ExactMesh& mesh, const LineCertificate& certificate) {
  Lines lines(out);
  write_first_line(lines, "circumspect-certificate 1", certificate.claim,
                   certificate.points.dimension, "line");
  write_scale(lines, certificate.points);
  write_points(lines, mesh, certificate.points, certificate.order);
  const std::vector<std::size_t> number = numbers_in(certificate.order);
  begin_section(lines, "simplices", mesh.simplices.size());
  for (const Simplex& simplex : mesh.simplices) {
    for (const Vertex v : simplex) lines << number[static_cast<std::size_t>(v)];
    lines.end_line();
  }
  begin_section(lines, "order", certificate.joining.size());
  for (const std::size_t s : certificate.joining) {
    lines << s + 1;
    lines.end_line();
  }
  write_pads(lines, mesh, certificate.points);
  lines << "end";
  lines.end_line();
}

}  // namespace circumspect::certificate
