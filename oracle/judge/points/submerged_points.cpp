#include "oracle/judge/points/submerged_points.hpp"

#include <optional>

#include "oracle/judge/points/ball_witness.hpp"
#include "oracle/judge/points/simplices.hpp"
#include "reference/kernel/exact/point_search.hpp"
#include "reference/kernel/predicates/in_ball.hpp"
#include "reference/kernel/predicates/orientation.hpp"

namespace circumspect::check {
namespace {

// A mesh as the search for points wants it.
class Located {
 public:
  Located(const ExactMesh& mesh, const std::vector<FacetUse>& uses)
      : mesh_(mesh),
        row_size_(mesh.simplices.front().size()),
        across_(mesh.simplices.size() * row_size_, kNoSimplex) {
    own_.reserve(mesh.simplices.size());
    for (const Simplex& simplex : mesh.simplices) {
      own_.push_back(orientation(mesh.points.configuration(), simplex));
    }
    for_each_facet(uses, [&](std::span<const FacetUse> group) {
      if (group.size() != 2) return;
      across_[group[0].simplex * row_size_ + group[0].opposite] = group[1].simplex;
      across_[group[1].simplex * row_size_ + group[1].opposite] = group[0].simplex;
    });
  }

  std::size_t size() const { return mesh_.simplices.size(); }
  std::size_t row_size() const { return row_size_; }
  std::size_t points() const { return mesh_.points.size(); }
  std::size_t vertex(std::size_t s, std::size_t place) const {
    return static_cast<std::size_t>(mesh_.simplices[s][place]);
  }
  int side(std::size_t s, std::size_t place, std::size_t point) const {
    const Simplex moved =
        with_vertex_replaced(mesh_.simplices[s], place, static_cast<Vertex>(point));
    return orientation(mesh_.points.configuration(), moved) * own_[s];
  }
  std::size_t across(std::size_t s, std::size_t place) const {
    return across_[s * row_size_ + place];
  }

 private:
  const ExactMesh& mesh_;
  std::size_t row_size_;
  std::vector<std::size_t> across_;  // the facet opposite each vertex of each simplex
  std::vector<int> own_;             // the orientation of each simplex
};

}  // namespace

std::uint64_t judge_submerged_points(const ExactMesh& mesh, const std::vector<FacetUse>& uses,
                                     Verdict& verdict, Ambiguity& ambiguity) {
  const std::vector<Vertex> unused = unused_points(mesh);
  if (unused.empty() || mesh.simplices.empty()) return 0;
  const Located located(mesh, uses);
  PointSearch search(located);
  const std::vector<std::size_t> places(unused.begin(), unused.end());
  const std::vector<std::size_t> simplices = search.simplices_with(places);
  for (std::size_t i = 0; i < unused.size(); ++i) {
    const Vertex q = unused[i];
    if (simplices[i] == kNoSimplex) {
      verdict.add(Rule::kUnusedPoint, {.vertices = {q}, .point = mesh.points[q]});
      continue;
    }
    const Simplex& simplex = mesh.simplices[simplices[i]];
    const int side = in_ball(mesh.points.configuration(), simplex, q);
    ambiguity.see(mesh.points, simplex, q, side);
    if (side > 0) add_in_ball(mesh, Rule::kPointBelowPlane, simplex, std::nullopt, q, verdict);
  }
  return search.work();
}

}  // namespace circumspect::check
