// The newest Qhull, called as SciPy calls it: "qhull d Qbb Qc Qz Qt" (Q12 in more than four
// dimensions).
extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <stdexcept>

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    const int dimension = static_cast<int>(points[0].size());
    std::vector<double> coordinates;
    for (const auto& p : points) coordinates.insert(coordinates.end(), p.begin(), p.end());
    qhT own{};
    qhT* qh = &own;
    qh_zero(qh, stderr);
    char command[] = "qhull d Qbb Qc Qz Qt";
    const int code = qh_new_qhull(qh, dimension, static_cast<int>(points.size()),
                                  coordinates.data(), 0, command, nullptr, nullptr);
    lines::Simplices made;
    if (code == 0) {
      facetT* facet;
      vertexT *vertex, **vertexp;
      FORALLfacets {
        if (facet->upperdelaunay) continue;
        std::vector<long> simplex;
        FOREACHvertex_(facet->vertices) simplex.push_back(qh_pointid(qh, vertex->point));
        made.push_back(simplex);
      }
    }
    qh_freeqhull(qh, !qh_ALL);
    int current = 0;
    int total = 0;
    qh_memfreeshort(qh, &current, &total);
    if (code != 0) throw lines::Refused{"exit code " + std::to_string(code)};
    return made;
  });
}
