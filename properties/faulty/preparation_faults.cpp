// Right triangulations of the wrong points: what happens between the caller and the algorithm.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>

#include "properties/faulty/fault.hpp"
#include "properties/faulty/plain_predicates.hpp"

namespace circumspect::faulty {
namespace {

// A coordinate as the algorithm gets to see it; one that is not finite is left as it was.
using Change = std::function<double(const PointArray&, std::size_t i, std::size_t axis)>;

SimplexArray with_coordinates(const PointArray& points, const Change& change) {
  PointArray changed = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      const double x = change(points, i, axis);
      if (std::isfinite(x)) changed.coordinates[i * points.dimension + axis] = x;
    }
  }
  return right_answer(changed);
}

double in_six_digits(const PointArray& points, std::size_t i, std::size_t axis) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", points.point(i)[axis]);
  return std::strtod(text, nullptr);
}

double in_single_precision(const PointArray& points, std::size_t i, std::size_t axis) {
  return static_cast<double>(static_cast<float>(points.point(i)[axis]));
}

double from_the_mean(const PointArray& points, std::size_t i, std::size_t axis) {
  double sum = 0;
  for (std::size_t j = 0; j < points.size(); ++j) sum += points.point(j)[axis];
  return points.point(i)[axis] - sum / static_cast<double>(points.size());
}

double in_the_unit_box(const PointArray& points, std::size_t i, std::size_t axis) {
  const auto [low, high] = extent(points, axis);
  return high > low ? (points.point(i)[axis] - low) / (high - low) : low;
}

double in_floats_from_the_corner(const PointArray& points, std::size_t i, std::size_t axis) {
  const double low = extent(points, axis).first;
  return low + static_cast<double>(static_cast<float>(points.point(i)[axis] - low));
}

double on_a_grid_of_16_bits(const PointArray& points, std::size_t i, std::size_t axis) {
  const auto [low, high] = extent(points, axis);
  if (!(high > low)) return low;
  const double step = (high - low) / 65535;
  return low + std::round((points.point(i)[axis] - low) / step) * step;
}

double in_millionths(const PointArray& points, std::size_t i, std::size_t axis) {
  const double scaled = points.point(i)[axis] * 1e6;
  if (!(std::abs(scaled) < 0x1p62)) return points.point(i)[axis];
  return static_cast<double>(static_cast<std::int32_t>(std::llround(scaled) & 0xffffffff)) / 1e6;
}

double by_columns(const PointArray& points, std::size_t i, std::size_t axis) {
  return points.coordinates[axis * points.size() + i];
}

double without_the_height(const PointArray& points, std::size_t i, std::size_t axis) {
  return axis == 2 ? 0.0 : points.point(i)[axis];
}

// Some fixed numbers between -1 and 1.
double noise(std::size_t i) {
  const std::uint64_t mixed = (i + 1) * 0x9e3779b97f4a7c15U;
  return static_cast<double>(mixed >> 40) / static_cast<double>(1U << 23) - 1;
}

double jittered(const PointArray& points, std::size_t i, std::size_t axis) {
  double largest = 0;
  for (const double x : points.coordinates) largest = std::max(largest, std::abs(x));
  return points.point(i)[axis] + 1e-9 * largest * noise(i * points.dimension + axis);
}

SimplexArray of_selection(const PointArray& points, const std::vector<Vertex>& kept) {
  return renumbered(right_answer(selection(points, kept)), kept);
}

SimplexArray without_the_last(const PointArray& points) {
  std::vector<Vertex> kept = every_index(points);
  if (kept.size() > 1) kept.pop_back();
  return of_selection(points, kept);
}

SimplexArray without_near_points(const PointArray& points) {
  std::vector<Vertex> kept;
  for (const Vertex v : every_index(points)) {
    const auto is_near = [&](Vertex other) {
      for (std::size_t axis = 0; axis < points.dimension; ++axis) {
        const double a = points.point(static_cast<std::size_t>(v))[axis];
        if (!(std::abs(a - points.point(static_cast<std::size_t>(other))[axis]) < 1e-9)) {
          return false;
        }
      }
      return true;
    };
    if (std::none_of(kept.begin(), kept.end(), is_near)) kept.push_back(v);
  }
  return of_selection(points, kept);
}

SimplexArray with_one_point_a_float_key(const PointArray& points) {
  std::map<std::vector<float>, Vertex> first;
  std::vector<Vertex> kept;
  for (const Vertex v : every_index(points)) {
    const double* p = points.point(static_cast<std::size_t>(v));
    std::vector<float> key;
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      key.push_back(static_cast<float>(p[axis]));
    }
    if (first.emplace(key, v).second) kept.push_back(v);
  }
  return of_selection(points, kept);
}

