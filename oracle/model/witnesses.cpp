#include "oracle/model/witnesses.hpp"

#include <array>

#include "kernel/complex/circumball.hpp"
#include "kernel/exact/triple.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect {
namespace {

using Arrow = Triple<Integer>;

// Is the depth of q in the ball of a tetrahedron, over the squared radius, at most some number? It
// uses integers, so that no fraction needs to be reduced. This is for meshes with many faults, most
// of them not the worst. The edges e_i from the first vertex p span the volume D and have the
// centre p + n / 2D with n = Σ |e_i|² e_j × e_k. With w = q − p the depth is w·n / D − |w|², and
// the squared radius |n|² / 4D².
bool is_at_most_so_deep(const Configuration& points, const Simplex& simplex, Vertex q,
                        const Rational& limit) {
  const auto from_first = [&](Vertex v) {
    Arrow arrow;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      arrow[axis] = points.numerator(v, axis) - points.numerator(simplex[0], axis);
    }
    return arrow;
  };
  const std::array<Arrow, 3> edges = {from_first(simplex[1]), from_first(simplex[2]),
                                      from_first(simplex[3])};
  Arrow n;
  Integer volume;
  for (std::size_t i = 0; i < 3; ++i) {
    const Arrow normal = cross_product(edges[(i + 1) % 3], edges[(i + 2) % 3]);
    const Integer length = inner_product(edges[i], edges[i]);
    for (std::size_t axis = 0; axis < 3; ++axis) add_product(n[axis], length, normal[axis]);
    if (i == 0) volume = inner_product(edges[0], normal);
  }
  const Arrow w = from_first(q);
  Integer depth = inner_product(w, n);  // times the volume
  subtract_product(depth, volume, inner_product(w, w));
  return 4 * volume * depth * limit.get_den() <= limit.get_num() * inner_product(n, n);
}

// Would a witness be dropped, and has the rule already been broken at least as badly?
bool adds_to_count_only(const PointSet& points, Rule rule, const Simplex& simplex, Vertex q,
                        const Verdict& verdict) {
  if (verdict.keeps_more() || points.is_weighted() ||
      !points.configuration().has_common_denominator() || points.ambient_dimension() != 3 ||
      simplex.size() != 4) {
    return false;
  }
  const auto tally = verdict.tallies().find(rule);
  return tally != verdict.tallies().end() && tally->second.worst_margin &&
         is_at_most_so_deep(points.configuration(), simplex, q, *tally->second.worst_margin);
}

}  // namespace

void add_vertex_in_ball(const PointSet& points, Rule rule, const Simplex& simplex,
                        const std::optional<Simplex>& facet, Vertex q, Verdict& verdict) {
  if (adds_to_count_only(points, rule, simplex, q, verdict)) {
    verdict.count(rule, std::nullopt, with_apex(simplex, q));
    return;
  }
  const Ball ball = circumball(points, simplex);
  const Rational depth = -power(points, ball, q);
  Witness witness{.simplices = {simplex}, .face = facet, .vertices = {q}, .ball = ball};
  witness.values = {{"squared distance from centre", squared_distance(points[q], ball.centre)}};
  if (points.is_weighted()) {
    witness.values.push_back({"weight of the vertex", points.weight(q)});
    witness.values.push_back({"squared radius of the orthoball", ball.squared_radius});
    witness.values.push_back({"squared radius less squared distance plus weight", depth});
  } else {
    witness.values.push_back({"squared radius", ball.squared_radius});
    witness.values.push_back({"squared radius less squared distance", depth});
  }
  // An orthoball may have no real radius to compare the depth with.
  const bool has_radius = sign(ball.squared_radius) > 0;
  verdict.add(rule, witness,
              has_radius ? std::optional<Rational>(depth / ball.squared_radius) : std::nullopt);
}

Witness vertex_beyond_facet(const PointSet& points, const Simplex& simplex, const Simplex& facet,
                            Vertex apex, Vertex q) {
  const Configuration& all = points.configuration();
  Witness witness{.simplices = {simplex}, .face = facet, .vertices = {q}};
  witness.values = {{"orientation determinant of facet and own apex",
                     orientation_determinant(all, all.axes(), with_apex(facet, apex))},
                    {"orientation determinant of facet and vertex beyond",
                     orientation_determinant(all, all.axes(), with_apex(facet, q))}};
  return witness;
}

}  // namespace circumspect
