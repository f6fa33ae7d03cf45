// The Bowyer–Watson algorithm: incremental insertion with ghost simplices. Book: Section 5.2;
// orders of insertion and point location in Sections 5.3 to 5.5.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "kernel/complex/point_set.hpp"
#include "kernel/complex/triangulation.hpp"
#include "kernel/exact/progress.hpp"
#include "reference/delaunay/dictionary.hpp"
#include "reference/delaunay/insertion_order.hpp"
#include "reference/delaunay/point_location.hpp"

namespace circumspect::delaunay {

// The changes by the insertion of one vertex, including ghosts; all simplices are positively
// oriented.
struct Insertion {
  Vertex vertex = kGhost;  // the ghost for the start, which inserts a whole simplex
  // The simplices that were in conflict with the vertex: their union is the cavity.
  // The first is that in which point location found it.
  std::vector<Simplex> deleted;
  // One for each facet of the cavity, with the vertex as its apex.
  std::vector<Simplex> created;
};

// The first k+1 affinely independent vertices of a sequence, k the dimension of the set, with which
// incremental insertion starts. Requires: the sequence has that many.
Simplex first_independent(const PointSet& points, const std::vector<Vertex>& sequence);

// The canonical (weighted) Delaunay triangulation of the points inserted so far, with its ghosts.
class BowyerWatson {
 public:
  // Starts with a simplex and a ghost simplex on each of its facets; if none is given, with the
  // first k+1 affinely independent points. With a conflict test other than the canonical one, it
  // makes another Delaunay triangulation. Requires: points.dimension() = k ≥ 1; first_simplex has
  // k+1 affinely independent vertices.
  explicit BowyerWatson(const PointSet& points);
  BowyerWatson(const PointSet& points, const Simplex& first_simplex,
               ConflictTest conflict_test = is_in_conflict);

  // The vertices that the start has inserted.
  const Simplex& first_simplex() const { return first_simplex_; }

  // Inserts u. In a weighted set u may be submerged: then it returns false and changes nothing.
  // Vertices that u submerges vanish. Point location is a linear scan. Requires: u not inserted
  // before.
  bool insert(Vertex u);

  // InsertVertex3D(u, vwxy) of the book, in any dimension. The answer holds until the next
  // insertion. Requires: the simplex is in the triangulation and in conflict with u.
  const Insertion& insert(Vertex u, const Simplex& in_conflict);

  // The solid simplices.
  Triangulation triangulation() const;
  const SimplexDictionary& dictionary() const { return dictionary_; }

  // The solid simplex created last.
  const Simplex& most_recent_solid() const { return most_recent_solid_; }
  const Insertion& last_insertion() const { return last_insertion_; }

  // Point location counts in the same place.
  const Statistics& statistics() const { return statistics_; }
  Statistics& statistics() { return statistics_; }

 private:
  bool is_conflict(const Simplex& simplex, Vertex u);
  void dig_cavity(Vertex u);
  void add(Simplex simplex);
  void remove(const Simplex& simplex);

  const PointSet& points_;
  ConflictTest conflict_test_;
  Simplex first_simplex_;
  SimplexDictionary dictionary_;
  Simplex most_recent_solid_;
  Insertion last_insertion_ = {};
  std::vector<OrientedFacet> facets_to_pass_;
  Statistics statistics_;
};

enum class PointLocation {
  kLinearScan,     // Section 5.2 leaves it open
  kConflictGraph,  // Section 5.4
  kWalking,        // Section 5.5
};

struct BowyerWatsonOptions {
  InsertionOrder order = InsertionOrder::kAsGiven;
  PointLocation location = PointLocation::kLinearScan;
  std::uint64_t seed = 0;  // of the random orders
  Progress progress = {};
  std::function<void(const Insertion&)> watch = {};  // called for the start and each insertion
};

// Inserts all points. Any number of points, any dimension; one answer, whatever the options.
Triangulation bowyer_watson(const PointSet& points, const BowyerWatsonOptions& options,
                            Statistics* statistics = nullptr);

// In the order of their indices.
Triangulation bowyer_watson(const PointSet& points);

}  // namespace circumspect::delaunay
