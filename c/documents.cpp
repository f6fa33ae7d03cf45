// Calls that answer with a document: comparisons, certificates, facts about points.
#include <cstddef>
#include <new>
#include <optional>
#include <sstream>
#include <vector>

#include <circumspect/circumspect.h>

#include "c/guard.hpp"
#include "c/input.hpp"
#include "construct/delaunay.hpp"
#include "oracle/certificate/document.hpp"
#include "oracle/judge/judge.hpp"
#include "oracle/judge/mesh_difference.hpp"
#include "oracle/model/mesh.hpp"
#include "oracle/report/json.hpp"
#include "reference/constructions.hpp"

namespace circumspect::c {
namespace {

// A mesh that is compared or certified as it is.
Mesh sound_mesh(const circumspect_mesh* mesh, bool weighted) {
  Mesh sound = mesh_of(*required(mesh, "a mesh"), weighted);
  refuse_empty(sound);
  refuse_equal_points(equal_points(sound));
  return sound;
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
      const construct::CanonicalDelaunay canonical = construct::any_canonical_delaunay(set);
      if (!canonical.is_known_unique) {
        cospherical = reference::cospherical_points_of_an_empty_ball(set, canonical.triangulation);
      }
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
