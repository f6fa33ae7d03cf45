#include "oracle/judge/points/ball_witness.hpp"

#include "reference/kernel/complex/circumball.hpp"

namespace circumspect::check {

void add_in_ball(const ExactMesh& mesh, Rule rule, const Simplex& simplex,
                 const std::optional<Simplex>& facet, Vertex q, Verdict& verdict) {
  const Ball ball = circumball(mesh.points, simplex);
  const Rational depth = -power(mesh.points, ball, q);
  Witness witness{.simplices = {simplex}, .face = facet, .vertices = {q}, .ball = ball};
  witness.values = {
      {"squared distance from centre", squared_distance(mesh.points[q], ball.centre)}};
  if (mesh.points.is_weighted()) {
    witness.values.push_back({"weight of the vertex", mesh.points.weight(q)});
    witness.values.push_back({"squared radius of the orthoball", ball.squared_radius});
    witness.values.push_back({"squared radius less squared distance plus weight", depth});
  } else {
    witness.values.push_back({"squared radius", ball.squared_radius});
    witness.values.push_back({"squared radius less squared distance", depth});
  }
  // An orthoball may have no real radius to compare the depth with.
  if (sign(ball.squared_radius) > 0) {
    verdict.add(rule, witness, Rational(depth / ball.squared_radius));
  } else {
    verdict.add(rule, witness);
  }
}

}  // namespace circumspect::check
