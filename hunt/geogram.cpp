// "BDEL2d" and "BDEL", of the pluggable module that tools/extract_psm.sh makes of
// delaunay/Delaunay.psm.
#include "Delaunay_psm.h"
#include "lines.hpp"

int main() {
  GEO::initialize();
  return lines::serve([](const lines::Points& points) {
    const auto dimension = static_cast<GEO::coord_index_t>(points[0].size());
    std::vector<double> coordinates;
    for (const auto& p : points) coordinates.insert(coordinates.end(), p.begin(), p.end());
    const GEO::Delaunay_var delaunay =
        GEO::Delaunay::create(dimension, dimension == 2 ? "BDEL2d" : "BDEL");
    delaunay->set_vertices(static_cast<GEO::index_t>(points.size()), coordinates.data());
    lines::Simplices made;
    for (GEO::index_t c = 0; c < delaunay->nb_cells(); ++c) {
      std::vector<long> simplex;
      for (GEO::index_t v = 0; v <= dimension; ++v)
        simplex.push_back(static_cast<long>(delaunay->cell_vertex(c, v)));
      made.push_back(simplex);
    }
    return made;
  });
}
