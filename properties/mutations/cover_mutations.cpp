#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "properties/mutations/catalogue.hpp"

namespace circumspect::properties {
namespace {

using enum Rule;

// Appends a point that is `factor` times another, its weight likewise.
void append_multiple(ArrayMesh& mesh, std::size_t v, double factor) {
  for (std::size_t axis = 0; axis < mesh.dimension; ++axis) {
    mesh.coordinates.push_back(mesh.coordinates[v * mesh.dimension + axis] * factor);
  }
  if (!mesh.weights.empty()) mesh.weights.push_back(mesh.weights[v] * factor * factor);
}

// Are half of these numbers doubles, and a quarter of the weights?
bool can_be_halved(const ArrayMesh& mesh) {
  const auto is_normal = [](double x) { return x == 0 || std::fabs(x) > 0x1p-1000; };
  return std::all_of(mesh.coordinates.begin(), mesh.coordinates.end(), is_normal) &&
         std::all_of(mesh.weights.begin(), mesh.weights.end(), is_normal);
}

bool list_all_twice(ArrayMesh& mesh, Dice&) {
  const std::vector<std::int64_t> once = mesh.simplices;
  mesh.simplices.insert(mesh.simplices.end(), once.rbegin(), once.rend());
  mesh.neighbors.clear();
  return true;
}

// All simplices again, on points of their own. The links stay right.
void add_copy(ArrayMesh& mesh, double factor) {
  const std::size_t points = mesh.points(), simplices = mesh.size();
  for (std::size_t v = 0; v < points; ++v) append_multiple(mesh, v, factor);
  for (std::size_t i = 0; i < simplices * mesh.width(); ++i) {
    const std::int64_t link = mesh.neighbors[i];
    mesh.simplices.push_back(mesh.simplices[i] + static_cast<std::int64_t>(points));
    mesh.neighbors.push_back(link < 0 ? link : link + static_cast<std::int64_t>(simplices));
  }
}

bool cover_by_equal_copy(ArrayMesh& mesh, Dice&) {
  add_copy(mesh, 1);
  return true;
}

// Is half of a point another one? Merged, the mesh and its half may be one that is right.
bool has_half_of_another(const ArrayMesh& mesh) {
  std::set<std::vector<double>> points;
  const auto point = [&mesh](std::size_t v, double factor) {
    std::vector<double> coordinates;
    for (std::size_t axis = 0; axis < mesh.dimension; ++axis) {
      coordinates.push_back(mesh.coordinates[v * mesh.dimension + axis] * factor);
    }
    return coordinates;
  };
  for (std::size_t v = 0; v < mesh.points(); ++v) points.insert(point(v, 1));
  for (std::size_t v = 0; v < mesh.points(); ++v) {
    const std::vector<double> half = point(v, 0.5);
    if (half != point(v, 1) && points.contains(half)) return true;
  }
  return false;
}

bool cover_by_half(ArrayMesh& mesh, Dice&) {
  if (!can_be_halved(mesh) || has_half_of_another(mesh)) return false;
  add_copy(mesh, 0.5);
  return true;
}

// The simplices around an edge {x, y}; empty if it is on the hull.
std::vector<std::size_t> simplices_around(const ArrayMesh& mesh, std::int64_t x, std::int64_t y) {
  std::vector<std::size_t> around;
  for (std::size_t s = 0; s < mesh.size(); ++s) {
    const auto row = mesh.row(s);
    if (std::find(row.begin(), row.end(), x) == row.end()) continue;
    if (std::find(row.begin(), row.end(), y) == row.end()) continue;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool leaves_edge = row[i] != x && row[i] != y;
      if (leaves_edge && mesh.neighbors[s * row.size() + i] < 0) return {};
    }
    around.push_back(s);
  }
  return around;
}

// Two copies that hang together along the vertices around an edge {x, y} (in the plane: of the two
// triangles at it): the second one has points of its own for all other vertices, and in the
// simplices around the edge the copies exchange x. So who turns once around those vertices comes to
// the other copy.
bool branch(ArrayMesh& mesh, std::int64_t x, std::int64_t y, double factor) {
  const std::vector<std::size_t> around = simplices_around(mesh, x, y);
  if (around.size() < 2 || (mesh.dimension == 3 && around.size() < 5)) return false;
  std::vector<std::int64_t> twin(mesh.points(), -1);
  for (const std::size_t s : around) {
    for (const std::int64_t v : mesh.row(s)) {
      if (v != x && v != y) twin[static_cast<std::size_t>(v)] = v;
    }
  }
  for (std::size_t v = 0; v < twin.size(); ++v) {
    if (twin[v] >= 0) continue;
    twin[v] = static_cast<std::int64_t>(mesh.points());
    append_multiple(mesh, v, factor);
  }
  const std::size_t once = mesh.simplices.size();
  for (std::size_t i = 0; i < once; ++i) {
    mesh.simplices.push_back(twin[static_cast<std::size_t>(mesh.simplices[i])]);
  }
  for (const std::size_t s : around) {
    for (std::size_t i = s * mesh.width(); i < (s + 1) * mesh.width(); ++i) {
      if (mesh.simplices[i] == x) std::swap(mesh.simplices[i], mesh.simplices[once + i]);
    }
  }
  mesh.neighbors.clear();
  return true;
}

bool branch_somewhere(ArrayMesh& mesh, Dice& dice, double factor) {
  for (int i = 0; i < 20; ++i) {
    const auto row = mesh.row(dice.below(mesh.size()));
    const std::size_t a = dice.below(row.size());
    const std::size_t b = (a + 1 + dice.below(row.size() - 1)) % row.size();
    if (branch(mesh, row[a], row[b], factor)) return true;
  }
  return false;
}

bool branch_on_equal_points(ArrayMesh& mesh, Dice& dice) { return branch_somewhere(mesh, dice, 1); }
bool branch_on_other_points(ArrayMesh& mesh, Dice& dice) {
  return branch_somewhere(mesh, dice, 1 - 0x1p-30);
}

}  // namespace

