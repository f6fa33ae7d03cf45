#include <delaunay.h>

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    std::vector<dt::Vector2<double>> own;
    for (const auto& p : points) own.push_back(dt::Vector2<double>{p[0], p[1]});
    const lines::Indices index(points);
    dt::Delaunay<double> delaunay;
    lines::Simplices made;
    for (const auto& t : delaunay.triangulate(own)) {
      made.push_back({index({t.a->x, t.a->y}), index({t.b->x, t.b->y}), index({t.c->x, t.c->y})});
    }
    return made;
  });
}
