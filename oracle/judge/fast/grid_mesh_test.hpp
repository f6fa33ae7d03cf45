// For tests: large Delaunay triangulations that are written down directly. Each cube of a grid is
// cut into the simplices of the orders of its axes (Kuhn's subdivision; all corners of a cube are
// on one sphere).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "oracle/judge/fast/mesh_view.hpp"

namespace circumspect::fast {

template <std::size_t kDimension, typename Index = std::int32_t>
struct MeshInArrays {
  std::vector<double> coordinates = {};
  std::vector<Index> simplices = {};
  std::vector<Index> neighbors = {};
  std::vector<double> weights = {};

  MeshView<kDimension, Index> view() const { return {coordinates, weights, simplices, neighbors}; }
  std::size_t size() const { return simplices.size() / (kDimension + 1); }
};

// `side` points along each axis, without neighbours. `mirrored` makes every other simplex negative.
template <std::size_t kDimension, typename Index = std::int32_t>
MeshInArrays<kDimension, Index> grid_mesh(std::size_t side, bool mirrored = false) {
  MeshInArrays<kDimension, Index> mesh;
  std::array<std::size_t, kDimension> stride;
  std::size_t points = 1;
  for (std::size_t axis = 0; axis < kDimension; ++axis, points *= side) stride[axis] = points;
  for (std::size_t v = 0; v < points; ++v) {
    std::array<std::size_t, kDimension> order;
    std::iota(order.begin(), order.end(), std::size_t{0});
    bool is_corner = true;
    for (const std::size_t axis : order) {
      const std::size_t place = v / stride[axis] % side;
      mesh.coordinates.push_back(static_cast<double>(place));
      is_corner &= place + 1 < side;
    }
    do {
      if (!is_corner) break;
      const std::size_t begin = mesh.simplices.size();
      std::size_t corner = v;
      mesh.simplices.push_back(static_cast<Index>(v));
      bool odd = false;
      for (std::size_t i = 0; i < kDimension; ++i) {
        corner += stride[order[i]];
        mesh.simplices.push_back(static_cast<Index>(corner));
        for (std::size_t k = 0; k < i; ++k) odd ^= order[k] > order[i];
      }
      if (odd && !mirrored) std::swap(mesh.simplices[begin], mesh.simplices[begin + 1]);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return mesh;
}

}  // namespace circumspect::fast
