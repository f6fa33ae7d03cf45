// Everything but verdicts: references, predicates, comparisons, certificates.
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <circumspect/circumspect.h>
#include <fmt/format.h>

#include "c/guard.hpp"
#include "c/input.hpp"
#include "inputs/cases.hpp"
#include "inputs/families.hpp"
#include "inputs/family_faults.hpp"
#include "inputs/in_doubles.hpp"
#include "inputs/triangulated/domain_families.hpp"
#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"
#include "oracle/certificate/document.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/mesh_difference.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/model/printable.hpp"
#include "oracle/report/json.hpp"
#include "oracle/report/text.hpp"
#include "reference/constrained/cdt_by_polygon_insertion.hpp"
#include "reference/constrained/gift_wrapping_cdt.hpp"
#include "reference/constrained/planar_cdt.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/simplex_predicates.hpp"

namespace circumspect::c {
namespace {

// A mesh that is compared or certified as it is.
Mesh sound_mesh(const circumspect_mesh* mesh, bool weighted) {
  Mesh sound = mesh_of(*required(mesh, "a mesh"), weighted);
  refuse_empty(sound);
  refuse_equal_points(equal_points(sound));
  return sound;
}

// The points of a mesh without its simplices.
Mesh points_of(const circumspect_mesh* points) {
  circumspect_mesh alone = *required(points, "a mesh");
  alone.simplex_count = alone.triangle_count = alone.edge_count = 0;
  alone.neighbors = nullptr;
  return mesh_of(alone, true);
}

Triangulation canonical(const PointSet& points) {
  return delaunay::bowyer_watson(points, {.order = delaunay::InsertionOrder::kBrioHilbert,
                                          .location = delaunay::PointLocation::kWalking});
}

// With more vertices, gift-wrapping, which always answers, takes longer than inserting polygons.
constexpr std::size_t kFewVertices = 200;

constrained::PlcTriangulation built(const PiecewiseLinearComplex& complex) {
  if (complex.ambient_dimension() == 2) return constrained::planar_cdt(complex);
  if (complex.points.size() > kFewVertices) {
    auto inserted = constrained::cdt_by_polygon_insertion(complex);
    if (inserted) return *std::move(inserted);
  }
  auto wrapped = constrained::gift_wrapping_cdt(complex);
  if (wrapped) return *std::move(wrapped);
  const auto& [why, simplex, witness] = wrapped.error();
  std::string place =
      simplex.empty() ? "" : report::joined(simplex);  // either may have no vertices
  if (!witness.empty()) place += (place.empty() ? "" : " and ") + report::joined(witness);
  throw Refusal{CIRCUMSPECT_NONE,
                fmt::format("expected a domain that has a canonical constrained Delaunay "
                            "triangulation, found none: it shows at {}",
                            place)};
}

// All points of one dimension, `count` of them.
Configuration configuration_of(std::int64_t dimension, std::int64_t beyond, const double* doubles,
                               const char* const* texts) {
  if (dimension < 1 || dimension > kLargestDimension) {
    refuse_call(
        fmt::format("expected a dimension from 1 to {}, found {}", kLargestDimension, dimension));
  }
  if (doubles == nullptr && texts == nullptr) refuse_call("expected coordinates, found NULL");
  return Configuration(exact_points(dimension + beyond, dimension, doubles, texts));
}

std::vector<Vertex> first_vertices(std::int64_t count) {
  std::vector<Vertex> vertices;
  for (Vertex v = 0; v < count; ++v) vertices.push_back(v);
  return vertices;
}

std::vector<std::size_t> all_axes(std::int64_t dimension) {
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    axes.push_back(axis);
  return axes;
}

int orientation_sign(std::int64_t dimension, const double* doubles, const char* const* texts) {
  const Configuration points = configuration_of(dimension, 1, doubles, texts);
  return orientation(points, all_axes(dimension), first_vertices(dimension + 1));
}

int in_ball_sign(std::int64_t dimension, const double* doubles, const char* const* texts) {
  const Configuration points = configuration_of(dimension, 2, doubles, texts);
  const std::vector<std::size_t> axes = all_axes(dimension);
  const std::vector<Vertex> simplex = first_vertices(dimension + 1);
  if (orientation(points, axes, simplex) == 0) {
    refuse_input(fmt::format(
        "expected {} affinely independent points before the last, found others", dimension + 1));
  }
  return in_ball(points, axes, simplex, dimension + 1);
}

constexpr std::int64_t kMostDrawn = 1'000'000;

std::size_t how_many(std::int64_t points) {
  if (points < 1 || points > kMostDrawn) {
    refuse_call(fmt::format("expected from 1 to {} points, found {}", kMostDrawn, points));
  }
  return static_cast<std::size_t>(points);
}

PiecewiseLinearInput drawn_domain(const char* family_name, std::int64_t points,
                                  std::uint64_t seed) {
  const std::string name = required(family_name, "the name of a family");
  const generators::ComplexFamily* const family = properties::find_domain_family(name);
  if (family == nullptr) {
    refuse_call(generators::unknown_family_text("domains", on_one_line(name)));
  }
  return generators::in_doubles(generators::drawn(*family, how_many(points), seed)).input;
}

PointArray drawn(const char* family_name, std::int64_t dimension, std::int64_t points,
                 std::uint64_t seed) {
  const std::string name = required(family_name, "the name of a family");
  const generators::Family* const family = generators::find_family(name);
  if (family == nullptr) {
    refuse_call(generators::unknown_family_text("points", on_one_line(name)));
  }
  if (dimension < 1 || !family->exists_in(static_cast<std::size_t>(dimension))) {
    refuse_call(generators::no_sets_text(name, generators::dimensions_text(*family), dimension));
  }
  const auto columns = static_cast<std::size_t>(dimension);
  const generators::PointsCase set =
      generators::drawn(*family, columns, {how_many(points), true}, seed);
  return generators::array(generators::in_doubles(set, family->repeats_points), columns);
}

report::Json points_json(const Mesh& mesh, const std::vector<Vertex>& vertices) {
  report::Json all = report::Json::array();
  for (const Vertex v : vertices) {
    all.push_back({{"index", v}, {"coordinates", report::point(mesh.point(v))}});
  }
  return all;
}

}  // namespace
}  // namespace circumspect::c

