// Point location by a conflict graph. Book: Section 5.4.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/exact/number.hpp"
#include "reference/delaunay/bowyer_watson.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/point_location.hpp"

namespace circumspect::delaunay {

// For each uninserted vertex, one simplex in conflict with it, and for each simplex the vertices
// that chose it. A vertex inside the triangulation is filed with a solid simplex that contains it,
// a vertex outside with a ghost simplex whose outer halfspace contains it, one on the boundary with
// either. In a weighted set a vertex is filed with any simplex in conflict with it, and with none
// once it is submerged; it stays submerged, because insertions only lower the hull.
class ConflictGraph {
 public:
  // Files every uninserted vertex, by looking at all simplices of the triangulation. The graph
  // keeps references to the points, the triangulation and the statistics.
  ConflictGraph(const PointSet& points, const SimplexDictionary& triangulation,
                const std::vector<Vertex>& uninserted, Statistics& statistics);

  // The simplex that an uninserted vertex is filed with; nothing if it is submerged.
  std::optional<Simplex> conflict_of(Vertex w) const;

  // Refiles the vertices that were filed with simplices that the insertion deleted. To be called
  // after each insertion.
  //
  // A vertex w is filed where a search through the deleted simplices in conflict with it leads: in
  // a new simplex, or in a ghost beyond the cavity. Each simplex that the search visits is one
  // conflict less, so all searches together take time proportional to the conflicts created.
  //
  // The search finds the new simplex that contains w. Let w be in a deleted solid simplex and
  // follow the ray from the inserted vertex u through w, onwards from w, until it leaves the cavity
  // through a facet: that facet's new simplex contains w. A simplex that the ray meets at a point x
  // on the way was deleted, so its ball holds u, and the closed ball holds x; hence the open ball
  // holds w, which lies between. If w is outside and the insertion takes it inside, then every
  // ghost simplex in conflict with w has been deleted; these are connected, and the ray goes
  // through one of them. If w stays outside, the ghost simplices in conflict with it, old and new,
  // are connected too, and a new one shares a ridge with an old one. With weights, the last
  // argument applies to all simplices: w stays in conflict with some simplex until it is submerged.
  void update(const Insertion& insertion);

 private:
  void file(Vertex w, const Simplex& simplex);
  bool is_conflict(const Simplex& simplex, Vertex w);
  bool has_room(const Simplex& simplex, Vertex w);
  std::optional<Simplex> search(Vertex w, const class Cavity& cavity, std::size_t start);

  const PointSet& points_;
  const SimplexDictionary& triangulation_;
  Statistics& statistics_;
  // Simplices by their vertices ascending: two simplices of a triangulation never share all of
  // them.
  struct Hash {
    std::size_t operator()(const Simplex& ascending) const;
  };
  std::unordered_map<Simplex, std::vector<Vertex>, Hash> filed_with_;
  std::vector<Simplex> conflict_of_;  // by vertex; empty: none
};

}  // namespace circumspect::delaunay