std::vector<Mutation> cover_mutations() {
  return {
      {"all-listed-twice",
       "Each simplex is listed twice.",
       Expected::kFails,
       {kDuplicateSimplex},
       list_all_twice},
      {"covered-by-equal-copy",
       "All again, on other points that are equal to the first.",
       Expected::kFails,
       {kDuplicateSimplex},
       cover_by_equal_copy},
      {"covered-by-half",
       "All again, on other points, in half of the size.",
       Expected::kFails,
       {kDuplicateSimplex, kDegenerateSimplex, kRepeatedVertex, kFacetOverused, kOverlap,
        kHullNotClosed, kHullNotConvex, kCoveredTwice, kPointBelowPlane},
       cover_by_half},
      {"branched-cover",
       "All again, on equal points; the copies hang together where they branch, around an edge.",
       Expected::kFails,
       {kDuplicateSimplex},
       branch_on_equal_points},
      {"branched-cover-of-other-points",
       "Likewise, on points that are not quite equal.",
       Expected::kFails,
       {kDegenerateSimplex, kDuplicateSimplex, kRepeatedVertex, kFacetOverused, kOverlap,
        kHullNotClosed, kHullNotConvex, kCoveredTwice, kPointBelowPlane},
       branch_on_other_points},
  };
}

ArrayMesh doubly_wound(std::size_t dimension, std::size_t around, std::size_t rings) {
  ArrayMesh mesh{.dimension = dimension, .coordinates = std::vector<double>(dimension, 0)};
  for (std::size_t ring = 1; ring <= rings; ++ring) {
    for (std::size_t i = 0; i < around; ++i) {
      const double angle =
          4 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around);
      const auto radius = static_cast<double>(ring);
      mesh.coordinates.insert(mesh.coordinates.end(),
                              {radius * std::cos(angle), radius * std::sin(angle)});
      if (dimension == 3) mesh.coordinates.push_back(0);
    }
  }
  const auto top = static_cast<std::int64_t>(mesh.points());
  if (dimension == 3) {
    const auto height = static_cast<double>(rings);
    mesh.coordinates.insert(mesh.coordinates.end(), {0, 0, height, 0, 0, -height});
  }
  const auto add = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
    if (dimension == 2) return void(mesh.simplices.insert(mesh.simplices.end(), {a, b, c}));
    mesh.simplices.insert(mesh.simplices.end(), {a, b, c, top, b, a, c, top + 1});
  };
  for (std::size_t ring = 1; ring <= rings; ++ring) {
    for (std::size_t i = 0; i < around; ++i) {
      const auto vertex = [&](std::size_t r, std::size_t k) {
        return r == 0 ? std::int64_t{0} : static_cast<std::int64_t>((r - 1) * around + k + 1);
      };
      const std::size_t next = (i + 1) % around;
      add(vertex(ring - 1, i), vertex(ring, i), vertex(ring, next));
      if (ring > 1) add(vertex(ring - 1, i), vertex(ring, next), vertex(ring - 1, next));
    }
  }
  return mesh;
}

}  // namespace circumspect::properties