// Is the point strictly between two others?
bool is_between_others(const PointSet& points, Vertex v) {
  for (Vertex a = 0; points.names(a); ++a) {
    for (Vertex b = a + 1; points.names(b); ++b) {
      if (a == v || b == v) continue;
      const Point along = points[b] - points[a], to = points[v] - points[a];
      const Rational t = inner_product(to, along) / squared_length(along);
      if (sign(t) > 0 && t < 1 && to == t * along) return true;
    }
  }
  return false;
}

SimplexArray without_points_between_others(const PointArray& points) {
  const PointSet set = exact_points(points);
  std::vector<Vertex> kept = every_index(points);
  std::erase_if(kept, [&set](Vertex v) { return is_between_others(set, v); });
  return of_selection(points, kept);
}

SimplexArray with_one_point_an_abscissa(const PointArray& points) {
  std::map<double, Vertex> last;
  for (const Vertex v : every_index(points)) last[points.point(static_cast<std::size_t>(v))[0]] = v;
  std::vector<Vertex> kept;
  for (const auto& [x, v] : last) kept.push_back(v);
  return of_selection(points, kept);
}

SimplexArray in_sorted_numbers(const PointArray& points) {
  std::vector<Vertex> order = every_index(points);
  std::stable_sort(order.begin(), order.end(), [&points](Vertex a, Vertex b) {
    return points.point(static_cast<std::size_t>(a))[0] <
           points.point(static_cast<std::size_t>(b))[0];
  });
  return right_answer(selection(points, order));
}

SimplexArray shifted(const PointArray& points, std::int64_t by) {
  SimplexArray simplices = right_answer(points);
  for (auto& simplex : simplices) {
    for (auto& v : simplex) v += by;
  }
  return simplices;
}

Fault moving(std::string name, std::string about, const Change& change) {
  return implementation_fault(
      std::move(name), std::move(about),
      [change](const PointArray& points) { return with_coordinates(points, change); });
}

Fault of_space(Fault fault) {
  fault.dimensions = {3};
  return fault;
}

}  // namespace

std::vector<Fault> preparation_faults() {
  return {
      moving("six-digits", "Coordinates pass through text with six digits: `%g`, `operator<<`.",
             in_six_digits),
      moving("single-precision-input",
             "Exact predicates over coordinates that were stored as floats on the way.",
             in_single_precision),
      moving("centred-in-doubles", "The mean is subtracted first \"for accuracy\", which rounds.",
             from_the_mean),
      moving("scaled-axis-by-axis",
             "Each axis is scaled to [0, 1]: a normalisation under which spheres do not stay "
             "spheres.",
             in_the_unit_box),
      moving("jittered",
             "Points are moved by 1e-9 of their size at random so that none are cospherical, and "
             "the mesh of those is returned for the points as they were.",
             jittered),
      moving("floats-from-the-corner",
             "Coordinates are stored as floats from the lowest corner of the points: tiles of "
             "maps and scenes.",
             in_floats_from_the_corner),
      moving("grid-of-16-bits",
             "Coordinates are rounded to 65,536 steps of the bounding box: compressed meshes.",
             on_a_grid_of_16_bits),
      moving("millionths-in-32-bits",
             "Coordinates are multiplied by 1,000,000 and stored as integers of 32 bits.",
             in_millionths),
      moving("columns-for-rows",
             "The array holds all x, then all y; the program reads x, y, x, y: a binding between "
             "two languages.",
             by_columns),
      of_space(moving("height-not-read",
                      "Points of space are triangulated by their first two coordinates: terrain "
                      "code that was given any points.",
                      without_the_height)),
      implementation_fault("same-abscissa-overwrites",
                           "A sweep keeps its points in a map by their first coordinate, so of "
                           "those that share it the last is left.",
                           with_one_point_an_abscissa),
      implementation_fault("sorted-numbers-returned",
                           "The points are sorted first, and the simplices are returned in the "
                           "sorted numbers.",
                           in_sorted_numbers),
      implementation_fault("drops-the-last-point", "A loop ends at n − 1.", without_the_last),
      implementation_fault(
          "drops-near-points",
          "Points within 1e-9 of an earlier one count as duplicates, whatever the unit of length.",
          without_near_points),
      implementation_fault(
          "sorts-by-float-key",
          "Duplicates are found by a key of floats, so that distinct points are dropped.",
          with_one_point_a_float_key),
      implementation_fault("drops-points-between-others",
                           "Points on a line between two others are dropped as redundant: hull "
                           "code that was reused.",
                           without_points_between_others),
      implementation_fault("indices-from-one",
                           "Simplices are written with indices from 1, and read from 0.",
                           [](const PointArray& points) { return shifted(points, 1); }),
      implementation_fault(
          "super-vertices-not-subtracted",
          "The bounding simplex comes first in the array, and its indices were never subtracted.",
          [](const PointArray& points) {
            return shifted(points, static_cast<std::int64_t>(points.dimension) + 1);
          }),
  };
}

}  // namespace circumspect::faulty
