#include <stdexcept>

#include <tetgen.h>

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    tetgenio in;
    tetgenio out;
    in.numberofpoints = static_cast<int>(points.size());
    in.pointlist = new REAL[3 * points.size()];
    for (std::size_t i = 0; i < 3 * points.size(); ++i) in.pointlist[i] = points[i / 3][i % 3];
    char switches[] = "QJ";
    try {
      tetrahedralize(switches, &in, &out);
    } catch (int code) {  // terminatetetgen
      if (code == 10) throw lines::Refused{"nearly flat by -T, 1e-8 unless said otherwise"};
      throw std::runtime_error("terminatetetgen " + std::to_string(code));
    }
    lines::Simplices made;
    for (int i = 0; i < out.numberoftetrahedra; ++i) {
      const int* v = out.tetrahedronlist + 4 * i;
      made.push_back({v[0], v[1], v[2], v[3]});
    }
    return made;
  });
}
