#include "oracle/certificate/surface_certificate.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "oracle/certificate/certificate.hpp"

namespace circumspect::certificate {
namespace {

constexpr std::uint32_t kTriangle = 3;

}  // namespace

SurfaceCertificate surface_certificate_of(const ExactMesh& mesh, ScaledPoints points) {
  SurfaceCertificate made{.points = std::move(points)};
  made.order = lexicographic_order(made.points);
  const std::vector<std::size_t> number = numbers_in(made.order);
  const auto key = [&](const SurfaceCertificate::Edge& edge) {
    const Simplex& triangle = mesh.simplices[edge.triangle];
    const auto at = [&](std::uint32_t place) {
      return number[static_cast<std::size_t>(triangle[place % kTriangle])];
    };
    const auto ends = std::minmax({at(edge.place + 1), at(edge.place + 2)});
    return std::array<std::size_t, 3>{ends.first, ends.second, at(edge.place)};
  };
  std::vector<std::pair<std::array<std::size_t, 3>, SurfaceCertificate::Edge>> keyed;
  keyed.reserve(kTriangle * mesh.simplices.size());
  for (std::uint32_t t = 0; t < mesh.simplices.size(); ++t) {
    for (std::uint32_t i = 0; i < kTriangle; ++i) keyed.push_back({key({t, i}), {t, i}});
  }
  std::sort(keyed.begin(), keyed.end(),
            [](const auto& one, const auto& other) { return one.first < other.first; });
  for (const auto& [_, edge] : keyed) made.edges.push_back(edge);
  return made;
}

void write(std::ostream& out, const ExactMesh& mesh, const SurfaceCertificate& certificate) {
  Lines lines(out);
  write_first_line(lines, "circumspect-certificate 1", Claim::kSurfaceDelaunay,
                   certificate.points.dimension);
  write_scale(lines, certificate.points);
  write_points(lines, mesh, certificate.points, certificate.order);
  const std::vector<std::size_t> number = numbers_in(certificate.order);
  std::vector<std::array<std::size_t, kTriangle>> listed(mesh.simplices.size());
  for (std::size_t k = 0; k < certificate.edges.size(); ++k) {
    listed[certificate.edges[k].triangle][certificate.edges[k].place] = k + 1;
  }
  begin_section(lines, "triangles", mesh.simplices.size());
  for (std::size_t t = 0; t < mesh.simplices.size(); ++t) {
    for (const Vertex v : mesh.simplices[t]) lines << number[static_cast<std::size_t>(v)];
    lines.gap();
    for (const std::size_t k : listed[t]) lines << k;
    lines.end_line();
  }
  begin_section(lines, "edges", certificate.edges.size());
  for (const SurfaceCertificate::Edge& edge : certificate.edges) {
    lines << std::size_t{edge.triangle} + 1 << std::size_t{edge.place};
    lines.end_line();
  }
  lines << "end";
  lines.end_line();
}

}  // namespace circumspect::certificate
