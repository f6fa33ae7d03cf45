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

inline circumspect_domain square() {
  circumspect_domain domain = CIRCUMSPECT_DOMAIN;
  domain.dimension = 2;
  domain.point_count = 4;
  domain.coordinates = kCorners.data();
  domain.segment_count = 4;
  domain.segments = kOutline.data();
  return domain;
}

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

inline circumspect_domain tetrahedron() {
  circumspect_domain domain = CIRCUMSPECT_DOMAIN;
  domain.dimension = 3;
  domain.point_count = 4;
  domain.coordinates = kTetrahedron.data();
  domain.polygon_count = 4;
  domain.polygon_starts = kStarts.data();
  domain.line_starts = kLineStarts.data();
  domain.corners = kFaces.data();
  return domain;
}

}  // namespace circumspect::c
