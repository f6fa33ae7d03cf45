#include "oracle/judge/quality/topology.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

#include "kernel/complex/vertex_sets.hpp"
#include "kernel/exact/number_text.hpp"
#include "kernel/exact/triple.hpp"
#include "kernel/piecewise_linear/disjoint_sets.hpp"
#include "oracle/judge/quality/enclosed_mesh.hpp"
#include "oracle/judge/quality/exact_measure.hpp"

namespace circumspect::quality {
namespace {

// The vertices of a simplex, in the order given.
template <std::size_t kSize>
using Corners = std::array<std::int32_t, kSize>;
template <std::size_t kSize>
using CornersList = std::vector<Corners<kSize>>;

// The simplices of kSize vertices that are not set apart, most of them by doubles.
template <std::size_t kSize>
CornersList<kSize> sound_simplices(const Mesh& mesh) {
  CornersList<kSize> sound;
  const auto add_if_sound = [&](std::size_t s, bool is_surely_sound) {
    const Simplex simplex = mesh.simplices[s];
    if (!is_surely_sound && !measured(Measure::kEdge, mesh, simplex, kSize - 1)) return;
    Corners<kSize>& corners = sound.emplace_back();
    for (std::size_t i = 0; i < kSize; ++i) corners[i] = static_cast<std::int32_t>(simplex[i]);
  };
  const std::size_t count = mesh.simplices.size();
  sound.reserve(count);
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

// Calls `visit` with the places of each choice of kOf among kAll vertices.
template <std::size_t kOf, std::size_t kAll, class Visit>
void each_choice(const Visit& visit) {
  Simplex places = first_subset(kOf);
  do {
    visit(places);
  } while (next_subset(places, kAll));
}

// The faces of kFace vertices, with the place of their simplex in the list times kSize, and, of
// facets, the place of the vertex opposite added to it.
template <std::size_t kFace, std::size_t kSize>
VertexSets<kFace> faces_of(const CornersList<kSize>& simplices, std::size_t points) {
  std::vector<std::array<std::size_t, kFace>> choices;
  each_choice<kFace, kSize>([&](const Simplex& places) {
    auto& choice = choices.emplace_back();
    std::copy(places.begin(), places.end(), choice.begin());
  });
  // Facets come with the last vertex opposite first.
  return VertexSets<kFace>(points, [&](const auto& visit) {
    for (std::size_t s = 0; s < simplices.size(); ++s) {
      for (std::size_t c = 0; c < choices.size(); ++c) {
        typename VertexSets<kFace>::Set face;
        for (std::size_t i = 0; i < kFace; ++i) face[i] = simplices[s][choices[c][i]];
        const std::size_t opposite = kFace + 1 == kSize ? kFace - c : 0;
        visit(face, static_cast<std::int32_t>(s * kSize + opposite));
      }
    }
  });
}

template <std::size_t kSize>
CornersList<kSize - 1> boundary_of(const CornersList<kSize>& simplices, std::size_t points) {
  CornersList<kSize - 1> boundary;
  faces_of<kSize - 1>(simplices, points).for_each_group([&](std::int32_t least, auto uses) {
    if (uses.size() != 1) return;
    Corners<kSize - 1>& facet = boundary.emplace_back();
    facet.front() = least;
    std::copy(uses[0].others.begin(), uses[0].others.end(), facet.begin() + 1);
  });
  return boundary;
}

// How many different faces of each number of vertices there are.
template <std::size_t kSize>
std::vector<std::size_t> face_counts(const CornersList<kSize>& simplices, std::size_t points) {
  std::vector<std::size_t> counts;
  const auto count = [&]<std::size_t kFace>(std::integral_constant<std::size_t, kFace>) {
    std::size_t different = 0;
    faces_of<kFace>(simplices, points).for_each_group([&](std::int32_t, auto) { ++different; });
    counts.push_back(different);
  };
  count(std::integral_constant<std::size_t, 1>());
  if constexpr (kSize >= 2) count(std::integral_constant<std::size_t, 2>());
  if constexpr (kSize >= 3) count(std::integral_constant<std::size_t, 3>());
  if constexpr (kSize >= 4) count(std::integral_constant<std::size_t, 4>());
  return counts;
}

std::int64_t alternating_sum(const std::vector<std::size_t>& counts) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const auto count = static_cast<std::int64_t>(counts[i]);
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

template <std::size_t kSize>
Joined joined(const CornersList<kSize>& simplices, std::size_t points) {
  Joined found;
  // Each simplex once as it is listed, and once turned over.
  DisjointSets parts(simplices.size()), turned(2 * simplices.size());
  const auto simplex_of = [](const auto& use) {
    return static_cast<std::size_t>(use.origin) / kSize;
  };
  const auto sense = [&](const auto& use) {
    const std::size_t opposite = static_cast<std::size_t>(use.origin) % kSize;
    const auto& corners = simplices[simplex_of(use)];
    const Simplex facet = facet_opposite({corners.begin(), corners.end()}, opposite);
    return is_odd_permutation(facet) != (opposite % 2 != 0);
  };
  faces_of<kSize - 1>(simplices, points).for_each_group([&](std::int32_t, auto uses) {
    found.open_facets += uses.size() == 1 ? 1 : 0;
    found.is_branched |= uses.size() > 2;
    for (std::size_t i = 1; i < uses.size(); ++i) {
      const std::size_t a = simplex_of(uses[0]), b = simplex_of(uses[i]);
      parts.unite(a, b);
      const std::size_t same = sense(uses[0]) == sense(uses[i]) ? 1 : 0;
      turned.unite(2 * a, 2 * b + same);
      turned.unite(2 * a + 1, 2 * b + 1 - same);
    }
  });
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    found.parts += parts.find(s) == s ? 1 : 0;
    found.is_orientable &= turned.find(2 * s) != turned.find(2 * s + 1);
  }
  return found;
}

// 2 · parts − circles − χ is twice the number of handles of a surface.
std::optional<std::size_t> genus_of(const CornersList<3>& surface, std::size_t circles,
                                    std::size_t points) {
  const Joined how = joined(surface, points);
  if (how.is_branched || !how.is_orientable) return std::nullopt;
  const auto twice = 2 * static_cast<std::int64_t>(how.parts) - static_cast<std::int64_t>(circles) -
                     alternating_sum(face_counts(surface, points));
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

// The sum of the absolute determinants of simplices of the dimension of the space. `points` have
// zeros for the coordinates that are missing.
template <class Number, std::size_t kSize>
Number sum_of_determinants(const std::vector<Triple<Number>>& points,
                           const CornersList<kSize>& simplices) {
  Number sum = 0;
  for (const auto& corners : simplices) {
    const auto from_first = [&](std::size_t i) {
      return difference(points[static_cast<std::size_t>(corners[i])],
                        points[static_cast<std::size_t>(corners[0])]);
    };
    const Triple<Number> u = from_first(1);
    if constexpr (kSize == 2) {
      sum += abs(u[0]);
    } else if constexpr (kSize == 3) {
      sum += abs(cross_product(u, from_first(2))[2]);
    } else {
      sum += abs(inner_product(cross_product(u, from_first(2)), from_first(3)));
    }
  }
  return sum;
}

// By integers over one denominator, unless that is so long that fractions are shorter.
template <std::size_t kSize>
Rational full_size(const Mesh& mesh, const CornersList<kSize>& simplices) {
  const std::vector<Point> points = mesh.exact_points();
  Integer denominator = 1;
  for (const Point& point : points) {
    denominator = common_denominator(point, std::move(denominator));
    if (bit_length(denominator) > Configuration::kLargestCommonScale) break;
  }
  constexpr long kParts = kSize == 4 ? 6 : kSize - 1;
  const auto in_triples = [&]<class Number>(const auto& number) {
    std::vector<Triple<Number>> triples(points.size());
    for (std::size_t v = 0; v < points.size(); ++v) {
      for (std::size_t axis = 0; axis + 1 < kSize; ++axis) {
        triples[v][axis] = number(points[v][axis]);
      }
    }
    return triples;
  };
  if (bit_length(denominator) > Configuration::kLargestCommonScale) {
    const auto as_it_is = [](const Rational& x) { return x; };
    return sum_of_determinants(in_triples.template operator()<Rational>(as_it_is), simplices) /
           kParts;
  }
  const auto over_denominator = [&](const Rational& x) { return numerator_over(denominator, x); };
  Rational size(
      sum_of_determinants(in_triples.template operator()<Integer>(over_denominator), simplices));
  size /= kParts;
  for (std::size_t axis = 0; axis + 1 < kSize; ++axis) size /= denominator;
  return size;
}

template <std::size_t kSize>
Size sum_of_sizes(const Mesh& mesh, const CornersList<kSize>& simplices) {
  const auto simplex_of = [](const Corners<kSize>& corners) {
    return Simplex(corners.begin(), corners.end());
  };
  if (!simplices.empty() && kSize == mesh.dimension() + 1) {
    const Rational sum = full_size(mesh, simplices);
    return {sum, to_decimal(sum)};
  }
  std::vector<Rational> squares;
  for (const auto& corners : simplices) squares.push_back(squared_size(mesh, simplex_of(corners)));
  return {std::nullopt, sum_of_roots_to_decimal(squares)};
}

template <std::size_t kSize>
Topology topology_of(const Mesh& mesh) {
  const std::size_t points = mesh.points();
  const CornersList<kSize> simplices = sound_simplices<kSize>(mesh);
  if (simplices.empty()) return {};
  Topology found{.faces = face_counts(simplices, points)};
  found.euler_characteristic = alternating_sum(found.faces);
  const auto boundary = boundary_of(simplices, points);
  found.boundary_facets = boundary.size();
  Joined how;
  if constexpr (kSize > 2) {
    how = joined(boundary, points);
  } else if (!boundary.empty()) {
    how.parts = 1;  // all ends have the empty ridge in common
  }
  found.boundary_parts = how.parts;
  if constexpr (kSize == 3) found.genus = genus_of(simplices, how.parts, points);
  if constexpr (kSize == 4) {
    if (how.open_facets == 0) found.genus = genus_of(boundary, 0, points);
  }
  return found;
}

// Calls `with` with how many vertices a simplex has, as a constant; `otherwise` if that is not 2 to
// 4, for then all simplices are set apart.
template <class Answer, class With>
Answer by_size(const Mesh& mesh, Answer otherwise, const With& with) {
  switch (dimension_of_simplices(mesh)) {
    case 1:
      return with(std::integral_constant<std::size_t, 2>());
    case 2:
      return with(std::integral_constant<std::size_t, 3>());
    case 3:
      return with(std::integral_constant<std::size_t, 4>());
    default:
      return otherwise;
  }
}

const Size kNothing = {std::nullopt, "0"};

}  // namespace

Topology topology(const Mesh& mesh) {
  return by_size(mesh, Topology(), [&](auto size) { return topology_of<size()>(mesh); });
}

Size size_of(const Mesh& mesh) {
  return by_size(mesh, kNothing,
                 [&](auto size) { return sum_of_sizes(mesh, sound_simplices<size()>(mesh)); });
}

Size size_of_boundary(const Mesh& mesh) {
  return by_size(mesh, kNothing, [&](auto size) {
    return sum_of_sizes(mesh, boundary_of(sound_simplices<size()>(mesh), mesh.points()));
  });
}

}  // namespace circumspect::quality
