// What the tests of numbered laws share: a configuration made ready for the predicates, and
// runners that hold a law against random cases of each dimension.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <rapidcheck.h>

#include "kernel/predicates/configuration.hpp"
#include "properties/arguments/point_sets.hpp"
#include "properties/arguments/run.hpp"

namespace circumspect::generators {

// A configuration scales its points to integers in common or each on its own, and laws must hold
// for both. `kOwn` forces the second by one more point, which comes last and has a denominator of
// more than Configuration::kLargestCommonScale bits.
enum class Scaling { kCommon, kOwn };
Configuration configuration(const PointsCase& set, Scaling scaling);

// The vertices 0, 1, …, count − 1.
std::vector<Vertex> first_vertices(std::size_t count);

// A random order of the vertices. To be called within a property.
std::vector<Vertex> shuffled(std::vector<Vertex> vertices);

// A simplex, and points of its affine hull. `axes` is a coordinate system of that.
struct Scene {
  Configuration points;
  std::vector<std::size_t> axes;
  std::vector<Vertex> simplex;
  std::vector<Vertex> queries;
};
// Requires: a set that simplex_and_queries or simplex_first made.
Scene scene(const PointsCase& set, Scaling scaling);

// The image under x ↦ factor · x + translation, with weights times factor² (they are squared
// lengths). Requires: factor > 0.
PointsCase scaled_and_moved(const PointsCase& set, const Rational& factor,
                            const Point& translation);

// Does law(set, scaling) assert nothing false on the random cases? RapidCheck prints what fails. A
// law names the hundred inputs that are usual with RapidCheck.
template <typename Law>
bool holds(const std::string& what, const rc::Gen<PointsCase>& cases, const Law& law) {
  return properties::holds(what, 100, [&] {
    const PointsCase set = *cases;
    law(set, Scaling::kCommon);
    law(set, Scaling::kOwn);
  });
}

// In each dimension from `first` to `last`: on sets with a simplex in front.
template <typename Law>
bool holds_for_simplices(std::size_t first, std::size_t last, const Law& law) {
  bool all = true;
  for (std::size_t d = first; d <= last; ++d) {
    all = holds("dimension " + std::to_string(d), simplex_and_queries(d), law) && all;
  }
  return all;
}

// The same on sets of any kind, of up to d + 3 points.
template <typename Law>
bool holds_for_sets(std::size_t first, std::size_t last, const Law& law) {
  bool all = true;
  for (std::size_t d = first; d <= last; ++d) {
    const PointSets sets = any_point_set(d, d + 3);
    const auto cases = rc::gen::oneOf(unweighted(sets), weighted(sets));
    all = holds("dimension " + std::to_string(d), cases, law) && all;
  }
  return all;
}

}  // namespace circumspect::generators