using namespace circumspect;

struct circumspect_triangulation {
  int dimension = -1;
  std::map<std::size_t, std::vector<std::int64_t>> simplices = {};  // by how many vertices each has

  void add(const Simplex& simplex) {
    std::vector<std::int64_t>& list = simplices[simplex.size()];
    list.insert(list.end(), simplex.begin(), simplex.end());
  }
};

struct circumspect_drawing {
  explicit circumspect_drawing(PointArray drawn) : points(std::move(drawn)) {
    mesh.dimension = static_cast<std::int64_t>(points.dimension);
    mesh.point_count = static_cast<std::int64_t>(points.size());
    mesh.coordinates = points.coordinates.data();
    mesh.weights = points.weights.empty() ? nullptr : points.weights.data();
  }

  explicit circumspect_drawing(const PiecewiseLinearInput& input)
      : circumspect_drawing(generators::array({input.points, {}})) {
    std::vector<Point> all_polygon_holes;
    for (const auto& ends : input.segments)
      segments.insert(segments.end(), ends.begin(), ends.end());
    for (const PolygonLines& polygon : input.polygons) {
      for (const auto& line : polygon.lines) {
        corners.insert(corners.end(), line.begin(), line.end());
        line_starts.push_back(static_cast<std::int64_t>(corners.size()));
      }
      for (const Point& hole : polygon.hole_seeds) {
        polygons_of_holes.push_back(domain.polygon_count);
        all_polygon_holes.push_back(hole);
      }
      polygon_starts.push_back(static_cast<std::int64_t>(line_starts.size()) - 1);
      ++domain.polygon_count;
    }
    holes = generators::array({input.hole_seeds, {}});
    polygon_holes = generators::array({all_polygon_holes, {}});
    domain.dimension = mesh.dimension;
    domain.point_count = mesh.point_count;
    domain.coordinates = mesh.coordinates;
    domain.segment_count = static_cast<std::int64_t>(input.segments.size());
    domain.segments = segments.data();
    domain.polygon_starts = polygon_starts.data();
    domain.line_starts = line_starts.data();
    domain.corners = corners.data();
    domain.hole_count = static_cast<std::int64_t>(input.hole_seeds.size());
    domain.hole_seeds = holes.coordinates.data();
    domain.kind = input.kind == DomainKind::kHull ? CIRCUMSPECT_HULL : CIRCUMSPECT_ENCLOSED;
    domain.polygon_hole_count = static_cast<std::int64_t>(all_polygon_holes.size());
    domain.polygons_of_holes = polygons_of_holes.data();
    domain.polygon_hole_seeds = polygon_holes.coordinates.data();
  }

