#include "properties/mutations/catalogue.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "kernel/predicates/in_ball.hpp"
#include "kernel/predicates/orientation.hpp"

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

std::vector<Mutation> catalogue() {
  std::vector<Mutation> all;
  for (const auto& part : {index_mutations(), facet_mutations(), cover_mutations(),
                           link_mutations(), point_mutations()}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

namespace {

using enum Rule;

const std::set<Rule> kAnyOfSimplices = {
    kRepeatedVertex, kDegenerateSimplex, kDuplicateSimplex, kUnusedPoint,  kFacetOverused,
    kOverlap,        kHullNotClosed,     kHullNotConvex,    kCoveredTwice, kPointBelowPlane};

std::int64_t any_vertex(const ArrayMesh& mesh, Dice& dice) {
  return static_cast<std::int64_t>(dice.below(mesh.points()));
}

bool name_no_point(ArrayMesh& mesh, Dice& dice) {
  std::int64_t& v = mesh.simplices[dice.below(mesh.simplices.size())];
  const auto points = static_cast<std::int64_t>(mesh.points());
  constexpr std::int64_t kWord = std::int64_t{1}
                                 << 32;  // what is left of these in 32 bits names one
  const std::array choices{std::int64_t{-1},
                           points,
                           -points,
                           v + kWord,
                           v - kWord,
                           v + kWord / 2,
                           std::int64_t{std::numeric_limits<std::int32_t>::max()},
                           std::numeric_limits<std::int64_t>::max(),
                           std::numeric_limits<std::int64_t>::min()};
  v = choices[dice.below(choices.size())];
  mesh.neighbors.clear();
  return true;
}

bool repeat_vertex(ArrayMesh& mesh, Dice& dice) {
  const auto row = mesh.row(dice.below(mesh.size()));
  const std::size_t place = dice.below(row.size());
  row[place] = row[(place + 1 + dice.below(row.size() - 1)) % row.size()];
  mesh.neighbors.clear();
  return true;
}

bool change_index(ArrayMesh& mesh, Dice& dice) {
  std::int64_t& v = mesh.simplices[dice.below(mesh.simplices.size())];
  const std::int64_t other = any_vertex(mesh, dice);
  if (other == v) return false;
  v = other;
  mesh.neighbors.clear();
  return true;
}

bool replace_simplex(ArrayMesh& mesh, Dice& dice) {
  const auto row = mesh.row(dice.below(mesh.size()));
  std::vector<std::int64_t> old(row.begin(), row.end());
  for (std::int64_t& v : row) v = any_vertex(mesh, dice);
  mesh.neighbors.clear();
  return !std::is_permutation(old.begin(), old.end(), row.begin());
}

bool merge_vertices(ArrayMesh& mesh, Dice& dice) {
  const std::int64_t gone = mesh.simplices[dice.below(mesh.simplices.size())];
  const std::int64_t kept = any_vertex(mesh, dice);
  std::replace(mesh.simplices.begin(), mesh.simplices.end(), gone, kept);
  mesh.neighbors.clear();
  return gone != kept;
}

bool exchange_everywhere(ArrayMesh& mesh, Dice& dice) {
  const std::int64_t a = any_vertex(mesh, dice), b = any_vertex(mesh, dice);
  for (std::int64_t& v : mesh.simplices) v = v == a ? b : v == b ? a : v;
  mesh.neighbors.clear();
  return a != b;
}

bool exchange_between_two(ArrayMesh& mesh, Dice& dice) {
  std::int64_t& a = mesh.simplices[dice.below(mesh.simplices.size())];
  std::int64_t& b = mesh.simplices[dice.below(mesh.simplices.size())];
  std::swap(a, b);
  mesh.neighbors.clear();
  return a != b;
}

bool drop_simplex(ArrayMesh& mesh, Dice& dice) {
  const auto begin =
      mesh.simplices.begin() + static_cast<std::ptrdiff_t>(dice.below(mesh.size()) * mesh.width());
  mesh.simplices.erase(begin, begin + static_cast<std::ptrdiff_t>(mesh.width()));
  mesh.neighbors.clear();
  return true;
}

bool list_twice(ArrayMesh& mesh, Dice& dice) {
  const auto row = mesh.row(dice.below(mesh.size()));
  std::vector<std::int64_t> again(row.begin(), row.end());
  shuffle(again, dice);
  const auto place = static_cast<std::ptrdiff_t>(dice.below(mesh.size() + 1) * mesh.width());
  mesh.simplices.insert(mesh.simplices.begin() + place, again.begin(), again.end());
  mesh.neighbors.clear();
  return true;
}

bool permute_rows(ArrayMesh& mesh, Dice& dice) {
  for (std::size_t s = 0; s < mesh.size(); ++s) {
    const auto row = mesh.row(s);
    shuffle(row, dice);
  }
  mesh.neighbors.clear();
  return true;
}

// Both lists, so that the links stay right.
bool swap_two_places(ArrayMesh& mesh, Dice& dice) {
  for (std::size_t s = 0; s < mesh.size(); ++s) {
    const std::size_t a = dice.below(mesh.width()), b = dice.below(mesh.width());
    std::swap(mesh.simplices[s * mesh.width() + a], mesh.simplices[s * mesh.width() + b]);
    std::swap(mesh.neighbors[s * mesh.width() + a], mesh.neighbors[s * mesh.width() + b]);
  }
  return true;
}

}  // namespace

std::vector<Mutation> index_mutations() {
  return {
      {"index-of-no-point",
       "One index is negative, the number of points, or beyond 32 bits.",
       Expected::kFails,
       {kUnknownVertex},
       name_no_point},
      {"vertex-repeated",
       "One simplex has a vertex twice.",
       Expected::kFails,
       {kRepeatedVertex},
       repeat_vertex},
      {"index-changed", "One index names another point.", Expected::kFails, kAnyOfSimplices,
       change_index},
      {"simplex-replaced", "One simplex has other vertices.", Expected::kFails, kAnyOfSimplices,
       replace_simplex},
      {"vertices-merged", "One vertex takes the place of another everywhere.", Expected::kFails,
       kAnyOfSimplices, merge_vertices},
      {"vertices-exchanged",
       "Two vertices change places everywhere.",
       Expected::kEither,
       {},
       exchange_everywhere},
      {"vertices-exchanged-between-two",
       "Two simplices exchange a vertex.",
       Expected::kEither,
       {},
       exchange_between_two},
      {"simplex-dropped",
       "One simplex is missing.",
       Expected::kFails,
       {kUnusedPoint, kHullNotClosed, kHullNotConvex},
       drop_simplex},
      {"simplex-listed-twice",
       "One simplex is listed again, in another order.",
       Expected::kFails,
       {kDuplicateSimplex},
       list_twice},
      {"rows-permuted",
       "The vertices of each simplex are listed in another order.",
       Expected::kHolds,
       {},
       permute_rows},
      {"rows-and-neighbours-permuted",
       "Likewise, with the neighbours in the same order.",
       Expected::kHolds,
       {},
       swap_two_places},
  };
}

}  // namespace circumspect::properties
