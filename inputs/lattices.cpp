#include "inputs/lattices.hpp"

#include <utility>

#include "inputs/scalars.hpp"
#include "inputs/set_parts.hpp"

namespace circumspect::generators {

PointSets cubic_lattice_points(std::size_t dimension, std::size_t max_points) {
  return sets_of(point_of(dimension, integer_number(3)), max_points);
}

PointSets body_centred_lattice_points(std::size_t dimension, std::size_t max_points) {
  const auto point = rc::gen::map(rc::gen::pair(point_of(dimension, integer_number(3)), below(2)),
                                  [](const std::pair<Point, long>& parts) {
                                    Point x = parts.first;
                                    for (Rational& c : x) c += Rational(parts.second) / 2;
                                    return x;
                                  });
  return sets_of(point, max_points);
}

PointSets face_centred_lattice_points(std::size_t dimension, std::size_t max_points) {
  const auto point = rc::gen::map(
      rc::gen::container<std::vector<long>>(dimension, integer_within(3)), [](std::vector<long> x) {
        long sum = 0;
        for (const long c : x) sum += c;
        if (sum % 2 != 0) x.back() += x.back() < 0 ? 1 : -1;
        return Point(x.begin(), x.end());
      });
  return sets_of(point, max_points);
}

PointSets hexagonal_lattice_points(std::size_t dimension, std::size_t max_points) {
  const auto point =
      rc::gen::map(rc::gen::container<std::vector<long>>(dimension, integer_within(3)),
                   [](const std::vector<long>& place) {
                     const double half_of_root_three = 0x1.bb67ae8584caap-1;
                     Point x(place.begin(), place.end());
                     x[0] += Rational(place[1]) / 2;
                     x[1] = exact_value(static_cast<double>(place[1]) * half_of_root_three);
                     return x;
                   });
  return sets_of(point, max_points);
}

}  // namespace circumspect::generators
