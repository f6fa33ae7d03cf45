#include "bench/point_families.hpp"

#include <random>

namespace circumspect::bench {

std::vector<Point> random_in_cube(std::size_t count, std::size_t dimension) {
  std::mt19937_64 engine(20260101);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    Point point;
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      point.push_back(exact_value(static_cast<double>(engine() >> 11) * 0x1p-53));
    }
    points.push_back(point);
  }
  return points;
}

std::vector<Point> cubic_grid(int side) {
  std::vector<Point> points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) points.push_back({x, y, z});
    }
  }
  return points;
}

std::vector<Point> cubic_grid_adversarial(int side) {
  std::vector<Point> points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) points.push_back({x, y, 0});
  }
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = side - 1; z > 0; --z) points.push_back({x, y, z});
    }
  }
  return points;
}

}  // namespace circumspect::bench
