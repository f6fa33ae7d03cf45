// The Bowyer–Watson algorithm: incremental insertion with ghost simplices. Book: Section 5.2.
#pragma once

#include <vector>

#include "reference/complex/dictionary.hpp"
#include "reference/complex/point_set.hpp"
#include "reference/complex/triangulation.hpp"

namespace circumspect::delaunay {

// The canonical (weighted) Delaunay triangulation of the points inserted so far, with its ghosts.
class BowyerWatson {
 public:
  // Starts with k+1 affinely independent points and a ghost simplex on each facet of theirs.
  // Requires: points.dimension() ≥ 1.
  explicit BowyerWatson(const PointSet& points);

  // The vertices that the start has inserted.
  const Simplex& first_simplex() const { return first_simplex_; }

  // Inserts u. In a weighted set u may be submerged: then nothing changes and false comes back.
  // Point location is a linear scan. Requires: u not inserted before.
  bool insert(Vertex u);

  // InsertVertex3D(u, vwxy) of the book, in any dimension.
  // Requires: the simplex is in the triangulation and in conflict with u.
  void insert(Vertex u, const Simplex& in_conflict);

  // The solid simplices.
  Triangulation triangulation() const;
  const SimplexDictionary& dictionary() const { return dictionary_; }

 private:
  void dig_cavity(Vertex u, std::vector<OrientedFacet> facets);

  const PointSet& points_;
  Simplex first_simplex_;
  SimplexDictionary dictionary_;
};

// Inserts all points in the order given by their indices. Any number of points, any dimension.
Triangulation bowyer_watson(const PointSet& points);

}  // namespace circumspect::delaunay
