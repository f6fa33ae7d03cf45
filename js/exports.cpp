// The C interface as JavaScript calls it: counts are 32-bit numbers, and what C has as a struct is
// made by one call. Arrays are the caller's, and must live as long as what was made of them.
#include <cstdint>
#include <memory>
#include <vector>

#include <circumspect/circumspect.h>

#define EXPORT(name) __attribute__((export_name(#name))) extern "C"

namespace {

// 64-bit indices, which C takes of a domain.
using Indices = std::vector<std::int64_t>;

Indices widened(const std::int32_t* from, std::int32_t count) { return {from, from + count}; }

const std::int64_t* data(const Indices& indices) {
  return indices.empty() ? nullptr : indices.data();
}

struct Domain {
  circumspect_domain view = CIRCUMSPECT_DOMAIN;
  Indices segments = {};
  Indices polygon_starts = {};
  Indices line_starts = {};
  Indices corners = {};
  Indices polygons_of_holes = {};
};

}  // namespace

EXPORT(mesh_new)
circumspect_mesh* mesh_new(std::int32_t dimension, std::int32_t points, const double* coordinates,
                           const char* const* exact_coordinates, const double* weights,
                           const char* const* exact_weights, std::int32_t simplices,
                           std::int32_t vertices_of_simplex, std::int32_t index_bytes,
                           const void* indices) {
  auto* mesh = new circumspect_mesh CIRCUMSPECT_MESH;
  mesh->dimension = dimension;
  mesh->point_count = points;
  mesh->coordinates = coordinates;
  mesh->exact_coordinates = exact_coordinates;
  mesh->weights = weights;
  mesh->exact_weights = exact_weights;
  mesh->simplex_count = simplices;
  mesh->vertices_of_simplex = vertices_of_simplex;
  mesh->index_bytes = index_bytes;
  mesh->simplices = indices;
  return mesh;
}

EXPORT(mesh_delete) void mesh_delete(circumspect_mesh* mesh) { delete mesh; }

// Facts of a mesh that C made: a drawing's.
EXPORT(mesh_points) std::int32_t mesh_points(const circumspect_mesh* mesh) {
  return static_cast<std::int32_t>(mesh->point_count);
}
EXPORT(mesh_coordinates) const double* mesh_coordinates(const circumspect_mesh* mesh) {
  return mesh->coordinates;
}
EXPORT(mesh_weights) const double* mesh_weights(const circumspect_mesh* mesh) {
  return mesh->weights;
}

EXPORT(domain_new)
Domain* domain_new(std::int32_t dimension, std::int32_t points, const double* coordinates,
                   const char* const* exact_coordinates, std::int32_t kind,
                   std::int32_t merge_coplanar) {
  auto domain = std::make_unique<Domain>();
  domain->view.dimension = dimension;
  domain->view.point_count = points;
  domain->view.coordinates = coordinates;
  domain->view.exact_coordinates = exact_coordinates;
  domain->view.kind = kind;
  domain->view.merge_coplanar = merge_coplanar;
  return domain.release();
}

EXPORT(domain_segments)
void domain_segments(Domain* domain, std::int32_t count, const std::int32_t* ends) {
  domain->segments = widened(ends, 2 * count);
  domain->view.segment_count = count;
  domain->view.segments = data(domain->segments);
}

// As circumspect_domain has them: lines of polygons, and corners of lines.
EXPORT(domain_polygons)
void domain_polygons(Domain* domain, std::int32_t polygons, const std::int32_t* polygon_starts,
                     std::int32_t lines, const std::int32_t* line_starts, std::int32_t corners,
                     const std::int32_t* of_lines) {
  domain->polygon_starts = widened(polygon_starts, polygons + 1);
  domain->line_starts = widened(line_starts, lines + 1);
  domain->corners = widened(of_lines, corners);
  domain->view.polygon_count = polygons;
  domain->view.polygon_starts = data(domain->polygon_starts);
  domain->view.line_starts = data(domain->line_starts);
  domain->view.corners = data(domain->corners);
}

EXPORT(domain_holes)
void domain_holes(Domain* domain, std::int32_t count, const double* seeds,
                  const char* const* exact_seeds) {
  domain->view.hole_count = count;
  domain->view.hole_seeds = seeds;
  domain->view.exact_hole_seeds = exact_seeds;
}

EXPORT(domain_regions)
void domain_regions(Domain* domain, std::int32_t count, const double* seeds,
                    const char* const* exact_seeds) {
  domain->view.region_count = count;
  domain->view.region_seeds = seeds;
  domain->view.exact_region_seeds = exact_seeds;
}

EXPORT(domain_polygon_holes)
void domain_polygon_holes(Domain* domain, std::int32_t count, const std::int32_t* polygons,
                          const double* seeds, const char* const* exact_seeds) {
  domain->polygons_of_holes = widened(polygons, count);
  domain->view.polygon_hole_count = count;
  domain->view.polygons_of_holes = data(domain->polygons_of_holes);
  domain->view.polygon_hole_seeds = seeds;
  domain->view.exact_polygon_hole_seeds = exact_seeds;
}

EXPORT(domain_delete) void domain_delete(Domain* domain) { delete domain; }

