// For RapidCheck: points of the families, which shrink by leaving points out.
//
//   rc::check("my library", [] {
//     const auto points = *circumspect::points_of_families(3);
//     RC_PRE(!circumspect::are_flat(points));  // unless it handles these
//     circumspect::assert_holds("delaunay", points, my_triangulate(points));
//   });
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <circumspect/inputs.hpp>
#include <circumspect/judgement.hpp>
#include <circumspect/subject.hpp>
#include <rapidcheck.h>

namespace circumspect {

inline void showValue(const PointArray& points, std::ostream& out) {
  const auto precision = out.precision(17);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < points.dimension; ++axis) {
      out << (axis == 0 ? "\n" : " ") << points.point(i)[axis];
    }
  }
  out.precision(precision);
}

// The points but for those from `first` to before `last`.
inline PointArray without_points(PointArray points, std::size_t first, std::size_t last) {
  const auto at = [&](std::size_t i) {
    return points.coordinates.begin() + static_cast<std::ptrdiff_t>(i * points.dimension);
  };
  points.coordinates.erase(at(first), at(last));
  return points;
}

// At least dimension + 1 points, at most `max_points`, of one of the families; none: of all.
inline rc::Gen<PointArray> points_of_families(std::size_t dimension, std::size_t max_points = 20,
                                              std::vector<std::string> names = {}) {
  if (names.empty()) names = families(dimension);
  const auto drawn = rc::gen::map(
      rc::gen::pair(rc::gen::elementOf(std::move(names)), rc::gen::arbitrary<std::uint64_t>()),
      [=](const std::pair<std::string, std::uint64_t>& by) {
        return drawn_points(by.first, dimension, max_points, by.second);
      });
  return rc::gen::shrink(rc::gen::noShrink(drawn), [](PointArray points) {
    std::vector<PointArray> smaller;
    for (std::size_t chunk = points.size() / 2; chunk > 0; chunk /= 2) {
      for (std::size_t first = 0; first < points.size(); first += chunk) {
        const std::size_t last = std::min(first + chunk, points.size());
        if (points.size() - (last - first) <= points.dimension) continue;
        smaller.push_back(without_points(points, first, last));
      }
    }
    return rc::seq::fromContainer(std::move(smaller));
  });
}

}  // namespace circumspect
