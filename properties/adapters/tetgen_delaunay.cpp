#include <stdexcept>
#include <string>

#define TETLIBRARY  // so that its errors are exceptions
#include <tetgen.h>

#include "properties/adapters/adapters.hpp"

namespace circumspect::adapters {

SimplexArray tetgen_delaunay(const PointArray& points) {
  tetgenio in;
  tetgenio out;
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(points.size());
  in.pointlist = new REAL[points.coordinates.size()];  // tetgenio deletes it
  std::copy(points.coordinates.begin(), points.coordinates.end(), in.pointlist);
  std::string switches = "Q";
  try {
    tetrahedralize(switches.data(), &in, &out);
  } catch (const int code) {
    throw std::runtime_error("TetGen ended with its error " + std::to_string(code));
  }
  SimplexArray rows;
  for (int i = 0; i < out.numberoftetrahedra; ++i) {
    const int* const corners = out.tetrahedronlist + 4 * i;
    rows.emplace_back(corners, corners + 4);
  }
  return rows;
}

}  // namespace circumspect::adapters