EXPORT(check)
circumspect_status check(const char* claim, const circumspect_mesh* mesh, const Domain* domain,
                         std::int32_t max_violations, std::int32_t by_definition,
                         std::int32_t oriented, const char* within, const char* name,
                         std::int32_t with_pictures, std::int32_t merge_equal_points,
                         std::int32_t allow_empty, const char* demands, std::int32_t require_count,
                         const char* const* require, const char* except_sharp, double seconds,
                         circumspect_verdict** verdict) {
  circumspect_options options = CIRCUMSPECT_OPTIONS;
  options.threads = 1;
  options.max_violations = max_violations;
  options.by_definition = by_definition;
  options.oriented = oriented;
  options.within = within;
  options.mesh_name = name;
  options.with_pictures = with_pictures;
  options.merge_equal_points = merge_equal_points;
  options.allow_empty = allow_empty;
  options.demands = demands;
  options.require_count = require_count;
  options.require = require;
  options.except_sharp = except_sharp;
  circumspect_end_calls_after(seconds, nullptr);
  const circumspect_status status = circumspect_check(
      claim, mesh, domain == nullptr ? nullptr : &domain->view, &options, verdict);
  circumspect_end_calls_after(0, nullptr);
  return status;
}

EXPORT(verdict_delete) void verdict_delete(circumspect_verdict* verdict) {
  circumspect_verdict_free(verdict);
}
EXPORT(verdict_holds) std::int32_t verdict_holds(const circumspect_verdict* verdict) {
  return circumspect_verdict_holds(verdict);
}
EXPORT(verdict_unique) std::int32_t verdict_unique(const circumspect_verdict* verdict) {
  return circumspect_verdict_unique(verdict);
}
EXPORT(verdict_canonical) std::int32_t verdict_canonical(const circumspect_verdict* verdict) {
  return circumspect_verdict_canonical(verdict);
}
EXPORT(verdict_text) const char* verdict_text(const circumspect_verdict* verdict) {
  return circumspect_verdict_text(verdict);
}
EXPORT(verdict_json) const char* verdict_json(const circumspect_verdict* verdict) {
  return circumspect_verdict_json(verdict);
}
EXPORT(verdict_note)
const char* verdict_note(const circumspect_verdict* verdict, std::int32_t index) {
  return circumspect_verdict_note(verdict, index);
}
EXPORT(verdict_page)
circumspect_status verdict_page(const circumspect_verdict* verdict, circumspect_document** page) {
  return circumspect_verdict_page(verdict, page);
}

EXPORT(generate)
circumspect_status generate(const char* family, std::int32_t dimension, std::int32_t points,
                            double seed, circumspect_drawing** drawing) {
  return circumspect_generate(family, dimension, points, static_cast<std::uint64_t>(seed), drawing);
}
EXPORT(drawing_mesh) const circumspect_mesh* drawing_mesh(const circumspect_drawing* drawing) {
  return circumspect_drawing_mesh(drawing);
}
EXPORT(drawing_delete) void drawing_delete(circumspect_drawing* drawing) {
  circumspect_drawing_free(drawing);
}

EXPORT(delaunay)
circumspect_status delaunay(const circumspect_mesh* points,
                            circumspect_triangulation** triangulation) {
  return circumspect_delaunay(points, triangulation);
}
EXPORT(constrained_delaunay)
circumspect_status constrained_delaunay(const Domain* domain,
                                        circumspect_triangulation** triangulation) {
  return circumspect_constrained_delaunay(&domain->view, triangulation);
}
EXPORT(triangulation_dimension)
std::int32_t triangulation_dimension(const circumspect_triangulation* triangulation) {
  return static_cast<std::int32_t>(circumspect_triangulation_dimension(triangulation));
}
EXPORT(triangulation_count)
std::int32_t triangulation_count(const circumspect_triangulation* triangulation,
                                 std::int32_t vertices) {
  return static_cast<std::int32_t>(
      circumspect_triangulation_simplices(triangulation, vertices, nullptr));
}
// Requires: room for triangulation_count(…) · vertices indices.
EXPORT(triangulation_copy)
void triangulation_copy(const circumspect_triangulation* triangulation, std::int32_t vertices,
                        std::int32_t* to) {
  const std::int64_t* indices = nullptr;
  const std::int64_t count = circumspect_triangulation_simplices(triangulation, vertices, &indices);
  for (std::int64_t i = 0; i < count * vertices; ++i) to[i] = static_cast<std::int32_t>(indices[i]);
}
EXPORT(triangulation_delete) void triangulation_delete(circumspect_triangulation* triangulation) {
  circumspect_triangulation_free(triangulation);
}

EXPORT(orientation)
circumspect_status orientation(std::int32_t dimension, const double* coordinates, int* sign) {
  return circumspect_orientation(dimension, coordinates, sign);
}
EXPORT(orientation_exact)
circumspect_status orientation_exact(std::int32_t dimension, const char* const* coordinates,
                                     int* sign) {
  return circumspect_orientation_exact(dimension, coordinates, sign);
}
EXPORT(in_ball)
circumspect_status in_ball(std::int32_t dimension, const double* coordinates, int* sign) {
  return circumspect_in_ball(dimension, coordinates, sign);
}
EXPORT(in_ball_exact)
circumspect_status in_ball_exact(std::int32_t dimension, const char* const* coordinates,
                                 int* sign) {
  return circumspect_in_ball_exact(dimension, coordinates, sign);
}

EXPORT(compare)
circumspect_status compare(const circumspect_mesh* a, const circumspect_mesh* b, int* same,
                           circumspect_document** document) {
  return circumspect_compare(a, b, same, document);
}
EXPORT(certify)
circumspect_status certify(const char* claim, const circumspect_mesh* mesh, int* holds,
                           circumspect_document** document) {
  return circumspect_certify(claim, mesh, holds, document);
}
EXPORT(document_text) const char* document_text(const circumspect_document* document) {
  return circumspect_document_text(document);
}
EXPORT(document_delete) void document_delete(circumspect_document* document) {
  circumspect_document_free(document);
}

EXPORT(last_fault) const char* last_fault() { return circumspect_last_fault(); }
EXPORT(last_option) const char* last_option() { return circumspect_last_option(); }
EXPORT(version) const char* version() { return circumspect_version(); }
