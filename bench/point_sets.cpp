#include "bench/point_sets.hpp"

#include <cmath>
#include <random>

namespace circumspect::bench {
namespace {

// 53 random bits in [0, 1).
class Random {
 public:
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_{20260101};
};

}  // namespace

std::vector<double> random_points(int count) {
  std::vector<double> points;
  Random random;
  for (int i = 0; i < 3 * count; ++i) points.push_back(random());
  return points;
}

std::vector<double> grid_points(int side) {
  std::vector<double> points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) {
        points.insert(points.end(),
                      {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
      }
    }
  }
  return points;
}

std::vector<double> sphere_points(int count) {
  std::vector<double> points;
  Random random;
  while (points.size() < 3 * static_cast<std::size_t>(count)) {
    const double x = random() - 0.5, y = random() - 0.5, z = random() - 0.5;
    const double radius = std::sqrt(x * x + y * y + z * z);
    if (radius > 0.5 || radius == 0) continue;
    points.insert(points.end(), {x / radius, y / radius, z / radius});
  }
  return points;
}

std::vector<double> clustered_points(int clusters, int points_each) {
  std::vector<double> points;
  Random random;
  for (int i = 0; i < clusters; ++i) {
    const double x = random(), y = random(), z = random();
    for (int j = 0; j < points_each; ++j) {
      for (const double center : {x, y, z}) points.push_back(center + 1e-4 * random());
    }
  }
  return points;
}

std::vector<double> points_near_line(int count) {
  std::vector<double> points;
  Random random;
  for (int i = 0; i < count; ++i) {
    points.push_back(random());
    points.push_back(1e-3 * random());
    points.push_back(1e-3 * random());
  }
  return points;
}

std::vector<double> points_near_two_lines(int count) {
  std::vector<double> points;
  Random random;
  for (int i = 0; i < count; ++i) {
    const double along = random(), off = 1e-9 * random(), up = 1e-9 * random();
    if (i % 2 == 0) {
      points.insert(points.end(), {along, off, up});
    } else {
      points.insert(points.end(), {off, along, 1 + up});
    }
  }
  return points;
}

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
