// Shewchuk's Triangle, native, called with "zQ".
#define REAL double
#define VOID void
#define ANSI_DECLARATORS
#include <cstdlib>

#include <triangle.h>

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    std::vector<double> coordinates;
    for (const auto& p : points) coordinates.insert(coordinates.end(), p.begin(), p.end());
    triangulateio in{};
    triangulateio out{};
    in.pointlist = coordinates.data();
    in.numberofpoints = static_cast<int>(points.size());
    char switches[] = "zQ";
    triangulate(switches, &in, &out, nullptr);
    lines::Simplices made;
    for (int i = 0; i < out.numberoftriangles; ++i) {
      const int* t = out.trianglelist + 3 * i;
      made.push_back({t[0], t[1], t[2]});
    }
    std::free(out.pointlist);
    std::free(out.trianglelist);
    return made;
  });
}