  PointArray points;
  circumspect_mesh mesh = CIRCUMSPECT_MESH;
  // For a domain, whose dimension is 0 otherwise.
  std::vector<std::int64_t> segments = {};
  std::vector<std::int64_t> polygon_starts = {0};
  std::vector<std::int64_t> line_starts = {0};
  std::vector<std::int64_t> corners = {};
  std::vector<std::int64_t> polygons_of_holes = {};
  PointArray holes = {};
  PointArray polygon_holes = {};
  circumspect_domain domain = CIRCUMSPECT_DOMAIN;
};

const char* circumspect_version(void) { return CIRCUMSPECT_VERSION; }

circumspect_status circumspect_generate(const char* family, int64_t dimension, int64_t points,
                                        uint64_t seed, circumspect_drawing** drawing) {
  if (drawing != nullptr) *drawing = nullptr;
  return c::guarded([&] {
    c::required(drawing, "a place for the drawing");
    *drawing = new circumspect_drawing(c::drawn(family, dimension, points, seed));
  });
}

circumspect_status circumspect_generate_domain(const char* family, int64_t points, uint64_t seed,
                                               circumspect_drawing** drawing) {
  if (drawing != nullptr) *drawing = nullptr;
  return c::guarded([&] {
    c::required(drawing, "a place for the drawing");
    *drawing = new circumspect_drawing(c::drawn_domain(family, points, seed));
  });
}

const circumspect_domain* circumspect_drawing_domain(const circumspect_drawing* drawing) {
  return drawing == nullptr || drawing->domain.dimension == 0 ? nullptr : &drawing->domain;
}

const circumspect_mesh* circumspect_drawing_mesh(const circumspect_drawing* drawing) {
  return drawing == nullptr ? nullptr : &drawing->mesh;
}

void circumspect_drawing_free(circumspect_drawing* drawing) { delete drawing; }

circumspect_status circumspect_delaunay(const circumspect_mesh* points,
                                        circumspect_triangulation** triangulation) {
  if (triangulation != nullptr) *triangulation = nullptr;
  return c::guarded([&] {
    c::required(triangulation, "a place for the triangulation");
    const Mesh mesh = c::points_of(points);
    c::refuse_equal_points(equal_points(mesh));
    const PointSet set = exact(mesh).points;
    const Triangulation built = c::canonical(set);
    auto made = std::make_unique<circumspect_triangulation>();
    made->dimension = built.dimension();
    for (const Simplex& simplex : built.simplices()) made->add(positively_oriented(set, simplex));
    *triangulation = made.release();
  });
}

circumspect_status circumspect_constrained_delaunay(const circumspect_domain* domain,
                                                    circumspect_triangulation** triangulation) {
  if (triangulation != nullptr) *triangulation = nullptr;
  return c::guarded([&] {
    c::required(triangulation, "a place for the triangulation");
    const Domain filled = c::domain_of(*c::required(domain, "a domain"));
    const constrained::PlcTriangulation built = c::built(filled.complex);
    auto made = std::make_unique<circumspect_triangulation>();
    made->dimension = static_cast<int>(filled.complex.ambient_dimension());
    for (const Simplex& simplex : built.simplices) {
      made->add(positively_oriented(filled.complex.points, simplex));
    }
    for (const Simplex& simplex : built.dangling) made->add(simplex);
    *triangulation = made.release();
  });
}

void circumspect_triangulation_free(circumspect_triangulation* triangulation) {
  delete triangulation;
}

int64_t circumspect_triangulation_dimension(const circumspect_triangulation* triangulation) {
  return triangulation == nullptr ? -1 : triangulation->dimension;
}

int64_t circumspect_triangulation_simplices(const circumspect_triangulation* triangulation,
                                            int64_t vertices, const int64_t** indices) {
  if (indices != nullptr) *indices = nullptr;
  if (triangulation == nullptr || vertices < 1) return 0;
  const auto found = triangulation->simplices.find(static_cast<std::size_t>(vertices));
  if (found == triangulation->simplices.end()) return 0;
  if (indices != nullptr) *indices = found->second.data();
  return static_cast<int64_t>(found->second.size()) / vertices;
}

