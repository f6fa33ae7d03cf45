// Meshes and domains of the tests, and calls of the C interface that check the results.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <circumspect/circumspect.h>
#include <doctest/doctest.h>

namespace circumspect::c {

// The last point is a little inside the circle of the others.
inline const std::vector<double> kPoints = {0, 0, 1, 0, 0, 1, 0.9, 0.9};
inline const std::vector<std::int32_t> kRight = {0, 1, 3, 0, 3, 2};
inline const std::vector<std::int32_t> kWrong = {0, 1, 2, 1, 3, 2};

inline circumspect_mesh mesh_of(const std::vector<double>& points,
                                const std::vector<std::int32_t>& rows) {
  circumspect_mesh mesh = CIRCUMSPECT_MESH;
  mesh.dimension = 2;
  mesh.point_count = static_cast<std::int64_t>(points.size()) / 2;
  mesh.coordinates = points.data();
  mesh.simplex_count = static_cast<std::int64_t>(rows.size()) / 3;
  mesh.vertices_of_simplex = 3;
  mesh.simplices = rows.data();
  return mesh;
}

// The unit square with its outline.
inline const std::vector<double> kCorners = {0, 0, 1, 0, 1, 1, 0, 1};
inline const std::vector<std::int64_t> kOutline = {0, 1, 1, 2, 2, 3, 3, 0};

// A domain of the plane.
inline circumspect_domain of_segments(const std::vector<double>& points,
                                      const std::vector<std::int64_t>& segments) {
  circumspect_domain domain = CIRCUMSPECT_DOMAIN;
  domain.dimension = 2;
  domain.point_count = static_cast<std::int64_t>(points.size()) / 2;
  domain.coordinates = points.data();
  domain.segment_count = static_cast<std::int64_t>(segments.size()) / 2;
  domain.segments = segments.data();
  return domain;
}

inline circumspect_domain square() { return of_segments(kCorners, kOutline); }

struct FreeVerdict {
  void operator()(circumspect_verdict* verdict) const { circumspect_verdict_free(verdict); }
};
using OwnVerdict = std::unique_ptr<circumspect_verdict, FreeVerdict>;

struct Checked {
  circumspect_status status;
  OwnVerdict verdict;
};

inline Checked check(const char* claim, const circumspect_mesh* mesh,
                     const circumspect_domain* domain = nullptr,
                     const circumspect_options* options = nullptr) {
  circumspect_verdict* verdict = nullptr;
  const circumspect_status status = circumspect_check(claim, mesh, domain, options, &verdict);
  CHECK((status == CIRCUMSPECT_OK) == (verdict != nullptr));
  CHECK((status == CIRCUMSPECT_OK) == std::string(circumspect_last_error()).empty());
  CHECK((status == CIRCUMSPECT_OK) == std::string(circumspect_last_fault()).empty());
  return {status, OwnVerdict(verdict)};
}

inline bool has(const char* text, const std::string& part) {
  return std::string(text).find(part) != std::string::npos;
}

// A tetrahedron as a domain: four polygons of one line each.
inline const std::vector<double> kTetrahedron = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
inline const std::vector<std::int64_t> kStarts = {0, 1, 2, 3, 4};
inline const std::vector<std::int64_t> kLineStarts = {0, 3, 6, 9, 12};
inline const std::vector<std::int64_t> kFaces = {0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3};

// A domain of space: polygons of lines of corners.
inline circumspect_domain of_polygons(const std::vector<double>& points,
                                      const std::vector<std::int64_t>& polygon_starts,
                                      const std::vector<std::int64_t>& line_starts,
                                      const std::vector<std::int64_t>& corners) {
  circumspect_domain domain = CIRCUMSPECT_DOMAIN;
  domain.dimension = 3;
  domain.point_count = static_cast<std::int64_t>(points.size()) / 3;
  domain.coordinates = points.data();
  domain.polygon_count = static_cast<std::int64_t>(polygon_starts.size()) - 1;
  domain.polygon_starts = polygon_starts.data();
  domain.line_starts = line_starts.data();
  domain.corners = corners.data();
  return domain;
}

inline circumspect_domain tetrahedron() {
  return of_polygons(kTetrahedron, kStarts, kLineStarts, kFaces);
}

// How many tetrahedra, in the plane triangles, the triangulation of a domain has.
inline std::int64_t simplices_in(const circumspect_domain& domain) {
  circumspect_triangulation* built = nullptr;
  REQUIRE(circumspect_constrained_delaunay(&domain, &built) == CIRCUMSPECT_OK);
  const std::int64_t count =
      circumspect_triangulation_simplices(built, domain.dimension + 1, nullptr);
  circumspect_triangulation_free(built);
  return count;
}

inline void check_refused(const circumspect_domain& domain, circumspect_status status,
                          const std::string& message) {
  circumspect_triangulation* built = nullptr;
  CHECK(circumspect_constrained_delaunay(&domain, &built) == status);
  CHECK(built == nullptr);
  INFO(circumspect_last_error());
  CHECK(has(circumspect_last_error(), message));
}

}  // namespace circumspect::c
