#include "oracle/certificate/complex_certificate.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <numeric>

#include "kernel/boxes/box_index.hpp"
#include "kernel/complex/simplex.hpp"
#include "oracle/judge/fast/box_tree.hpp"

namespace circumspect::certificate {
namespace {

using Vector = std::vector<Integer>;

struct Hyperplane {
  Vector normal;
  Integer offset;

  Integer at(const Vector& p) const {
    Integer value = -offset;
    for (std::size_t axis = 0; axis < p.size(); ++axis) value += normal[axis] * p[axis];
    return value;
  }
};

// Through d points of R^d, d being 2 or 3; its normal is 0 if they are not affinely independent.
Hyperplane through(const std::vector<Vector>& points) {
  const auto difference = [&](std::size_t i, std::size_t axis) {
    return Integer(points[i][axis] - points[0][axis]);
  };
  Hyperplane plane{{}, 0};
  if (points.size() == 2) {
    plane.normal = {difference(1, 1), -difference(1, 0)};
  } else {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t next = (axis + 1) % 3;
      const std::size_t last = (axis + 2) % 3;
      plane.normal.emplace_back(difference(1, next) * difference(2, last) -
                                difference(1, last) * difference(2, next));
    }
  }
  Integer common = 0;
  for (const Integer& x : plane.normal) common = gcd(common, x);
  if (common == 0) return plane;
  for (Integer& x : plane.normal) x /= common;
  plane.offset = plane.at(points[0]);
  return plane;
}

bool is_zero(const Hyperplane& plane) {
  return std::all_of(plane.normal.begin(), plane.normal.end(),
                     [](const Integer& x) { return x == 0; });
}

class Partings {
 public:
  Partings(const ExactMesh& mesh, const ScaledPoints& points);

  std::vector<Vector> pads(const Simplex& simplex) const;
  // Nothing if the hyperplane of a facet shows it.
  std::optional<Parting> between(std::size_t s, std::size_t t);

 private:
  Vector place(Vertex v) const {
    Vector p;
    for (std::size_t axis = 0; axis < points_.dimension; ++axis) {
      p.push_back(points_.coordinate(v, axis));
    }
    return p;
  }
  // The sign of the plane's value there.
  int side_of(const Hyperplane& plane, Vertex v) const {
    Integer value = -plane.offset;
    for (std::size_t axis = 0; axis < points_.dimension; ++axis) {
      add_product(value, plane.normal[axis], points_.coordinate(v, axis));
    }
    return sign(value);
  }
  std::vector<Vector> places(const Simplex& simplex) const {
    std::vector<Vector> all;
    for (const Vertex v : simplex) all.push_back(place(v));
    return all;
  }
  // Is there a facet of simplex s such that each vertex of the other simplex is a vertex of it, or
  // lies strictly beyond its hyperplane? A simplex in a hyperplane is a facet with two sides.
  bool is_beyond_facet(std::size_t s, const Simplex& other);
  // On which side of the facet opposite vertex number `place` a vertex lies: positive on that of
  // the vertex opposite. Of a simplex in a hyperplane, `place` is its size, and either side may be
  // the positive one.
  int side(std::size_t s, std::size_t place, Vertex v);
  // On which sides a may lie of the hyperplane through the chosen points of completed(a, b), with b
  // on the other: above is where the hyperplane of through() is positive. Nothing if one of the
  // points is not a vertex: then integers decide.
  struct Sides {
    bool above = true, below = true;
  };
  std::optional<Sides> sides_of(const std::vector<bool>& is_chosen, const Simplex& a,
                                const Simplex& b);
  // Points that span, together with the vertices of both, the plane or space.
  std::vector<Vector> completed(const Simplex& a, const Simplex& b) const;
  bool parts(const Hyperplane& plane, const Simplex& above, const Simplex& below) const;