circumspect_status circumspect_orientation(int64_t dimension, const double* coordinates,
                                           int* sign) {
  return c::guarded([&] {
    int* const place = c::required(sign, "a place for the sign");
    *place = c::orientation_sign(dimension, coordinates, nullptr);
  });
}

circumspect_status circumspect_in_ball(int64_t dimension, const double* coordinates, int* sign) {
  return c::guarded([&] {
    int* const place = c::required(sign, "a place for the sign");
    *place = c::in_ball_sign(dimension, coordinates, nullptr);
  });
}

circumspect_status circumspect_orientation_exact(int64_t dimension, const char* const* coordinates,
                                                 int* sign) {
  return c::guarded([&] {
    int* const place = c::required(sign, "a place for the sign");
    *place = c::orientation_sign(dimension, nullptr, coordinates);
  });
}

circumspect_status circumspect_in_ball_exact(int64_t dimension, const char* const* coordinates,
                                             int* sign) {
  return c::guarded([&] {
    int* const place = c::required(sign, "a place for the sign");
    *place = c::in_ball_sign(dimension, nullptr, coordinates);
  });
}

circumspect_status circumspect_compare(const circumspect_mesh* a, const circumspect_mesh* b,
                                       int* same, circumspect_document** document) {
  if (document != nullptr) *document = nullptr;
  return c::guarded([&] {
    c::required(same, "a place for the answer");
    c::required(document, "a place for the document");
    const Mesh mesh_a = c::sound_mesh(a, true);
    const Mesh mesh_b = c::sound_mesh(b, true);
    const check::Difference found = check::difference(mesh_a, mesh_b).value();
    c::require_memory_for_json();
    const report::Json json = {{"same", found.empty()},
                               {"only_in_a",
                                {{"points", c::points_json(mesh_a, found.points_only_in_a)},
                                 {"simplices", found.simplices_only_in_a}}},
                               {"only_in_b",
                                {{"points", c::points_json(mesh_b, found.points_only_in_b)},
                                 {"simplices", found.simplices_only_in_b}}}};
    *document = new circumspect_document{report::document_text(json)};
    *same = found.empty() ? 1 : 0;
  });
}

circumspect_status circumspect_certify(const char* claim, const circumspect_mesh* mesh, int* holds,
                                       circumspect_document** document) {
  if (document != nullptr) *document = nullptr;
  return c::guarded([&] {
    c::required(holds, "a place for the answer");
    c::required(document, "a place for the document");
    const Claim known = c::claim_of(claim, false);
    const Mesh certified = c::sound_mesh(mesh, known == Claim::kWeightedDelaunay);
    const Verdict verdict = check::judge(known, certified).value();
    const ExactMesh exact_mesh = exact(certified);
    const auto proof = certificate::document_of(exact_mesh, verdict);
    if (!proof) throw c::Refusal{CIRCUMSPECT_NONE, proof.error()};
    std::ostringstream text;
    certificate::write(text, exact_mesh, *proof);
    if (!text) throw std::bad_alloc();  // how streams report that memory ran out
    *document = new circumspect_document{text.str()};
    *holds = verdict.holds() ? 1 : 0;
  });
}

circumspect_status circumspect_inspect(const circumspect_mesh* points, int* unique,
                                       circumspect_document** document) {
  if (document != nullptr) *document = nullptr;
  return c::guarded([&] {
    c::required(unique, "a place for the answer");
    c::required(document, "a place for the document");
    Mesh mesh = c::points_of(points);
    const std::size_t count = mesh.points();
    const std::vector<Duplicate> repeated = merge_equal_points(mesh);
    const PointSet set = exact(mesh).points;
    std::optional<Simplex> cospherical;
    if (!set.empty()) {
      cospherical = delaunay::cospherical_points_of_an_empty_ball(set, c::canonical(set));
    }
    c::require_memory_for_json();
    report::Json json = {{"points", count}, {"dimension", set.dimension()}};
    json["repeated"] = report::Json::array();
    for (const auto& [kept, again] : repeated) json["repeated"].push_back({kept, again});
    json["unique"] = !cospherical;
    if (cospherical) {
      for (const Vertex v : *cospherical) json["cospherical"].push_back(mesh.label(v));
    }
    *document = new circumspect_document{report::document_text(json)};
    *unique = cospherical ? 0 : 1;
  });
}

const char* circumspect_document_text(const circumspect_document* document) {
  return document == nullptr ? "" : document->text.c_str();
}

void circumspect_document_free(circumspect_document* document) { delete document; }
