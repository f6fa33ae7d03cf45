#include "oracle/check/domain/listed_faces.hpp"

#include <algorithm>
#include <array>

#include "reference/predicates/orientation.hpp"

namespace circumspect::check {
namespace {

bool is_flat(const Configuration& points, const Simplex& face) {
  if (face.size() < 3) return false;
  for (const std::array<std::size_t, 2> axes : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 2}}) {
    if (orientation(points, axes, face) != 0) return false;
  }
  return true;
}

bool judge_face(const Mesh& mesh, const Simplex& face, std::size_t ambient_dimension,
                Verdict& verdict) {
  const auto unknown =
      std::find_if(face.begin(), face.end(), [&](Vertex v) { return !mesh.points.names(v); });
  if (unknown != face.end()) {
    verdict.add(Rule::kUnknownVertex, {.simplices = {face}, .vertices = {*unknown}});
    return false;
  }
  if (face.size() < 2 || face.size() > ambient_dimension) {
    verdict.add(
        Rule::kWrongDimension,
        {.simplices = {face}, .values = {{"vertices", Rational(static_cast<long>(face.size()))}}});
    return false;
  }
  if (has_repeated_vertex(face)) {
    const Simplex ascending = sorted(face);
    verdict.add(Rule::kRepeatedVertex,
                {.simplices = {face},
                 .vertices = {*std::adjacent_find(ascending.begin(), ascending.end())}});
    return false;
  }
  if (is_flat(mesh.points.configuration(), face)) {
    verdict.add(Rule::kDegenerateSimplex, {.simplices = {face}});
    return false;
  }
  return true;
}

void cross_off(const Simplex& simplex, const std::vector<Simplex>& edges,
               std::vector<bool>& found) {
  for (std::size_t i = 0; i < simplex.size(); ++i) {
    for (std::size_t j = i + 1; j < simplex.size(); ++j) {
      const Simplex edge = {std::min(simplex[i], simplex[j]), std::max(simplex[i], simplex[j])};
      const auto at = std::lower_bound(edges.begin(), edges.end(), edge);
      if (at != edges.end() && *at == edge) {
        found[static_cast<std::size_t>(at - edges.begin())] = true;
      }
    }
  }
}

void add_stray(const MeshedDomain& in, const Simplex& face, Verdict& verdict) {
  const Point middle = barycentre(coordinates(in.mesh.points, face));
  const Where where = in.regions.locate(middle);
  const bool is_outside = where == Where::kOutside || where == Where::kHole;
  verdict.add(is_outside ? Rule::kOutside : Rule::kOverlap, {.simplices = {face}, .point = middle});
}

}  // namespace

bool is_facet(const std::vector<FacetUse>& uses, const Simplex& facet) {
  const auto found =
      std::lower_bound(uses.begin(), uses.end(), facet,
                       [](const FacetUse& use, const Simplex& f) { return use.facet < f; });
  return found != uses.end() && found->facet == facet;
}

bool is_piece(const std::vector<WallPiece>& pieces, const Simplex& facet) {
  const auto found =
      std::lower_bound(pieces.begin(), pieces.end(), facet,
                       [](const WallPiece& piece, const Simplex& f) { return piece.facet < f; });
  return found != pieces.end() && found->facet == facet;
}

std::vector<Simplex> edges_of_nothing(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                                      const std::vector<Simplex>& edges) {
  if (edges.empty()) return {};
  std::vector<bool> found(edges.size(), false);
  for (const Simplex& simplex : in.mesh.simplices) cross_off(simplex, edges, found);
  for (const WallPiece& piece : pieces) cross_off(piece.facet, edges, found);
  std::vector<Simplex> strays;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!found[e]) strays.push_back(edges[e]);
  }
  return strays;
}

bool judge_listed_faces(const Mesh& mesh, std::size_t ambient_dimension, Verdict& verdict) {
  bool sound = true;
  for (const Simplex& face : mesh.faces) {
    sound &= judge_face(mesh, face, ambient_dimension, verdict);
  }
  return sound;
}

void judge_stray_faces(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                       Verdict& verdict) {
  std::vector<Simplex> edges;
  for (const Simplex& listed : in.mesh.faces) {
    const Simplex face = sorted(listed);
    if (face.size() == in.complex.ambient_dimension()) {
      if (!is_facet(in.uses, face) && !is_piece(pieces, face)) add_stray(in, face, verdict);
    } else if (!in.chains.is_link(face[0], face[1])) {
      edges.push_back(face);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const Simplex& edge : edges_of_nothing(in, pieces, edges)) add_stray(in, edge, verdict);
}

}  // namespace circumspect::check
