#include "oracle/judge/domain/listed_faces.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

#include "kernel/complex/improper_intersection.hpp"
#include "kernel/complex/point_set.hpp"
#include "kernel/exact/each_once.hpp"
#include "kernel/piecewise_linear/cell_boxes.hpp"
#include "kernel/predicates/orientation.hpp"

namespace circumspect::check {

namespace {

bool is_flat(const Configuration& points, const Simplex& face) {
  if (face.size() < 3) return false;
  for (const std::array<std::size_t, 2> axes : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 2}}) {
    if (orientation(points, axes, face) != 0) return false;
  }
  return true;
}

bool judge_face(const ExactMesh& mesh, const Simplex& face, std::size_t ambient_dimension,
                Verdict& verdict) {
  const auto unknown =
      std::find_if(face.begin(), face.end(), [&](Vertex v) { return !mesh.points.names(v); });
  if (unknown != face.end()) {
    verdict.add(Rule::kUnknownVertex, {.simplices = {face}, .vertices = {*unknown}});
    return false;
  }
  if (face.size() < 2 || face.size() > ambient_dimension) {
    verdict.add(Rule::kWrongDimension,
                {.simplices = {face}, .values = {{"vertices", face.size()}}});
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

// Edges to be found among those of many simplices. They are ascending, so that those with one first
// end are beside each other; most vertices have none.
class SoughtEdges {
 public:
  // Requires: ascending, each with its ends ascending, of `vertices` vertices.
  SoughtEdges(const std::vector<Simplex>& edges, std::size_t vertices)
      : edges_(edges), from_(vertices + 1, 0), found_(edges.size(), false) {
    for (const Simplex& edge : edges) ++from_[VertexPlaces::place(edge[0]) + 1];
    std::partial_sum(from_.begin(), from_.end(), from_.begin());
  }

  void cross_off_those_of(const Simplex& simplex) {
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      for (std::size_t j = i + 1; j < simplex.size(); ++j) {
        const auto [u, v] = std::minmax(simplex[i], simplex[j]);
        const auto begin = edges_.begin() + from_[VertexPlaces::place(u)];
        const auto end = edges_.begin() + from_[VertexPlaces::place(u) + 1];
        if (begin == end) continue;
        const auto at = std::lower_bound(
            begin, end, v, [](const Simplex& edge, Vertex second) { return edge[1] < second; });
        if (at != end && (*at)[1] == v)
          found_[static_cast<std::size_t>(at - edges_.begin())] = true;
      }
    }
  }

  std::vector<Simplex> not_found() const {
    std::vector<Simplex> rest;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (!found_[e]) rest.push_back(edges_[e]);
    }
    return rest;
  }

 private:
  const std::vector<Simplex>& edges_;
  std::vector<std::ptrdiff_t> from_;  // where the edges of each first end begin
  std::vector<bool> found_;
};

// What listed faces may run into: the simplices, and the pieces of walls. Seldom wanted, so that
// what finds them is made when it is.
class Obstacles {
 public:
  Obstacles(const MeshedDomain& in, const std::vector<WallPiece>& pieces)
      : in_(in), pieces_(pieces) {}

  // The first one that meets a face in more than a common face, and the face itself before it; with
  // a point of both. The face and its barycentre alone if there is none.
  Witness witness(const Simplex& face) {
    const Box box = box_of(face);
    for (const Simplex& simplex : in_.mesh.simplices) {
      if (auto found = meeting(face, box, simplex)) return *found;
    }
    for (const WallPiece& piece : pieces_) {
      if (auto found = meeting(face, box, piece.facet)) return *found;
    }
    return {.simplices = {face}, .point = barycentre(in_.mesh.points, face)};
  }

 private:
  Box box_of(const Simplex& simplex) {
    if (!boxes_) boxes_.emplace(in_.mesh.points);
    return boxes_->of(simplex);
  }

  std::optional<Witness> meeting(const Simplex& face, const Box& box, const Simplex& other) {
    if (!may_meet(box, box_of(other))) return std::nullopt;
    const auto common = improper_intersection(in_.mesh.points, face, other);
    if (!common) return std::nullopt;
    return Witness{.simplices = {face, other}, .point = common};
  }

  const MeshedDomain& in_;
  const std::vector<WallPiece>& pieces_;
  std::optional<CellBoxes> boxes_;
};

void add_stray(const MeshedDomain& in, const Simplex& face, Obstacles& obstacles,
               Verdict& verdict) {
  const Point middle = barycentre(in.mesh.points, face);
  const Where where = in.regions.locate(middle);
  if (where == Where::kOutside || where == Where::kHole) {
    verdict.add(Rule::kOutside, {.simplices = {face}, .point = middle});
  } else if (verdict.keeps_more()) {
    verdict.add(Rule::kOverlap, obstacles.witness(face));
  } else {
    verdict.count(Rule::kOverlap);
  }
}

std::vector<Simplex> without_repetitions(std::vector<Simplex> simplices) {
  keep_each_once(simplices);
  return simplices;
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
  SoughtEdges sought(edges, in.mesh.points.size());
  for (const Simplex& simplex : in.mesh.simplices) sought.cross_off_those_of(simplex);
  for (const WallPiece& piece : pieces) sought.cross_off_those_of(piece.facet);
  return sought.not_found();
}

bool judge_listed_faces(const ExactMesh& mesh, std::size_t ambient_dimension, Verdict& verdict) {
  bool sound = true;
  for (const Simplex& face : mesh.faces) {
    sound &= judge_face(mesh, face, ambient_dimension, verdict);
  }
  return sound;
}

void judge_stray_faces(const MeshedDomain& in, const std::vector<WallPiece>& pieces,
                       Verdict& verdict) {
  Obstacles obstacles(in, pieces);
  std::vector<Simplex> dangling;
  std::vector<Simplex> edges;
  for (const Simplex& listed : in.mesh.faces) {
    const Simplex face = sorted(listed);
    if (face.size() < in.complex.ambient_dimension()) {
      edges.push_back(face);
    } else if (is_facet(in.uses, face)) {
      continue;
    } else if (is_piece(pieces, face)) {
      dangling.push_back(face);
    } else {
      add_stray(in, face, obstacles, verdict);
    }
  }
  for (const Simplex& edge : edges_of_nothing(in, pieces, without_repetitions(std::move(edges)))) {
    if (in.chains.is_link(edge[0], edge[1])) {
      dangling.push_back(edge);
    } else {
      add_stray(in, edge, obstacles, verdict);
    }
  }
  verdict.dangling = without_repetitions(std::move(dangling)).size();
}

}  // namespace circumspect::check
