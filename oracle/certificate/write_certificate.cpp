// Numbers count from 1, positions of vertices in their simplex from 0: proofs/CERTIFICATE.md.
#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/lines.hpp"

namespace circumspect::certificate {
namespace {

void write_points(Lines& lines, const ExactMesh& mesh, const Certificate& certificate) {
  lines << "points" << certificate.order.size();
  lines.end_line();
  for (const Vertex v : certificate.order) {
    write_point(lines, certificate.points, v, certificate.claim == Claim::kWeightedDelaunay);
    const Incidence& incidence = certificate.incidences[static_cast<std::size_t>(v)];
    lines.gap() << incidence.simplex + 1;
    if (incidence.place) {
      lines << *incidence.place;
    } else {
      lines << "-";
    }
    lines << mesh.label(v);
    lines.end_line();
  }
}

void write_across(Lines& lines, const Across& across) {
  if (across.place == Across::kHull) {
    lines << "-" << across.cell + 1;
  } else {
    lines << across.cell + 1 << across.place;
  }
}

void write_simplices(Lines& lines, const Certificate& certificate) {
  std::vector<std::size_t> number(certificate.order.size());
  for (std::size_t i = 0; i < number.size(); ++i) {
    number[static_cast<std::size_t>(certificate.order[i])] = i + 1;
  }
  const std::size_t size = certificate.points.dimension + 1;
  lines << "simplices" << certificate.simplices.size();
  lines.end_line();
  for (const CertifiedSimplex& simplex : certificate.simplices) {
    for (std::size_t i = 0; i < size; ++i) {
      lines << number[static_cast<std::size_t>(simplex.vertices[i])];
    }
    lines.gap();
    for (std::size_t i = 0; i < size; ++i) write_across(lines, simplex.across[i]);
    lines.gap();
    if (simplex.separating) {
      lines << *simplex.separating;
    } else {
      lines << "-";
    }
    lines.end_line();
  }
}

void write_hull(Lines& lines, const Certificate& certificate) {
  lines << "hull" << certificate.hull.size();
  lines.end_line();
  for (const HullFacet& facet : certificate.hull) {
    lines << facet.simplex + 1 << facet.place;
    lines.gap();
    for (std::size_t a = 0; a < certificate.points.dimension; ++a) {
      write_across(lines, facet.across[a]);
    }
    lines.end_line();
  }
}

}  // namespace

void write_mesh(Lines& lines, const ExactMesh& mesh, const Certificate& certificate) {
  write_scale(lines, certificate.points);
  write_points(lines, mesh, certificate);
  write_simplices(lines, certificate);
  write_hull(lines, certificate);
  lines << "sample" << 1;
  write_point(lines, certificate.sample);
  lines.end_line();
}

void write(std::ostream& out, const ExactMesh& mesh, const Certificate& certificate) {
  Lines lines(out);
  write_first_line(lines, "circumspect-certificate 1", certificate.claim,
                   certificate.points.dimension, certificate.standing);
  write_mesh(lines, mesh, certificate);
  lines << "end";
  lines.end_line();
}

}  // namespace circumspect::certificate
