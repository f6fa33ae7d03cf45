#include "oracle/model/witnesses.hpp"

#include "kernel/complex/circumball.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect {

void add_vertex_in_ball(const PointSet& points, Rule rule, const Simplex& simplex,
                        const std::optional<Simplex>& facet, Vertex q, Verdict& verdict) {
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
