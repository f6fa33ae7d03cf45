// The dictionary of unfinished facets. Book: Sections 3.11 and 5.6.
#pragma once

#include <set>
#include <vector>

#include "kernel/complex/simplex.hpp"

namespace circumspect {

// The facets of a growing triangulation that have a simplex on one side only ("maintains a
// dictionary of unfinished … facets"). Each is oriented so that its front is the side on which a
// simplex is missing. The facets on the boundary of the convex hull are among them until they are
// taken off.
class UnfinishedFacets {
 public:
  void add(const OrientedFacet& facet) { facets_.insert(facet); }
  void remove(const OrientedFacet& facet) { facets_.erase(facet); }
  bool empty() const { return facets_.empty(); }
  // The first in order of the vertices. Requires: not empty.
  OrientedFacet first() const { return *facets_.begin(); }
  std::vector<OrientedFacet> all() const { return {facets_.begin(), facets_.end()}; }

  // A simplex has been constructed: each of its facets finishes an unfinished one, or is unfinished
  // now on the side that the simplex is not on. Requires: the simplex is positively oriented.
  void adjoin(const Simplex& simplex);

 private:
  struct Order {
    bool operator()(const OrientedFacet& a, const OrientedFacet& b) const {
      return a.vertices != b.vertices ? a.vertices < b.vertices : a.reversed < b.reversed;
    }
  };
  std::set<OrientedFacet, Order> facets_;
};

}  // namespace circumspect
