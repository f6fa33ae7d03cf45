// raintherrien/delaunator-c: single precision. Its macros for the layout of the result do not
// compile as C++.
#include <stdexcept>

extern "C" {
#include <delaunay/delaunay.h>
}

#include "lines.hpp"

int main() {
  return lines::serve([](const lines::Points& points) {
    const auto n = static_cast<std::uint32_t>(points.size());
    std::vector<float> coordinates;
    for (const auto& p : points) coordinates.insert(coordinates.end(), p.begin(), p.end());
    std::vector<std::uint32_t> d(DELAUNAY_SZ(n));
    if (triangulate(d.data(), coordinates.data(), n) != 0)
      throw std::runtime_error("an error is returned");
    const std::uint32_t* v = d.data() + 10 * n;
    lines::Simplices made;
    for (std::uint32_t i = 0; i + 2 < d[16 * n]; i += 3) made.push_back({v[i], v[i + 1], v[i + 2]});
    return made;
  });
}
