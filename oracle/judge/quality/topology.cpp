#include "oracle/judge/quality/topology.hpp"

#include <algorithm>
#include <array>

#include "kernel/complex/by_facet.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "oracle/judge/quality/enclosed_mesh.hpp"
#include "oracle/judge/quality/exact_measure.hpp"

namespace circumspect::quality {
namespace {

// Those that are not set apart, most of them by doubles.
std::vector<Simplex> sound_simplices(const Mesh& mesh) {
  const int dimension = dimension_of_simplices(mesh);
  std::vector<Simplex> sound;
  const auto add_if_sound = [&](std::size_t s, bool is_surely_sound) {
    const Simplex simplex = mesh.simplices[s];
    if (is_surely_sound || measured(Measure::kEdge, mesh, simplex, dimension)) {
      sound.push_back(simplex);
    }
  };
  const std::size_t count = mesh.simplices.size();
  enclosed_or_else(
      mesh,
      [&]<class Enclosing>(const Enclosing& enclosing) {
        SquaredLengths<Enclosing::kDimension, double> lengths;
        for (std::size_t s = 0; s < count; ++s) {
          const bool has_lengths = enclosing.set_lengths(s, lengths);
          add_if_sound(s, has_lengths && spread(enclosed(lengths)).is_surely_positive());
        }
      },
      [&] {
        for (std::size_t s = 0; s < count; ++s) add_if_sound(s, false);
      });
  return sound;
}

std::vector<Simplex> boundary_of(const std::vector<Simplex>& simplices) {
  std::vector<Simplex> boundary;
  for (const auto uses : ByFacet(facet_uses(simplices))) {
    if (uses.size() == 1) boundary.push_back(uses.front().facet);
  }
  return boundary;
}

// How many different faces of so many vertices there are.
template <std::size_t kSize>
std::size_t count_faces(const std::vector<Simplex>& simplices) {
  std::vector<std::array<Vertex, kSize>> faces;
  for (const Simplex& simplex : simplices) {
    Simplex places = first_subset(kSize);
    do {
      auto& face = faces.emplace_back();
      for (std::size_t i = 0; i < kSize; ++i) {
        face[i] = simplex[static_cast<std::size_t>(places[i])];
      }
      std::sort(face.begin(), face.end());
    } while (next_subset(places, simplex.size()));
  }
  std::sort(faces.begin(), faces.end());
  return static_cast<std::size_t>(std::unique(faces.begin(), faces.end()) - faces.begin());
}

std::vector<std::size_t> face_counts(const std::vector<Simplex>& simplices) {
  const std::size_t most = simplices.empty() ? 0 : simplices.front().size();
  std::vector<std::size_t> counts;
  if (most >= 1) counts.push_back(count_faces<1>(simplices));
  if (most >= 2) counts.push_back(count_faces<2>(simplices));
  if (most >= 3) counts.push_back(count_faces<3>(simplices));
  if (most >= 4) counts.push_back(count_faces<4>(simplices));
  return counts;
}

long alternating_sum(const std::vector<std::size_t>& counts) {
  long sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const long count = static_cast<long>(counts[i]);
    sum += i % 2 == 0 ? count : -count;
  }
  return sum;
}

// How the simplices of a list are joined by facets.
struct Joined {
  std::size_t parts = 0;
  std::size_t open_facets = 0;
  bool is_branched = false;  // is a facet in three simplices or more?
  bool is_orientable = true;
};

Joined joined(const std::vector<Simplex>& simplices) {
  Joined found;
  // Each simplex once as it is listed, and once turned over.
  DisjointSets parts(simplices.size()), turned(2 * simplices.size());
  for (const auto uses : ByFacet(facet_uses(simplices))) {
    found.open_facets += uses.size() == 1 ? 1 : 0;
    found.is_branched |= uses.size() > 2;
    for (std::size_t i = 1; i < uses.size(); ++i) {
      const std::size_t a = uses[0].simplex, b = uses[i].simplex;
      parts.unite(a, b);
      const auto sense = [&](const FacetUse& use) {
        const Simplex facet = facet_opposite(simplices[use.simplex], use.opposite);
        return is_odd_permutation(facet) != (use.opposite % 2 != 0);
      };
      const std::size_t same = sense(uses[0]) == sense(uses[i]) ? 1 : 0;
      turned.unite(2 * a, 2 * b + same);
      turned.unite(2 * a + 1, 2 * b + 1 - same);
    }
  }
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    found.parts += parts.find(s) == s ? 1 : 0;
    found.is_orientable &= turned.find(2 * s) != turned.find(2 * s + 1);
  }
  return found;
}