  const ExactMesh& mesh_;
  const ScaledPoints& points_;
  Sidedness sidedness_;
  std::vector<signed char> orientations_;  // 0 for a simplex that has none
};

Partings::Partings(const ExactMesh& mesh, const ScaledPoints& points)
    : mesh_(mesh), points_(points), sidedness_(points) {
  orientations_.reserve(mesh.simplices.size());
  for (const Simplex& simplex : mesh.simplices) {
    const bool has_one = simplex.size() == points.dimension + 1;
    orientations_.push_back(
        static_cast<signed char>(has_one ? sidedness_.orientation(simplex) : 0));
  }
}

int Partings::side(std::size_t s, std::size_t place, Vertex v) {
  const Simplex& simplex = mesh_.simplices[s];
  std::array<Vertex, 4> moved;
  std::copy(simplex.begin(), simplex.end(), moved.begin());
  moved[place] = v;
  const int sign = sidedness_.orientation(std::span(moved).first(points_.dimension + 1));
  return orientations_[s] == 0 ? sign : sign * orientations_[s];
}

bool Partings::is_beyond_facet(std::size_t s, const Simplex& other) {
  const Simplex& simplex = mesh_.simplices[s];
  const std::size_t d = points_.dimension;
  if (simplex.size() < d) return false;
  std::array<bool, 4> is_shared = {};  // by places in the simplex
  std::array<Vertex, 4> others;
  std::size_t size = 0;
  for (const Vertex v : other) {
    const auto own = std::find(simplex.begin(), simplex.end(), v);
    if (own != simplex.end()) {
      is_shared[static_cast<std::size_t>(own - simplex.begin())] = true;
    } else {
      others[size++] = v;
    }
  }
  const auto all_are_beyond = [&](std::size_t place, int sign) {
    if (is_shared[place]) return false;
    return std::all_of(others.begin(), others.begin() + size,
                       [&](Vertex v) { return side(s, place, v) * sign > 0; });
  };
  if (simplex.size() == d) return all_are_beyond(d, 1) || all_are_beyond(d, -1);
  for (std::size_t place = 0; place <= d; ++place) {
    if (all_are_beyond(place, -1)) return true;
  }
  return false;
}

std::vector<Vector> Partings::pads(const Simplex& simplex) const {
  const std::vector<Vector> all = places(simplex);
  const std::size_t d = points_.dimension;
  std::vector<bool> is_wanted(d, true);  // the axes along which there is a pad
  if (all.size() == d + 1) return {};
  const auto spare_one = [&](const Vector& direction) {
    std::size_t axis = 0;
    while (direction[axis] == 0) ++axis;
    is_wanted[axis] = false;
  };
  if (all.size() == 2) {
    Vector direction = all[1];
    for (std::size_t axis = 0; axis < d; ++axis) direction[axis] -= all[0][axis];
    spare_one(direction);
  } else if (all.size() == 3) {  // a triangle in space: only the axis that leaves its plane
    const Vector normal = through(all).normal;
    std::size_t axis = 0;
    while (normal[axis] == 0) ++axis;
    is_wanted.assign(d, false);
    is_wanted[axis] = true;
  }
  std::vector<Vector> made;
  for (std::size_t axis = 0; axis < d; ++axis) {
    if (!is_wanted[axis]) continue;
    made.push_back(all[0]);
    made.back()[axis] += 1;
  }
  return made;
}

bool Partings::parts(const Hyperplane& plane, const Simplex& above, const Simplex& below) const {
  return std::all_of(above.begin(), above.end(),
                     [&](Vertex v) {
                       const int side = side_of(plane, v);
                       return side > 0 || (side == 0 && contains(below, v));
                     }) &&
         std::all_of(below.begin(), below.end(), [&](Vertex v) { return side_of(plane, v) <= 0; });
}

std::vector<Vector> Partings::completed(const Simplex& a, const Simplex& b) const {
  std::vector<Vector> all = places(a);
  for (const Vertex v : b) {
    if (!contains(a, v)) all.push_back(place(v));
  }
  const std::size_t d = points_.dimension;
  if (a.size() == d + 1 || b.size() == d + 1) return all;  // no simplex is flat
  // Each point that leaves the affine hull of those before it; then so does one along an axis.
  std::vector<Vector> basis;  // differences, in row echelon form
  const auto leaves = [&](Vector u) {
    for (const Vector& row : basis) {
      std::size_t pivot = 0;
      while (row[pivot] == 0) ++pivot;
      const Integer factor = u[pivot];
      if (factor == 0) continue;
      for (std::size_t axis = 0; axis < d; ++axis) {
        u[axis] = u[axis] * row[pivot] - factor * row[axis];
      }
    }
    if (std::all_of(u.begin(), u.end(), [](const Integer& x) { return x == 0; })) return false;
    basis.push_back(std::move(u));
    return true;
  };
  for (const Vector& p : all) {
    Vector u = p;
    for (std::size_t axis = 0; axis < d; ++axis) u[axis] -= all[0][axis];
    leaves(std::move(u));
  }
  const Vector origin = all[0];
  for (std::size_t axis = 0; axis < d; ++axis) {
    Vector u(d, 0);
    u[axis] = 1;
    if (!leaves(std::move(u))) continue;
    all.push_back(origin);
    all.back()[axis] += 1;
  }
  return all;
}

std::optional<Partings::Sides> Partings::sides_of(const std::vector<bool>& is_chosen,
                                                  const Simplex& a, const Simplex& b) {
  const std::size_t d = points_.dimension;
  std::array<Vertex, 4> through;  // and the vertex that is looked at
  std::size_t size = 0, number = 0;
  const auto take = [&](Vertex v) {
    if (is_chosen[number++]) through[size++] = v;
  };
  for (const Vertex v : a) take(v);
  for (const Vertex v : b) {
    if (!contains(a, v)) take(v);
  }
  if (size < d) return std::nullopt;
  const auto end_of_chosen = through.begin() + static_cast<std::ptrdiff_t>(d);
  Sides sides;
  const auto look_at = [&](const Simplex& simplex, int side) {
    for (const Vertex v : simplex) {
      if (std::find(through.begin(), end_of_chosen, v) != end_of_chosen) continue;
      through[d] = v;
      // Where the hyperplane is positive, the orientation is negative.
      const int sign = -side * sidedness_.orientation(std::span(through).first(d + 1));
      sides.above &= sign >= 0;
      sides.below &= sign <= 0;
      if (!sides.above && !sides.below) return;
    }
  };
  look_at(a, 1);
  if (sides.above || sides.below) look_at(b, -1);
  return sides;
}

std::optional<Parting> Partings::between(std::size_t s, std::size_t t) {
  const Simplex& a = mesh_.simplices[s];
  const Simplex& b = mesh_.simplices[t];
  if (is_beyond_facet(s, b) || is_beyond_facet(t, a)) return std::nullopt;
  // The hyperplanes that do not cross the two make a cone, whose extreme rays go through d points:
  // the sum of these is in no face of it (docs/theory/complex.md).
  const std::size_t d = points_.dimension;
  const std::vector<Vector> all = completed(a, b);
  Hyperplane sum{Vector(d, 0), 0};
  std::vector<bool> is_chosen(all.size(), false);
  std::fill_n(is_chosen.begin(), d, true);
  do {
    const std::optional<Sides> sides = sides_of(is_chosen, a, b);
    if (sides && !sides->above && !sides->below) continue;
    std::vector<Vector> chosen;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (is_chosen[i]) chosen.push_back(all[i]);
    }
    const Hyperplane plane = through(chosen);
    if (is_zero(plane)) continue;
    const auto lies = [&](const Simplex& simplex, int side) {
      return std::all_of(simplex.begin(), simplex.end(),
                         [&](Vertex v) { return side_of(plane, v) * side >= 0; });
    };
    for (const int side : {1, -1}) {
      const bool is_parting =
          sides ? (side > 0 ? sides->above : sides->below) : lies(a, side) && lies(b, -side);
      if (!is_parting) continue;
      for (std::size_t axis = 0; axis < d; ++axis) sum.normal[axis] += side * plane.normal[axis];
      sum.offset += side * plane.offset;
    }
  } while (std::prev_permutation(is_chosen.begin(), is_chosen.end()));
  assert(parts(sum, a, b));
  return Parting{t, std::move(sum.normal), std::move(sum.offset)};
}

