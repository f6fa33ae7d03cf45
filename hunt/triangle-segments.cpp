// Shewchuk's Triangle, called with "pczQ": the hull, with the segments.
#define REAL double
#define VOID void
#define ANSI_DECLARATORS
#include <cstdlib>

#include <triangle.h>

#include "lines.hpp"

int main() {
  return lines::serve_domains([](const lines::Points& points, const lines::Segments& segments) {
    std::vector<double> coordinates;
    std::vector<int> ends;
    for (const auto& p : points) coordinates.insert(coordinates.end(), p.begin(), p.end());
    for (const auto& [a, b] : segments)
      ends.insert(ends.end(), {static_cast<int>(a), static_cast<int>(b)});
    triangulateio in{};
    triangulateio out{};
    in.pointlist = coordinates.data();
    in.numberofpoints = static_cast<int>(points.size());
    in.segmentlist = ends.data();
    in.numberofsegments = static_cast<int>(segments.size());
    char switches[] = "pczQ";
    triangulate(switches, &in, &out, nullptr);
    lines::Simplices made;
    for (int i = 0; i < out.numberoftriangles; ++i) {
      const int* t = out.trianglelist + 3 * i;
      made.push_back({t[0], t[1], t[2]});
    }
    std::free(out.trianglelist);
    return made;
  });
}