// 2 · parts − circles − χ is twice the number of handles of a surface.
std::optional<std::size_t> genus_of(const std::vector<Simplex>& surface, std::size_t circles) {
  const Joined how = joined(surface);
  if (how.is_branched || !how.is_orientable) return std::nullopt;
  const long twice = 2 * static_cast<long>(how.parts) - static_cast<long>(circles) -
                     alternating_sum(face_counts(surface));
  if (twice < 0 || twice % 2 != 0) return std::nullopt;
  return static_cast<std::size_t>(twice / 2);
}

// The square of the size of a simplex of so many corners.
Rational squared_size(const Mesh& mesh, const Simplex& simplex) {
  std::vector<Point> corners;
  for (const Vertex v : simplex) corners.push_back(mesh.point(v));
  const Measure measure = corners.size() == 4   ? Measure::kVolume
                          : corners.size() == 3 ? Measure::kArea
                                                : Measure::kEdge;
  return measured(measure, corners).value;
}

// The size of a simplex of the dimension of the space, which is 1, 2 or 3.
Rational full_size(const Mesh& mesh, const Simplex& simplex) {
  using circumspect::operator-;  // of points, which that of enclosed numbers hides
  const Point origin = mesh.point(simplex[0]), u = mesh.point(simplex[1]) - origin;
  if (simplex.size() == 2) return abs(u[0]);
  const Point v = mesh.point(simplex[2]) - origin;
  if (simplex.size() == 3) {
    return abs(cross_product({u[0], u[1], 0}, {v[0], v[1], 0})[2]) / 2;
  }
  return abs(inner_product(cross_product(u, v), mesh.point(simplex[3]) - origin)) / 6;
}

Size sum_of_sizes(const Mesh& mesh, const std::vector<Simplex>& simplices) {
  if (!simplices.empty() && simplices.front().size() == mesh.dimension() + 1) {
    Rational sum = 0;
    for (const Simplex& simplex : simplices) sum += full_size(mesh, simplex);
    return {sum, to_decimal(sum)};
  }
  std::vector<Rational> squares;
  for (const Simplex& simplex : simplices) squares.push_back(squared_size(mesh, simplex));
  return {std::nullopt, sum_of_roots_to_decimal(squares)};
}

}  // namespace

Topology topology(const Mesh& mesh) {
  const std::vector<Simplex> simplices = sound_simplices(mesh);
  Topology found{.faces = face_counts(simplices)};
  found.euler_characteristic = alternating_sum(found.faces);
  const std::vector<Simplex> boundary = boundary_of(simplices);
  const Joined how = joined(boundary);
  found.boundary_facets = boundary.size();
  found.boundary_parts = how.parts;
  if (simplices.empty()) return found;
  if (simplices.front().size() == 3) found.genus = genus_of(simplices, how.parts);
  if (simplices.front().size() == 4 && how.open_facets == 0) found.genus = genus_of(boundary, 0);
  return found;
}

Size size_of(const Mesh& mesh) { return sum_of_sizes(mesh, sound_simplices(mesh)); }

Size size_of_boundary(const Mesh& mesh) {
  return sum_of_sizes(mesh, boundary_of(sound_simplices(mesh)));
}

}  // namespace circumspect::quality