// Halves those from `first` on again and again, at the median of the longest side of the box around
// their centres.
void put_near(std::vector<std::size_t>::iterator first, std::vector<std::size_t>::iterator last,
              const std::vector<std::vector<double>>& centres) {
  constexpr std::ptrdiff_t kFew = 2;
  if (last - first <= kFew) return;
  std::size_t longest = 0;
  double length = -1;
  for (std::size_t axis = 0; axis < centres[*first].size(); ++axis) {
    const auto [low, high] = std::minmax_element(
        first, last, [&](auto s, auto t) { return centres[s][axis] < centres[t][axis]; });
    const double extent = centres[*high][axis] - centres[*low][axis];
    if (extent > length) {
      longest = axis;
      length = extent;
    }
  }
  // Halves of a length that is a power of two stay together in the tree that the checker makes.
  std::ptrdiff_t half = 1;
  while (2 * half < last - first) half *= 2;
  std::nth_element(first, first + half, last,
                   [&](auto s, auto t) { return centres[s][longest] < centres[t][longest]; });
  put_near(first, first + half, centres);
  put_near(first + half, last, centres);
}

std::vector<std::size_t> near_sequence(const std::vector<Box>& boxes, std::size_t dimension) {
  std::vector<std::vector<double>> centres;
  for (const Box& box : boxes) {
    centres.emplace_back();
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      centres.back().push_back(box.low[axis] / 2 + box.high[axis] / 2);
    }
  }
  std::vector<std::size_t> sequence(boxes.size());
  std::iota(sequence.begin(), sequence.end(), std::size_t{0});
  put_near(sequence.begin(), sequence.end(), centres);
  return sequence;
}

