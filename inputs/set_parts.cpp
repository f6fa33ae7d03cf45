#include "inputs/set_parts.hpp"

#include <numeric>
#include <set>
#include <tuple>

#include "inputs/scalars.hpp"

namespace circumspect::generators {
namespace {

// A similarity of R^d: the reflection in the hyperplane normal to `mirror`, times |mirror|² so that
// integers stay integers, then a translation. No reflection if mirror is 0.
Point moved(const Point& x, const Point& mirror, const Point& translation) {
  const Rational scale = squared_length(mirror);
  if (sign(scale) == 0) return x + translation;
  return scale * x - (2 * inner_product(mirror, x)) * mirror + translation;
}

}  // namespace

rc::Gen<Point> point_of(std::size_t dimension, const rc::Gen<Rational>& coordinate) {
  return rc::gen::container<Point>(dimension, coordinate);
}

std::vector<Point> distinct(const std::vector<Point>& points) {
  std::set<Point> seen;
  std::vector<Point> once;
  for (const Point& point : points) {
    if (seen.insert(point).second) once.push_back(point);
  }
  return once;
}

PointSets sets_of(const rc::Gen<Point>& point, std::size_t max_points) {
  return rc::gen::map(up_to(max_points, point), distinct);
}

PointSets carried(const PointSets& sets, std::size_t dimension) {
  const auto small = point_of(dimension, integer_number(2));
  return rc::gen::map(rc::gen::tuple(sets, small, small),
                      [dimension](const std::tuple<std::vector<Point>, Point, Point>& parts) {
                        std::vector<Point> images;
                        for (Point x : std::get<0>(parts)) {
                          x.resize(dimension);
                          images.push_back(moved(x, std::get<1>(parts), std::get<2>(parts)));
                        }
                        return images;
                      });
}

Point from_stereographic(const Point& image) {
  const Rational square = squared_length(image);
  Point point = (2 / (square + 1)) * image;
  point.push_back((square - 1) / (square + 1));
  return point;
}

long cube_symmetries(std::size_t dimension) {
  long symmetries = 1;
  for (std::size_t i = 1; i <= dimension; ++i) symmetries *= 2 * static_cast<long>(i);
  return symmetries;
}

Point symmetric_image(const Point& point, long code) {
  std::vector<std::size_t> axes(point.size());
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  Point image;
  for (std::size_t left = point.size(); left > 0; --left) {
    const long choices = static_cast<long>(left);
    const auto chosen = axes.begin() + code % choices;
    code /= choices;
    image.push_back(code % 2 == 0 ? point[*chosen] : Rational(-point[*chosen]));
    code /= 2;
    axes.erase(chosen);
  }
  return image;
}

}  // namespace circumspect::generators
