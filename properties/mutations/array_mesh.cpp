#include "properties/mutations/array_mesh.hpp"

#include <algorithm>
#include <numeric>

#include "reference/kernel/predicates/in_ball.hpp"
#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect::properties {
namespace {

Configuration configuration_of(const ArrayMesh& mesh, std::span<const std::int64_t> vertices) {
  std::vector<Point> points;
  std::vector<Rational> weights;
  for (const std::int64_t v : vertices) {
    const auto place = static_cast<std::size_t>(v);
    points.emplace_back();
    for (std::size_t axis = 0; axis < mesh.dimension; ++axis) {
      points.back().push_back(exact_value(mesh.coordinates[place * mesh.dimension + axis]));
    }
    if (!mesh.weights.empty()) weights.push_back(exact_value(mesh.weights[place]));
  }
  return Configuration(points, weights);
}

// 0, 1, 2, …
template <typename Index>
std::vector<Index> first_indices(std::size_t count) {
  std::vector<Index> indices(count);
  std::iota(indices.begin(), indices.end(), Index{0});
  return indices;
}

}  // namespace

ArrayMesh array_mesh(const PointSet& points, const std::vector<Simplex>& simplices) {
  ArrayMesh mesh{.dimension = points.ambient_dimension()};
  for (const Point& point : points.points()) {
    for (const Rational& x : point) mesh.coordinates.push_back(x.get_d());
    if (!points.is_weighted()) continue;
    mesh.weights.push_back(points.weight(static_cast<Vertex>(mesh.weights.size())).get_d());
  }
  for (const Simplex& simplex : simplices) {
    mesh.simplices.insert(mesh.simplices.end(), simplex.begin(), simplex.end());
  }
  return mesh;
}

std::vector<Simplex> simplices_of(const ArrayMesh& mesh) {
  std::vector<Simplex> simplices;
  simplices.reserve(mesh.size());
  for (std::size_t s = 0; s < mesh.size(); ++s) {
    simplices.emplace_back(mesh.row(s).begin(), mesh.row(s).end());
  }
  return simplices;
}

void list_neighbors(ArrayMesh& mesh) {
  const std::size_t width = mesh.width();
  // The vertices of each facet, ascending.
  std::vector<std::int64_t> facets;
  facets.reserve(mesh.simplices.size() * mesh.dimension);
  for (std::size_t facet = 0; facet < mesh.simplices.size(); ++facet) {
    const auto row = mesh.row(facet / width);
    const auto begin = static_cast<std::ptrdiff_t>(facets.size());
    for (std::size_t i = 0; i < width; ++i) {
      if (i != facet % width) facets.push_back(row[i]);
    }
    std::sort(facets.begin() + begin, facets.end());
  }
  const auto vertices = [&](std::size_t facet) {
    return std::span(facets).subspan(facet * mesh.dimension, mesh.dimension);
  };
  std::vector<std::size_t> order = first_indices<std::size_t>(mesh.simplices.size());
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::ranges::lexicographical_compare(vertices(a), vertices(b));
  });
  mesh.neighbors.assign(mesh.simplices.size(), -1);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && std::ranges::equal(vertices(order[begin]), vertices(order[end]))) {
      ++end;
    }
    if (end - begin != 2) continue;
    mesh.neighbors[order[begin]] = static_cast<std::int64_t>(order[begin + 1] / width);
    mesh.neighbors[order[begin + 1]] = static_cast<std::int64_t>(order[begin] / width);
  }
}

std::size_t other_side(const ArrayMesh& mesh, std::size_t facet) {
  const std::size_t width = mesh.width(), s = facet / width;
  const auto t = static_cast<std::size_t>(mesh.neighbors[facet]);
  const auto own = mesh.row(s);
  std::size_t place = 0;
  while (std::find(own.begin(), own.end(), mesh.row(t)[place]) != own.end()) ++place;
  return t * width + place;
}

int orientation_of(const ArrayMesh& mesh, std::span<const std::int64_t> row) {
  return orientation(configuration_of(mesh, row), first_indices<std::size_t>(mesh.dimension),
                     first_indices<Vertex>(row.size()));
}

int in_ball_of(const ArrayMesh& mesh, std::span<const std::int64_t> row, std::int64_t q) {
  std::vector<std::int64_t> all(row.begin(), row.end());
  all.push_back(q);
  return in_ball(configuration_of(mesh, all), first_indices<std::size_t>(mesh.dimension),
                 first_indices<Vertex>(row.size()), static_cast<Vertex>(row.size()));
}

}  // namespace circumspect::properties
