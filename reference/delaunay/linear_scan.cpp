#include "reference/delaunay/linear_scan.hpp"

#include "reference/delaunay/conflict.hpp"

namespace circumspect::delaunay {

std::optional<Simplex> linear_scan(const PointSet& points, const SimplexDictionary& dictionary,
                                   Vertex q, Statistics& statistics) {
  return dictionary.find([&](const Simplex& simplex) {
    ++statistics.conflict_tests;
    return is_in_conflict(points, simplex, q);
  });
}

}  // namespace circumspect::delaunay
