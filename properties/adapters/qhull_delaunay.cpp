extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <cstdio>
#include <stdexcept>
#include <string>

#include "properties/adapters/adapters.hpp"

namespace circumspect::adapters {

SimplexArray qhull_delaunay(const PointArray& points) {
  std::vector<double> coordinates = points.coordinates;  // Qhull takes them as its own
  qhT state;
  qh_zero(&state, nullptr);
  std::string command = "qhull d Qt Qbb Qc";
  std::FILE* const silent = std::fopen("/dev/null", "w");
  const int code =
      qh_new_qhull(&state, static_cast<int>(points.dimension), static_cast<int>(points.size()),
                   coordinates.data(), False, command.data(), silent, silent);
  SimplexArray rows;
  if (code == 0) {
    for (const facetT* facet = state.facet_list; facet != nullptr && facet->next != nullptr;
         facet = facet->next) {
      if (facet->upperdelaunay) continue;
      rows.emplace_back();
      for (setelemT* e = facet->vertices->e; e->p != nullptr; ++e) {
        rows.back().push_back(qh_pointid(&state, static_cast<vertexT*>(e->p)->point));
      }
    }
  }
  qh_freeqhull(&state, qh_ALL);
  std::fclose(silent);
  if (code != 0) throw std::runtime_error("Qhull ended with its error " + std::to_string(code));
  return rows;
}

}  // namespace circumspect::adapters
