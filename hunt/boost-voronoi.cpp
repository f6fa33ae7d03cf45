// The dual of Boost.Polygon's Voronoi diagram, which takes integers of 32 bits; a vertex of more
// than three cells makes a fan.
#include <cmath>

#include <boost/polygon/point_data.hpp>
#include <boost/polygon/voronoi.hpp>

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    std::vector<boost::polygon::point_data<int>> own;
    for (const auto& p : points) {
      for (const double x : p)
        if (x != std::floor(x) || std::fabs(x) > 2147483647)
          throw lines::Refused{"takes integers of 32 bits"};
      own.emplace_back(static_cast<int>(p[0]), static_cast<int>(p[1]));
    }
    boost::polygon::voronoi_diagram<double> diagram;
    boost::polygon::construct_voronoi(own.begin(), own.end(), &diagram);
    lines::Simplices made;
    for (const auto& vertex : diagram.vertices()) {
      std::vector<long> around;
      const auto* edge = vertex.incident_edge();
      do {
        around.push_back(static_cast<long>(edge->cell()->source_index()));
        edge = edge->rot_next();
      } while (edge != vertex.incident_edge());
      for (std::size_t i = 2; i < around.size(); ++i)
        made.push_back({around[0], around[i - 1], around[i]});
    }
    return made;
  });
}
