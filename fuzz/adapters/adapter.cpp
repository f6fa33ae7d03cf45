// A worker for `circumspect campaign --worker -- ./mine`: c++ -std=c++17 -o mine mine.cpp
// your_library.cpp
#include <cstdio>
#include <exception>
#include <vector>

using Rows = std::vector<std::vector<int>>;

// Put your own library here: a vector of points, and back come rows of indices, from 0.
Rows triangulate(const std::vector<std::vector<double>>& points);

int main() {
  int n, d, weights, segments, facets, holes;
  while (std::scanf("%d %d %d %d %d %d", &n, &d, &weights, &segments, &facets, &holes) == 6) {
    std::vector<std::vector<double>> points(n, std::vector<double>(d));
    for (auto& point : points)
      for (double& x : point)
        if (std::scanf("%lf", &x) != 1) return 2;
    const Rows simplices = triangulate(points);  // where its documents let it refuse: std::puts("error TEXT")
    std::printf("%zu\n", simplices.size());
    for (const auto& row : simplices)
      for (std::size_t i = 0; i < row.size(); ++i) std::printf("%d%c", row[i], i + 1 < row.size() ? ' ' : '\n');
    std::fflush(stdout);
  }
}
