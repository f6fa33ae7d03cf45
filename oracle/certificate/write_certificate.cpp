// Numbers count from 1, positions of vertices in their simplex from 0: proofs/CERTIFICATE.md.
#include <numeric>

#include <fmt/format.h>

#include "oracle/certificate/certificate.hpp"
#include "oracle/certificate/document.hpp"
#include "oracle/certificate/domain_certificate.hpp"

namespace circumspect::certificate {

namespace {

// Or a dash in its place.
template <class Number>
void write_optional(Lines& lines, const std::optional<Number>& number) {
  if (number) {
    lines << *number;
  } else {
    lines << "-";
  }
}

template <class AnyMesh>
void write_points(Lines& lines, const AnyMesh& mesh, const Certificate& certificate,
                  std::size_t helpers) {
  begin_section(lines, "points", certificate.order.size());
  for (const Vertex v : certificate.order) {
    write_point(lines, certificate.points, v, certificate.claim == Claim::kWeightedDelaunay);
    const Incidence& incidence = certificate.incidences[static_cast<std::size_t>(v)];
    lines.gap() << incidence.simplex + 1;
    write_optional(lines, incidence.place);
    if (static_cast<std::size_t>(v) + helpers < certificate.order.size()) {
      lines << mesh.label(v);
    } else {
      lines << "-";
    }
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
  const std::vector<std::size_t> number = numbers_in(certificate.order);
  const std::size_t size = certificate.points.dimension + 1;
  begin_section(lines, "simplices", certificate.simplices.size());
  for (const CertifiedSimplex& simplex : certificate.simplices) {
    for (std::size_t i = 0; i < size; ++i) {
      lines << number[static_cast<std::size_t>(simplex.vertices[i])];
    }
    lines.gap();
    for (std::size_t i = 0; i < size; ++i) write_across(lines, simplex.across[i]);
    lines.gap();
    write_optional(lines, simplex.separating);
    lines.end_line();
  }
}

void write_hull(Lines& lines, const Certificate& certificate) {
  begin_section(lines, "hull", certificate.hull.size());
  for (const HullFacet& facet : certificate.hull) {
    lines << facet.simplex + 1 << facet.place;
    lines.gap();
    for (std::size_t a = 0; a < certificate.points.dimension; ++a) {
      write_across(lines, facet.across[a]);
    }
    lines.end_line();
  }
}

template <class AnyMesh>
void write_any_mesh(Lines& lines, const AnyMesh& mesh, const Certificate& certificate,
                    std::size_t helpers) {
  write_scale(lines, certificate.points);
  write_points(lines, mesh, certificate, helpers);
  write_simplices(lines, certificate);
  write_hull(lines, certificate);
  lines << "sample" << 1;
  write_point(lines, certificate.sample);
  lines.end_line();
}

template <class AnyMesh>
void write_whole(std::ostream& out, const AnyMesh& mesh, const Certificate& certificate) {
  Lines lines(out);
  write_first_line(lines, "circumspect-certificate 1", certificate.claim,
                   certificate.points.dimension, certificate.standing);
  write_any_mesh(lines, mesh, certificate, 0);
  lines << "end";
  lines.end_line();
}

}  // namespace

void write_mesh(Lines& lines, const ExactMesh& mesh, const Certificate& certificate,
                std::size_t helpers) {
  write_any_mesh(lines, mesh, certificate, helpers);
}

void write(std::ostream& out, const ExactMesh& mesh, const Certificate& certificate) {
  write_whole(out, mesh, certificate);
}

void write(std::ostream& out, const Mesh& mesh, const Certificate& certificate) {
  write_whole(out, mesh, certificate);
}

namespace {

void write_mark(Lines& lines, const Mark& mark, std::size_t size) {
  lines << (mark.rank == 0 ? "+" : "-");
  for (std::size_t i = 0; i < size; ++i) {
    if (mark.flags[i]) {
      lines << mark.flags[i]->first + 1 << mark.flags[i]->second + 1;
    } else {
      lines << "-";
    }
  }
  if (mark.rank != 0) {
    if (mark.hole) {
      lines << "hole" << *mark.hole + 1;
    } else {
      lines << (mark.rank == 1 ? "out" : "across") << mark.place;
    }
    lines << mark.rank;
  }
  lines.end_line();
}

void write_part(Lines& lines, const Certificate& mesh, const DomainPart& part) {
  const std::vector<std::size_t> number = numbers_in(mesh.order);
  const auto of = [&](Vertex v) { return number[static_cast<std::size_t>(v)]; };
  begin_section(lines, "roles", mesh.order.size());
  for (const Vertex v : mesh.order) {
    const Role& role = part.roles[static_cast<std::size_t>(v)];
    if (role.corner_of) {
      lines << *role.corner_of + 1;
    } else {
      lines << "-";
      for (const auto& [weight, vertex] : role.weights) lines << weight << of(vertex);
    }
    lines.end_line();
  }
  begin_section(lines, "segments", part.segments.size());
  for (const SegmentSteps& segment : part.segments) {
    lines << of(segment.from);
    for (const Step& step : segment.steps) {
      lines.gap() << of(step.reached) << step.simplex + 1 << step.place;
    }
    lines.end_line();
  }
  begin_section(lines, "holes", part.holes.size());
  for (const Hole& hole : part.holes) {
    lines << hole.simplex + 1;
    write_point(lines, hole.seed);
    lines.end_line();
  }
  begin_section(lines, "marks", part.marks.size());
  for (const Mark& mark : part.marks) write_mark(lines, mark, mesh.points.dimension + 1);
}

void write_polygon(Lines& lines, const std::vector<std::size_t>& number,
                   const PolygonCertificate& polygon) {
  lines << "polygon";
  for (const Integer& x : polygon.normal) lines << x;
  lines << polygon.offset << polygon.axis;
  lines.end_line();
  write_mesh(lines, polygon.mesh, polygon.plane);
  write_part(lines, polygon.plane, polygon.part);
  begin_section(lines, "above", polygon.plane.order.size());
  for (const Vertex v : polygon.plane.order) {
    lines << number[static_cast<std::size_t>(polygon.above[static_cast<std::size_t>(v)])];
    lines.end_line();
  }
  begin_section(lines, "tiles", polygon.plane.simplices.size());
  for (std::size_t t = 0; t < polygon.plane.simplices.size(); ++t) {
    if (t < polygon.tiles.size()) {
      lines << polygon.tiles[t].first + 1 << polygon.tiles[t].second;
    } else {
      lines << "-";
    }
    lines.end_line();
  }
  begin_section(lines, "seeds", polygon.seeds.size());
  for (const HomogeneousPoint& seed : polygon.seeds) {
    write_point(lines, seed);
    lines.end_line();
  }
}

// By the numbers of the vertices: the faces of which a vertex has the least.
void write_complex(Lines& lines, const std::vector<std::size_t>& number,
                   const ComplexPart& complex) {
  std::vector<std::vector<std::pair<Simplex, Holder>>> faces(number.size());
  for (const auto& [face, holder] : complex.faces) {
    Simplex numbers;
    for (const Vertex v : face) {
      numbers.push_back(static_cast<Vertex>(number[static_cast<std::size_t>(v)]));
    }
    numbers = sorted(numbers);
    const auto least = static_cast<std::size_t>(numbers.front() - 1);
    numbers.erase(numbers.begin());
    faces[least].emplace_back(std::move(numbers), holder);
  }
  begin_section(lines, "faces", faces.size());
  for (const auto& at_vertex : faces) {
    for (const auto& [others, holder] : at_vertex) {
      lines.gap() << (holder.is_segment ? "segment" : "polygon") << holder.number + 1
                  << others.size();
      for (const Vertex v : others) lines << v;
    }
    if (at_vertex.empty()) lines << "-";
    lines.end_line();
  }
  const auto sides = [](bool one) { return one ? "one" : "both"; };
  begin_section(lines, "sides", complex.one_sided.size());
  for (const bool one : complex.one_sided) {
    lines << sides(one);
    lines.end_line();
  }
  for (const PolygonFaces& polygon : complex.polygons) {
    begin_section(lines, "rim", polygon.rim.size());
    for (const auto& [segment, one] : polygon.rim) {
      lines << segment + 1 << sides(one);
      lines.end_line();
    }
    begin_section(lines, "inside", polygon.segments.size());
    for (const auto& [segment, pieces] : polygon.segments) {
      lines << segment + 1;
      for (const std::size_t piece : pieces) lines << piece + 1;
      lines.end_line();
    }
  }
}

// The mesh of the whole hull, and how the domain lies in it.
void write_body(Lines& lines, const DomainCertificate& certificate) {
  write_mesh(lines, certificate.whole, certificate.mesh, certificate.helpers);
  write_part(lines, certificate.mesh, certificate.part);
  if (certificate.mesh.points.dimension != 3) return;
  begin_section(lines, "polygons", certificate.polygons.size());
  const std::vector<std::size_t> number = numbers_in(certificate.mesh.order);
  for (const PolygonCertificate& polygon : certificate.polygons) {
    write_polygon(lines, number, polygon);
  }
}

// A triangle that dangles in a CDT: the whole mesh is said to be Delaunay.
bool shows_that_triangles_are_delaunay(const DomainCertificate& certificate) {
  return certificate.dangles && certificate.mesh.claim == Claim::kDelaunay &&
         certificate.claim != Claim::kConformingDelaunay;
}

}  // namespace

void write(std::ostream& out, const DomainCertificate& certificate) {
  Lines lines(out);
  write_first_line(
      lines, "circumspect-certificate 1", certificate.claim, certificate.mesh.points.dimension,
      fmt::format("{}{}{}", certificate.kind == DomainKind::kHull ? "hull" : "enclosed",
                  certificate.complex ? " plc" : "", certificate.dangles ? " dangling" : "") +
          (shows_that_triangles_are_delaunay(certificate) ? " delaunay" : ""));
  write_body(lines, certificate);
  if (certificate.complex) {
    write_complex(lines, numbers_in(certificate.mesh.order), *certificate.complex);
  }
  lines << "end";
  lines.end_line();
}

namespace {

// The segments, hole points and polygons of a domain with so many vertices.
void write_domain(Lines& lines, std::size_t vertices, const std::vector<Simplex>& segments,
                  const std::vector<HomogeneousPoint>& holes,
                  const std::vector<PolygonCertificate>& polygons) {
  begin_section(lines, "segments", segments.size());
  for (const Simplex& segment : segments) {
    lines << segment[0] + 1 << segment[1] + 1;
    lines.end_line();
  }
  begin_section(lines, "holes", holes.size());
  for (const HomogeneousPoint& hole : holes) {
    write_point(lines, hole);
    lines.end_line();
  }
  std::vector<std::size_t> number(vertices);
  std::iota(number.begin(), number.end(), std::size_t{1});
  begin_section(lines, "polygons", polygons.size());
  for (const PolygonCertificate& polygon : polygons) write_polygon(lines, number, polygon);
}

// The points are counted on after those of the mesh.
void write_dangling(Lines& lines, std::size_t points, const std::vector<DanglingFace>& dangling) {
  std::size_t count = 0;
  for (const DanglingFace& entry : dangling) count += entry.pads.size();
  begin_section(lines, "pads", count);
  for (const DanglingFace& entry : dangling) {
    for (const std::vector<Integer>& pad : entry.pads) {
      for (const Integer& x : pad) lines << x;
      lines.end_line();
    }
  }
  begin_section(lines, "dangling", dangling.size());
  for (const DanglingFace& entry : dangling) {
    lines << entry.face.size();
    lines.gap();
    for (const Vertex v : entry.face) lines << to_integer(v) + 1;
    lines.gap();
    for (std::size_t i = 0; i < entry.pads.size(); ++i) lines << ++points;
    lines.end_line();
  }
}

void write_because(Lines& lines, const WholeEvidence& evidence) {
  lines << "because" << evidence.because;
  lines.end_line();
  lines << "end";
  lines.end_line();
}

std::string_view name_of(DomainKind kind) {
  return kind == DomainKind::kHull ? "hull" : "enclosed";
}

}  // namespace

void write(std::ostream& out, const ExactMesh& mesh, const DomainRefutation& refutation) {
  Lines lines(out);
  const auto& whole = refutation.whole;
  write_mesh(lines, mesh, refutation.points, refutation.refutation,
             whole ? fmt::format("{} {}", whole->evidence.word, name_of(whole->kind)) : "");
  write_basis(lines, refutation.refutation.basis);
  if (!refutation.dangling.empty()) write_dangling(lines, mesh.points.size(), refutation.dangling);
  if (whole && whole->evidence.elsewhere) {
    write_body(lines, *whole->evidence.elsewhere);
    write_because(lines, whole->evidence);
    return;
  }
  begin_section(lines, "vertices", refutation.vertices.size());
  for (const Vertex v : refutation.vertices) {
    write_point(lines, refutation.points, v, false);
    lines.end_line();
  }
  if (!whole) {
    begin_section(lines, "segments", refutation.segments.size());
    for (const Simplex& segment : refutation.segments) {
      lines << segment[0] + 1 << segment[1] + 1;
      lines.end_line();
    }
    write_because(lines, refutation.refutation.because);
    return;
  }
  write_domain(lines, refutation.vertices.size(), refutation.segments, whole->holes,
               whole->polygons);
  write_because(lines, whole->evidence);
}

void write(std::ostream& out, const Impossibility& impossibility) {
  Lines lines(out);
  write_first_line(lines, "circumspect-impossibility 2", impossibility.claim, 3,
                   name_of(impossibility.kind));
  write_scale(lines, impossibility.points);
  begin_section(lines, "vertices", impossibility.points.size());
  for (Vertex v = 0; static_cast<std::size_t>(v) < impossibility.points.size(); ++v) {
    write_point(lines, impossibility.points, v, false);
    lines.end_line();
  }
  write_domain(lines, impossibility.points.size(), impossibility.segments, impossibility.holes,
               impossibility.polygons);
  lines << "mesh";
  lines.end_line();
  write_body(lines, impossibility.mesh);
  begin_section(lines, "candidates", impossibility.fates.size());
  for (const std::string& fate : impossibility.fates) {
    lines << fate;
    lines.end_line();
  }
  begin_section(lines, "clauses", impossibility.reasons.size());
  for (const std::string& reason : impossibility.reasons) {
    lines << reason;
    lines.end_line();
  }
  begin_section(lines, "steps", impossibility.steps.size());
  for (const ProofStep& step : impossibility.steps) {
    for (const int literal : step.clause) lines << literal;
    lines << 0;
    lines.gap();
    for (const std::size_t hint : step.hints) lines << hint;
    lines.end_line();
  }
  lines << "end";
  lines.end_line();
}

}  // namespace circumspect::certificate