// The checker's boxes, which have no edges cut off. Where one goes on without end, it ends at the
// largest double, as all others do: the same ones meet.
std::vector<fast::AxisBox> axis_boxes(const std::vector<Box>& boxes) {
  constexpr double kFar = std::numeric_limits<double>::max();
  std::vector<fast::AxisBox> made(boxes.size());
  for (std::size_t s = 0; s < boxes.size(); ++s) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      made[s].low[axis] = std::clamp(boxes[s].low[axis], -kFar, kFar);
      made[s].high[axis] = std::clamp(boxes[s].high[axis], -kFar, kFar);
    }
  }
  return made;
}

}  // namespace

ComplexCertificate complex_certificate_of(const ExactMesh& mesh, ScaledPoints points) {
  ComplexCertificate made{.points = std::move(points)};
  made.order = lexicographic_order(made.points);
  made.incidences.resize(made.points.size());
  std::vector<Box> around_points;
  for (const Point& point : mesh.points.points()) around_points.push_back(box_around(point));
  const auto around = [&](Vertex v) { return around_points[static_cast<std::size_t>(v)]; };
  std::vector<Box> boxes;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    const Simplex& simplex = mesh.simplices[s];
    boxes.push_back(around(simplex[0]));
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      boxes.back() = box_around(boxes.back(), around(simplex[i]));
      made.incidences[static_cast<std::size_t>(simplex[i])] = {static_cast<std::uint32_t>(s), i};
    }
  }
  made.sequence = near_sequence(boxes, made.points.dimension);
  Partings partings(mesh, made.points);
  for (const Simplex& simplex : mesh.simplices) made.pads.push_back(partings.pads(simplex));
  made.partings.resize(mesh.simplices.size());
  fast::BoxTree(axis_boxes(boxes))
      .all_pairs(std::numeric_limits<std::size_t>::max(), [&](std::size_t s, std::size_t t) {
        if (s > t) std::swap(s, t);
        if (auto parting = partings.between(s, t)) made.partings[s].push_back(std::move(*parting));
        return true;
      });
  for (std::vector<Parting>& own : made.partings) {
    std::sort(own.begin(), own.end(),
              [](const Parting& a, const Parting& b) { return a.other < b.other; });
  }
  return made;
}

void write(std::ostream& out, const ExactMesh& mesh, const ComplexCertificate& certificate) {
  Lines lines(out);
  const bool some_unused = std::any_of(certificate.incidences.begin(), certificate.incidences.end(),
                                       [](const Incidence& incidence) { return !incidence.place; });
  write_first_line(lines, "circumspect-certificate 1", Claim::kComplex,
                   certificate.points.dimension, some_unused ? "unused" : "");
  write_scale(lines, certificate.points);
  begin_section(lines, "points", certificate.order.size());
  const std::vector<std::size_t> number = numbers_in(certificate.order);
  for (const Vertex v : certificate.order) {
    write_point(lines, certificate.points, v, false);
    const Incidence& incidence = certificate.incidences[static_cast<std::size_t>(v)];
    lines.gap() << incidence.simplex + 1;
    if (incidence.place) {
      lines << *incidence.place;
    } else {
      lines << "-";
    }
    lines << mesh.label(v);
    lines.end_line();
  }
  std::vector<std::size_t> place(certificate.sequence.size());
  for (std::size_t i = 0; i < place.size(); ++i) place[certificate.sequence[i]] = i + 1;
  lines << "simplices" << mesh.simplices.size() << mesh.simplices.front().size();
  lines.end_line();
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s) {
    for (const Vertex v : mesh.simplices[s]) lines << number[static_cast<std::size_t>(v)];
    lines.gap() << place[s];
    for (const std::vector<Integer>& pad : certificate.pads[s]) {
      lines.gap();
      for (const Integer& x : pad) lines << x;
    }
    for (const Parting& parting : certificate.partings[s]) {
      lines.gap() << parting.other + 1;
      for (const Integer& x : parting.normal) lines << x;
      lines << parting.offset;
    }
    lines.end_line();
  }
  begin_section(lines, "order", certificate.sequence.size());
  for (const std::size_t s : certificate.sequence) {
    lines << s + 1;
    lines.end_line();
  }
  lines << "end";
  lines.end_line();
}

}  // namespace circumspect::certificate
