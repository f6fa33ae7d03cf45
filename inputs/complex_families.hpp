// The named families of piecewise linear complexes, from which `circumspect generate`, campaigns
// and harnesses draw domains. Their vertices are doubles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "inputs/cases.hpp"
#include "inputs/point_sets.hpp"

namespace circumspect::generators {

struct ComplexFamily {
  std::string name;
  std::string about;  // one line: what the domains are, and the notion of the book that they stress
  std::size_t dimension = 3;  // 2 or 3
  // Valid complexes, of up to `max_points` points where the family leaves a choice.
  std::function<ComplexCase(Dice& dice, std::size_t max_points)> draw;
};

// A change that can be made to the domains of any family: "planar-grid+rotated". It returns valid
// domains of doubles.
struct ComplexModifier {
  std::string name;
  std::string about;
  ComplexCase (*modified)(Dice& dice, ComplexCase whole);
};
const std::vector<ComplexModifier>& complex_modifiers();

// The family with the modifier, both in its name and in its domains.
ComplexFamily modified(ComplexFamily family, const ComplexModifier& modifier);

// The families that need no Delaunay triangulation to be drawn. All of them, with those that are
// edge-protected: inputs/triangulated/domain_families.hpp.
const std::vector<ComplexFamily>& complex_families();

// Non-empty sets of integer points, which the families use as vertices.
std::vector<Point> integer_vertices(Dice& dice, std::size_t dimension, std::size_t max_points);

// The complex that a seed stands for, the same on every machine.
ComplexCase drawn(const ComplexFamily& family, std::size_t max_points, std::uint64_t seed);

}  // namespace circumspect::generators
