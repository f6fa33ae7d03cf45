#include "triangulate.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace example {
namespace {

// Positive if a, b, c turn left. Right as long as nothing is rounded.
double orientation(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Positive if d is inside the circle through a, b, c, which turn left. The same.
double in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto lifted = [&d](const Point& p) {
    const double x = p[0] - d[0], y = p[1] - d[1];
    return std::array<double, 3>{x, y, x * x + y * y};
  };
  const auto u = lifted(a), v = lifted(b), w = lifted(c);
  return u[2] * (v[0] * w[1] - w[0] * v[1]) - v[2] * (u[0] * w[1] - w[0] * u[1]) +
         w[2] * (u[0] * v[1] - v[0] * u[1]);
}

// Some triangulation: a sweep from left to right joins each point to the edges of the hull it sees.
std::vector<Triangle> swept(const std::vector<Point>& points) {
  const auto at = [&points](int v) { return points[static_cast<std::size_t>(v)]; };
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return at(a) < at(b); });
  std::vector<Triangle> triangles;
  std::vector<std::pair<int, int>> hull;  // its edges, counterclockwise
  for (std::size_t i = 1; i < order.size(); ++i) {
    const int p = order[i];
    const auto is_seen = [&](const std::pair<int, int>& edge) {
      return orientation(at(edge.first), at(edge.second), at(p)) < 0;
    };
    if (std::none_of(hull.begin(), hull.end(), is_seen)) {
      // All points so far are on one line, where edges count in both directions.
      hull.emplace_back(order[i - 1], p);
      hull.emplace_back(p, order[i - 1]);
      continue;
    }
    std::map<int, int> ends;  // of the chain of edges that are seen
    for (const auto& edge : hull) {
      if (!is_seen(edge)) continue;
      triangles.push_back({edge.second, edge.first, p});
      ++ends[edge.first];
      --ends[edge.second];
    }
    hull.erase(std::remove_if(hull.begin(), hull.end(), is_seen), hull.end());
    for (const auto& [v, end] : ends) {
      if (end > 0) hull.emplace_back(v, p);
      if (end < 0) hull.emplace_back(p, v);
    }
  }
  return triangles;
}

// Flips one edge that is not locally Delaunay, if there is one.
bool flip_an_edge(const std::vector<Point>& points, std::vector<Triangle>& triangles) {
  const auto at = [&points](int v) { return points[static_cast<std::size_t>(v)]; };
  std::map<std::pair<int, int>, std::pair<std::size_t, int>> behind;  // edge: triangle, apex
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = triangles[t][i], b = triangles[t][(i + 1) % 3], c = triangles[t][(i + 2) % 3];
      behind[{a, b}] = {t, c};
      const auto other = behind.find({b, a});
      if (other == behind.end()) continue;
      const auto [u, d] = other->second;
      if (in_circle(at(a), at(b), at(c), at(d)) <= 0) continue;
      triangles[t] = {c, a, d};
      triangles[u] = {c, d, b};
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<Triangle> triangulate(const std::vector<Point>& points) {
  std::vector<Triangle> triangles = swept(points);
  // Flips come to an end if no sign is wrong; so that they do in any case, they are counted.
  for (int flips = 0; flips < 10000 && flip_an_edge(points, triangles);) ++flips;
  return triangles;
}

}  // namespace example
