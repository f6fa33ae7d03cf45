// Judges two meshes of one square that lie in arrays: one is Delaunay, the other is not. Exit code
// 0 if the judge says so.
#include <cstdint>
#include <cstdio>
#include <vector>

#include <circumspect/check.hpp>

int main() {
  // The last point is a little inside the circle of the others.
  const std::vector<double> points = {0, 0, 1, 0, 0, 1, 0.9, 0.9};
  const std::vector<std::int32_t> right = {0, 1, 3, 0, 3, 2};
  const std::vector<std::int32_t> wrong = {0, 1, 2, 1, 3, 2};
  int surprises = 0;
  for (const auto* simplices : {&right, &wrong}) {
    const circumspect::MeshArrays<std::int32_t> mesh{
        .dimension = 2, .coordinates = points, .simplices = *simplices};
    const auto found = circumspect::judge("delaunay", mesh);
    std::printf("%s\n%s", found.holds ? "holds" : found.rule.c_str(), found.report.c_str());
    if (found.holds != (simplices == &right)) ++surprises;
  }
  return surprises == 0 ? 0 : 1;
}
