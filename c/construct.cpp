// Triangulations of points and of domains, as arrays.
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <circumspect/circumspect.h>
#include <fmt/format.h>

#include "c/guard.hpp"
#include "c/input.hpp"
#include "construct/delaunay.hpp"
#include "kernel/complex/point_set.hpp"
#include "oracle/report/text.hpp"
#include "reference/constructions.hpp"

namespace circumspect::c {
namespace {

// There is none: a refusal that names the simplices that show it. Either may have no vertices.
Refusal refusal_of(const reference::NoCdt& none) {
  std::string place = none.simplex.empty() ? "" : report::joined(none.simplex);
  if (!none.witness.empty()) place += (place.empty() ? "" : " and ") + report::joined(none.witness);
  return {CIRCUMSPECT_NONE,
          fmt::format("expected a domain that has a canonical constrained Delaunay "
                      "triangulation, found none: it shows at {}",
                      place)};
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

circumspect_status circumspect_delaunay(const circumspect_mesh* points,
                                        circumspect_triangulation** triangulation) {
  if (triangulation != nullptr) *triangulation = nullptr;
  return c::guarded([&] {
    c::required(triangulation, "a place for the triangulation");
    const Mesh mesh = c::points_of(points);
    c::refuse_equal_points(equal_points(mesh));
    const PointSet set = exact(mesh).points;
    const Triangulation built = construct::any_canonical_delaunay(set).triangulation;
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
    const auto built = reference::canonical_cdt(filled.complex);
    if (!built) throw c::refusal_of(built.error());
    auto made = std::make_unique<circumspect_triangulation>();
    made->dimension = static_cast<int>(filled.complex.ambient_dimension());
    for (const Simplex& simplex : built->simplices) {
      made->add(positively_oriented(filled.complex.points, simplex));
    }
    for (const Simplex& simplex : built->dangling) made->add(simplex);
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
